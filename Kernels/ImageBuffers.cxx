#include "ImageBuffers.h"

#include "Parallel.h"

#include <algorithm>

namespace rtg
{

namespace
{

constexpr std::size_t wordsPerPixel = 4; ///< color, depth, id of the set, id of the glyph

// A pixel of nothing.
const std::uint32_t emptyWords[wordsPerPixel] = { 0u, glm::floatBitsToUint(1.0f), Image::noGlyph, Image::noGlyph };

} // namespace

void ImageBuffers::Prepare(Device::State& device, const TraceSettings& settings, bool keepSums)
{
  this->pixels_ = std::size_t(settings.width) * settings.height;
  const std::size_t bytes = wordsPerPixel * this->pixels_ * sizeof(std::uint32_t);
  this->words_.Fit(device, bytes);
  if (!this->words_.Mapped())
  {
    this->shown_.Fit(device, bytes, Buffer::Place::Host);
  }
  this->sums_.Fit(device, (keepSums ? this->pixels_ : 1) * sizeof(device::PixelSums));
  if (!settings.features)
  {
    this->features_ = Buffer();
  }
  else
  {
    this->features_.Fit(device, this->pixels_ * sizeof(device::PixelFeatures));
    this->features_.Fill(0, this->pixels_ * sizeof(device::PixelFeatures), 0);
  }
}

void ImageBuffers::Clear()
{
  const std::size_t bytes = this->pixels_ * sizeof(std::uint32_t);
  for (std::size_t i = 0; i < wordsPerPixel; ++i)
  {
    this->words_.Fill(i * bytes, bytes, emptyWords[i]);
  }
}

void ImageBuffers::ClearSums()
{
  const std::size_t bytes = this->pixels_ * sizeof(device::PixelSums);
  if (this->sums_.Size() >= bytes)
  {
    this->sums_.Fill(0, bytes, 0);
  }
}

void ImageBuffers::Fill(device::FrameRecord& frame) const
{
  const std::size_t bytes = this->pixels_ * sizeof(std::uint32_t);
  frame.color = this->words_.Address();
  frame.depth = frame.color + bytes;
  frame.setIds = frame.depth + bytes;
  frame.glyphIds = frame.setIds + bytes;
  frame.sums = this->sums_.Address();
  frame.features = this->features_.Address();
}

void ImageBuffers::Show(Image& image)
{
  if (!this->words_.Mapped())
  {
    this->words_.CopyTo(this->shown_, wordsPerPixel * this->pixels_ * sizeof(std::uint32_t));
  }
  const void* place = this->words_.Mapped() ? this->words_.Mapped() : this->shown_.Mapped();
  const auto* words = static_cast<const std::uint32_t*>(place);
  image.color = image.traced = words;
  image.depth = reinterpret_cast<const float*>(words + this->pixels_);
  image.setIds = words + 2 * this->pixels_;
  image.glyphIds = words + 3 * this->pixels_;
}

ImageFeatures ImageBuffers::Features(const Image& image) const
{
  ImageFeatures features{ image.width, image.height, std::vector<glm::vec3>(this->pixels_, glm::vec3(0.0f)),
    std::vector<glm::vec3>(this->pixels_, glm::vec3(0.0f)), std::vector<float>(this->pixels_, 0.0f) };
  this->features_.Read(this->pixels_ * sizeof(device::PixelFeatures),
    [&](const void* read)
    {
      const auto* sums = static_cast<const device::PixelFeatures*>(read);
      ParallelEach(this->pixels_,
        [&](std::size_t i)
        {
          if (sums[i].hits > 0.0f)
          {
            const float length = glm::length(sums[i].normal);
            features.normals[i] = length > 0.0f ? sums[i].normal / length : glm::vec3(0.0f);
            features.albedos[i] = sums[i].albedo / sums[i].hits;
            features.viewDepths[i] = sums[i].depth / sums[i].hits;
          }
        });
    });
  return features;
}

std::vector<glm::vec4> ImageBuffers::Means(std::uint32_t samples, std::vector<float>* missingLight) const
{
  std::vector<glm::vec4> means(this->pixels_);
  this->sums_.Read(this->pixels_ * sizeof(device::PixelSums),
    [&](const void* read)
    {
      const auto* sums = static_cast<const device::PixelSums*>(read);
      std::transform(sums, sums + this->pixels_, means.begin(),
        [samples](const device::PixelSums& sum)
        { return glm::vec4(sum.color, sum.opacity) / static_cast<float>(samples); });
      if (missingLight)
      {
        missingLight->resize(this->pixels_);
        std::transform(sums, sums + this->pixels_, missingLight->begin(),
          [samples](const device::PixelSums& sum) { return sum.missing / static_cast<float>(samples); });
      }
    });
  return means;
}

} // namespace rtg
