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
  // The ground is a white surface whose light is what it lacks. Its depth, which no glyph has, tells it from glyphs.
  constexpr float groundDepth = 0.0f;
  for (std::size_t i = 0; i < this->missingLight_.size(); ++i)
  {
    if (this->image_.normals[i] == glm::vec3(0.0f))
    {
      this->image_.normals[i] = this->settings_.groundNormal;
      this->image_.albedos[i] = glm::vec3(1.0f);
      this->image_.viewDepths[i] = groundDepth;
      this->means_[i] = glm::vec4(glm::vec3(this->missingLight_[i]), 1.0f);
    }
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
    const bool onGround = !this->missingLight_.empty() && this->image_.viewDepths[i] == groundDepth;
    glm::vec4 shown(0.0f);
    if (mean.a > 0.0f && !onGround)
    {
      const glm::vec3 color = glm::vec3(mean) / mean.a;
      shown = glm::vec4(mapsTones ? shading::ToneMap(color, linear, exposureFactor, toneMapping) : color, mean.a);
    }
    if (!this->missingLight_.empty())
    {
      shown = shading::OverShadow(shown, onGround ? mean.r : this->missingLight_[i], linear);
    }
    smooth[i] = glm::packUnorm4x8(shown);
  }
  this->shared_->denoiseSeconds += watch.Lap();
  return smooth;
}

} // namespace rtg
