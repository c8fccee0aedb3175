// The uniforms of the device's programs for an image.
#pragma once

#include "HostDevice.h"
#include "SceneState.h"
#include "Tracer.h"
#include "Vulkan/Pipeline.h"

#include <vector>

namespace rtg
{

/// Throws rtg::Error, which names the first setting that is out of its range.
void CheckSettings(const TraceSettings& settings);

/// Whether tone mapping changes colors.
bool MapsTones(const TraceSettings& settings);

/// A position as a sum of two floats.
void Split(const glm::dvec3& exact, glm::vec3& high, glm::vec3& low);

/// `origin`: of the scene, in world coordinates.
void FillCamera(device::FrameRecord& frame, const Camera& camera, const glm::dvec3& origin);
std::vector<device::LightRecord> MakeLights(const std::vector<Light>& lights, const glm::dvec3& origin);
/// Fills in all settings but the samples, which are those of one dispatch, and times.
void FillSettings(device::FrameRecord& frame, const TraceSettings& settings, const glm::dvec3& origin);

/// Values of the scene.
void FillConstants(Constants& constants, const SceneRecords& scene);
/// The program for an image of a pass, in so many lights.
Specialization
SpecializationFor(const SceneRecords& scene, std::size_t lights, const TraceSettings& settings, Pass pass);
/// The scene must have a visible set.
void FillScene(device::FrameRecord& frame, const SceneRecords& scene);

/// Samples a pixel in one dispatch at most: a driver resets a GPU whose dispatch takes seconds.
std::uint32_t SamplesAtOnce(const TraceSettings& settings, std::size_t pixels);
/// Samples a pixel in the first dispatch on a CPU, while the cost of a sample is unknown, and in any later one at
/// least.
std::uint32_t SamplesAtFirst(const TraceSettings& settings);

/// How many binary digits of the time in the shutter's opening are common to all pixels in one sample, so that
/// neighboring rays see the same slice of time: as many as there are slices and planned samples fill alike.
std::uint32_t SharedTimeBits(const TraceSettings& settings, std::uint32_t sliceBits);

/// The parts of the shutter's opening that local shading gives one sample each, and the step from one sample's part to
/// the next one's (Shading/ShutterTime.glsl); no parts: other times.
void FillTimeStrata(device::FrameRecord& frame, const TraceSettings& settings);

} // namespace rtg
