// Images that fail: without a device, with one that was lost, without memory.
#include "ProgressiveImageFixture.h"

namespace rtg::testing
{

TEST_F(ProgressiveImageTest, AnImageOfTheSceneFailsUntilItsContentChangesOrMemoryIsFreed)
{
  this->source.sceneFails = true;
  EXPECT_EQ(this->Update(Script(1)), nullptr);
  EXPECT_EQ(this->image.GetState(), State::Failed);
  EXPECT_EQ(this->image.GetFailure().cause, ProgressiveImage::Cause::Scene);
  EXPECT_EQ(this->image.Progress(), 1.0);
  this->source.sceneFails = false;
  this->view.settings.width /= 2;
  EXPECT_EQ(this->Update(Script(1)), nullptr);
  this->source.bytes = 50;
  EXPECT_NE(this->Update(Script(1)), nullptr);

  this->source.sceneFails = true;
  this->view.sceneVersion = 1;
  EXPECT_EQ(this->Update(Script(1)), nullptr);
  this->source.sceneFails = false;
  this->view.sceneVersion = 2;
  EXPECT_NE(this->Update(Script(1)), nullptr);
}

TEST_F(ProgressiveImageTest, ATraceFailsUntilSizeLightSamplesContentOrMemoryChange)
{
  const auto fail = [this]
  {
    this->source.traceFails = true;
    this->view.camera.eye.y += 1.0;
    EXPECT_EQ(this->Update(Script(8)), nullptr);
    EXPECT_EQ(this->image.GetFailure().cause, ProgressiveImage::Cause::Image);
    this->source.traceFails = false;
    EXPECT_EQ(this->Update(Script(8)), nullptr) << "the same image is tried again";
  };
  fail();
  this->view.settings.width /= 2;
  EXPECT_NE(this->Update(Script(8)), nullptr);
  fail();
  this->view.settings.shading = rtg::Shading::Local;
  EXPECT_NE(this->Update(Script(8)), nullptr);
  fail();
  EXPECT_NE(this->Update(Script(4)), nullptr);
  fail();
  this->source.bytes -= 1;
  EXPECT_NE(this->Update(Script(8)), nullptr);
  fail();
  this->view.sceneVersion += 1;
  EXPECT_NE(this->Update(Script(8)), nullptr);
}

TEST_F(ProgressiveImageTest, ALostDeviceIsReplacedOnce)
{
  this->source.loseDevice = true;
  EXPECT_EQ(this->Update(Script(4)), nullptr);
  EXPECT_EQ(this->image.GetFailure().cause, ProgressiveImage::Cause::Device);
  this->source.loseDevice = true;
  EXPECT_EQ(this->Update(Script(4)), nullptr);
  EXPECT_EQ(this->source.traces, 2);
  EXPECT_EQ(this->Update(Script(4)), nullptr);
  EXPECT_EQ(this->source.traces, 2) << "a device that was lost twice is tried a third time";
  this->view.sceneVersion = 1;
  EXPECT_NE(this->Update(Script(4)), nullptr);
  // After an image a loss is an accident again.
  this->view.sceneVersion = 2;
  this->source.loseDevice = true;
  EXPECT_EQ(this->Update(Script(4)), nullptr);
  EXPECT_NE(this->Update(Script(4)), nullptr);
}

TEST_F(ProgressiveImageTest, SamplesOnALostDeviceAreGone)
{
  this->Update(Window(64));
  this->source.hasDevice = false; // another view's image lost it
  this->Finish(Window(64));
  EXPECT_EQ(this->image.GetState(), State::Finished);
  EXPECT_EQ(this->image.Samples(), 64u);
}

TEST_F(ProgressiveImageTest, NoDeviceIsAskedForAgainWithOtherContent)
{
  this->source.noDevice = true;
  EXPECT_EQ(this->Update(Script(1)), nullptr);
  EXPECT_EQ(this->image.GetFailure().cause, ProgressiveImage::Cause::Device);
  this->source.noDevice = false;
  EXPECT_EQ(this->Update(Script(1)), nullptr);
  this->view.sceneVersion = 1;
  EXPECT_NE(this->Update(Script(1)), nullptr);
}

TEST_F(ProgressiveImageTest, LackOfMemoryIsAFailureInWords)
{
  this->source.memoryFails = true;
  EXPECT_EQ(this->Update(Script(1)), nullptr);
  EXPECT_NE(this->image.GetFailure().message.find("memory"), std::string::npos);
  EXPECT_EQ(this->image.GetFailure().cause, ProgressiveImage::Cause::Memory);
  EXPECT_EQ(this->image.Progress(), 1.0) << "a window would render for ever";
  // Memory may be free again at any time; a turning camera does not ask for it with each picture.
  this->source.memoryFails = false;
  ImageEffort turning = Window(1);
  turning.preview = true;
  EXPECT_EQ(this->Update(turning), nullptr);
  EXPECT_NE(this->Update(Script(1)), nullptr);
}

} // namespace rtg::testing
