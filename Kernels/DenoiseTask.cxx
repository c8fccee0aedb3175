#include "Denoiser.h"
#include "Frame.h"
#include "Shading/Shading.h"
#include "Stopwatch.h"
#include "Tracer.h"
#include "TracerResources.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>

namespace rtg
{

std::vector<std::uint32_t> DenoiseTask::operator()()
{
  Stopwatch watch;
  const bool linear = TraitsOf(this->settings_).linear;
  if (linear)
  {
    std::transform(
      this->image_.albedos.begin(), this->image_.albedos.end(), this->image_.albedos.begin(), shading::DisplayToLinear);
  }
  rtg::Denoise(this->means_,
    { this->image_.width, this->image_.height, this->image_.normals, this->image_.albedos, this->image_.viewDepths },
    this->stop_);

  const bool mapsTones = MapsTones(this->settings_);
  const float exposureFactor = std::exp2(this->settings_.exposure);
  const auto toneMapping = static_cast<std::uint32_t>(this->settings_.toneMapping);
  std::vector<std::uint32_t> smooth(this->means_.size(), 0);
  for (std::size_t i = 0; i < smooth.size(); ++i)
  {
    const glm::vec4& mean = this->means_[i];
    if (mean.a > 0.0f)
    {
      const glm::vec3 colour = glm::vec3(mean) / mean.a;
      smooth[i] = glm::packUnorm4x8(
        glm::vec4(mapsTones ? shading::ToneMap(colour, linear, exposureFactor, toneMapping) : colour, mean.a));
    }
  }
  this->shared_->denoiseSeconds += watch.Lap();
  return smooth;
}

} // namespace rtg
