// An image on the device, and its copy on the host.
#pragma once

#include "HostDevice.h"
#include "Tracer.h"
#include "Vulkan/Buffer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtg
{

class ImageBuffers
{
public:
  /// Makes those that an image needs; the others are given back.
  void Prepare(Device::State& device, const TraceSettings& settings, bool keepSums);

  /// An image of nothing.
  void Clear();
  /// Sums, where there are any, of samples that all hit nothing.
  void ClearSums();

  /// Writes their addresses into the frame's record.
  void Fill(device::FrameRecord& frame) const;

  /// Lets the image point at its pixels, where the host can read them.
  void Show(Image& image);

  ImageFeatures Features(const Image& image) const;

  /// Tracer::Means() of sums of so many samples, and of the same sums, if wanted, the light missing on the ground, as a
  /// fraction of all light in the pixel.
  std::vector<glm::vec4> Means(std::uint32_t samples, std::vector<float>* missingLight) const;

private:
  std::size_t pixels_ = 0;
  Buffer words_;           ///< colors, depths, ids of sets, ids of glyphs, one word a pixel each
  Buffer shown_;           ///< a copy of them for the host, none on a device that shares its memory
  Buffer sums_, features_; ///< none unless requested
};

} // namespace rtg
