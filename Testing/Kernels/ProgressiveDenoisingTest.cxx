// Which images are denoised, and when.
#include "ProgressiveImageFixture.h"

namespace rtg::testing
{

TEST_F(ProgressiveImageTest, GrowingImagesAreDenoisedAndFinishedOnesNotUnlessAlways)
{
  ImageEffort effort = Script(8);
  effort.samplesAtOnce = 2;
  effort.denoising = Denoising::WhileGrowing;
  this->Update(effort);
  EXPECT_EQ(this->image.GetImage().color[0], 2u);
  this->Finish(effort);
  EXPECT_EQ(this->image.GetImage().color[0], 7u);

  effort.denoising = Denoising::Always;
  this->Update(effort);
  EXPECT_EQ(this->image.GetImage().color[0], 8u);
  EXPECT_EQ(this->image.GetState(), State::Finished);
}

TEST_F(ProgressiveImageTest, AMoveOfTheCameraStopsTheDenoisingOfWhatItLeaves)
{
  this->source.denoisingSeconds = std::chrono::seconds(20);
  this->Update(Window(64));
  ASSERT_EQ(this->source.denoisings, 1);
  EXPECT_EQ(this->source.denoisingsStopped, 0);
  this->view.camera.eye.x += 1.0;
  ImageEffort turning = Window(64);
  turning.preview = true;
  ASSERT_NE(this->Update(turning), nullptr) << this->image.GetFailure().message;
  EXPECT_EQ(this->source.denoisingsStopped, 1);
}

TEST_F(ProgressiveImageTest, AFinishedImageIsTracedAnewForTheDenoiser)
{
  ImageEffort effort = Script(4);
  this->Update(effort);
  effort.denoising = Denoising::WhileGrowing;
  this->Update(effort);
  EXPECT_EQ(this->source.traces, 1);
  effort.denoising = Denoising::Always;
  this->Update(effort);
  EXPECT_EQ(this->image.GetImage().color[0], 4u);
  this->Update(effort);
  EXPECT_EQ(this->source.traces, 2);
}

TEST_F(ProgressiveImageTest, LocalLightHasNoNoiseToTakeAway)
{
  this->view = View(rtg::Shading::Local);
  ImageEffort effort = Window(8);
  effort.denoising = Denoising::Always;
  this->Finish(effort);
  EXPECT_EQ(this->source.denoisings, 0);
  EXPECT_FALSE(this->source.last.features);
  effort.features = true; // as scripts ask for, which wait for the end
  this->Update(effort);
  this->Update(effort);
  EXPECT_EQ(this->image.GetState(), State::Finished);
}

TEST_F(ProgressiveImageTest, FeaturesOfAFinishedImageAreTracedWhereTheyLack)
{
  this->Update(Script(4));
  ImageEffort effort = Script(4);
  effort.features = true;
  this->Update(effort);
  EXPECT_TRUE(this->source.last.features);
  EXPECT_EQ(this->source.traces, 2);
  this->Update(effort);
  EXPECT_EQ(this->source.traces, 2);
}

} // namespace rtg::testing
