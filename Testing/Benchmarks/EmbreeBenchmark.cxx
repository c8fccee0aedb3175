// Rays per second and core of our tracer beside Embree's, on the same spheres and the same primary rays.
// Usage: EmbreeBenchmark SPHERES.vtk [PIXELS] [REPETITIONS]      (SPHERES.vtk from Data/spheres_280k.py)
//
// Embree: user geometry, one ray per call, one thread, centre-subtracted float quadratic, no shading. Ours: a whole
// image with local shading, depth and ids through the Vulkan pipeline, on all cores, divided by processor time.
// Both walk the image in tiles of 8 x 8 pixels.
#include "Camera.h"
#include "Files.h"
#include "Measures.h"
#include "Scene.h"
#include "Tracer.h"
#include "Vulkan/Device.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

namespace
{

using benchmark::Spheres;

double WallSeconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void SphereBounds(const RTCBoundsFunctionArguments* arguments)
{
  const auto& spheres = *static_cast<const Spheres*>(arguments->geometryUserPtr);
  const glm::vec3 centre = spheres.centres[arguments->primID];
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = centre.x - spheres.radius;
  bounds.lower_y = centre.y - spheres.radius;
  bounds.lower_z = centre.z - spheres.radius;
  bounds.upper_x = centre.x + spheres.radius;
  bounds.upper_y = centre.y + spheres.radius;
  bounds.upper_z = centre.z + spheres.radius;
}

void SphereIntersect(const RTCIntersectFunctionNArguments* arguments)
{
  if (arguments->valid[0] == 0)
  {
    return;
  }
  const auto& spheres = *static_cast<const Spheres*>(arguments->geometryUserPtr);
  auto& ray = reinterpret_cast<RTCRayHit*>(arguments->rayhit)->ray;
  auto& hit = reinterpret_cast<RTCRayHit*>(arguments->rayhit)->hit;

  // Nearest point of the ray to the centre first: stable far from the sphere.
  const glm::vec3 origin(ray.org_x, ray.org_y, ray.org_z),
    direction(ray.dir_x, ray.dir_y, ray.dir_z);
  const glm::vec3 toCentre = spheres.centres[arguments->primID] - origin;
  const float directionSquared = glm::dot(direction, direction);
  const float middle = glm::dot(toCentre, direction) / directionSquared;
  const glm::vec3 offset = toCentre - middle * direction;
  const float discrim = spheres.radius * spheres.radius - glm::dot(offset, offset);
  if (discrim < 0.0f)
  {
    return;
  }
  const float half = std::sqrt(discrim / directionSquared);
  const float t = middle - half >= ray.tnear ? middle - half : middle + half;
  if (t < ray.tnear || t >= ray.tfar)
  {
    return;
  }

  ray.tfar = t;
  const glm::vec3 normal = t * direction - toCentre;
  hit.Ng_x = normal.x;
  hit.Ng_y = normal.y;
  hit.Ng_z = normal.z;
  hit.primID = arguments->primID;
  hit.geomID = arguments->geomID;
  hit.instID[0] = arguments->context->instID[0];
}

struct Result
{
  std::vector<float> depth; // view depth by pixel, bottom row first; infinity: nothing hit
  double wall = std::numeric_limits<double>::infinity(); // seconds, best of the repetitions
  double cpu = std::numeric_limits<double>::infinity();
  double build = 0.0; // wall seconds
};

Result
TraceWithEmbree(const Spheres& spheres, const rtg::Camera& camera, int pixels, int repetitions)
{
  Result result;
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(spheres.centres.size()));
  rtcSetGeometryUserData(geometry, const_cast<Spheres*>(&spheres));
  rtcSetGeometryBoundsFunction(geometry, SphereBounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, SphereIntersect);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  const double buildStart = WallSeconds();
  rtcCommitScene(scene);
  result.build = WallSeconds() - buildStart;

  result.depth.resize(static_cast<std::size_t>(pixels) * pixels);
  const int tiles = (pixels + 7) / 8;
  for (int repetition = 0; repetition < repetitions; ++repetition)
  {
    const double wall = WallSeconds(), cpu = benchmark::CpuSeconds();
    for (int tile = 0; tile < tiles * tiles; ++tile)
    {
      for (int lane = 0; lane < 64; ++lane)
      {
        const int column = (tile % tiles) * 8 + lane % 8, row = (tile / tiles) * 8 + lane / 8;
        if (column >= pixels || row >= pixels)
        {
          continue;
        }
        const double x = (column + 0.5) / pixels * 2.0 - 1.0, y = (row + 0.5) / pixels * 2.0 - 1.0;
        const glm::vec3 origin(camera.eye),
          direction(camera.forward + x * camera.right + y * camera.up);
        RTCRayHit query = {};
        query.ray.org_x = origin.x;
        query.ray.org_y = origin.y;
        query.ray.org_z = origin.z;
        query.ray.dir_x = direction.x;
        query.ray.dir_y = direction.y;
        query.ray.dir_z = direction.z;
        query.ray.tnear = static_cast<float>(camera.nearDepth);
        query.ray.tfar = static_cast<float>(camera.farDepth);
        query.ray.mask = ~0u;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        rtcIntersect1(scene, &context, &query);
        result.depth[static_cast<std::size_t>(row) * pixels + column] =
          query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? INFINITY : query.ray.tfar;
      }
    }
    result.wall = std::min(result.wall, WallSeconds() - wall);
    result.cpu = std::min(result.cpu, benchmark::CpuSeconds() - cpu);
  }
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
  return result;
}

Result TraceWithOurs(const Spheres& spheres, const rtg::Camera& camera, int pixels, int repetitions)
{
  Result result;
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  rtg::Scene scene(device);
  rtg::Tracer tracer(device);
  const rtg::Scene::SetId set = scene.Add();
  rtg::GlyphInstances instances;
  instances.shape = rtg::Shape::Sphere;
  instances.origin = glm::dvec3(50.0);
  instances.uniformSize = 2.0f * spheres.radius;
  for (const glm::vec3& centre : spheres.centres)
  {
    instances.centres.emplace_back(centre - glm::vec3(50.0f));
  }
  scene.SetInstances(set, std::move(instances));
  const double buildStart = WallSeconds();
  scene.Commit();
  result.build = WallSeconds() - buildStart;

  rtg::TraceSettings settings;
  settings.width = settings.height = static_cast<std::uint32_t>(pixels);
  const std::vector<rtg::Light> lights(1);
  // The first image compiles the pipeline; it does not count.
  tracer.Trace(scene, camera, lights, settings);
  for (int repetition = 0; repetition < repetitions; ++repetition)
  {
    const double wall = WallSeconds(), cpu = benchmark::CpuSeconds();
    const rtg::Image image = tracer.Trace(scene, camera, lights, settings);
    result.wall = std::min(result.wall, WallSeconds() - wall);
    result.cpu = std::min(result.cpu, benchmark::CpuSeconds() - cpu);
    result.depth.assign(image.depth, image.depth + static_cast<std::size_t>(pixels) * pixels);
  }
  for (float& depth : result.depth)
  {
    depth = depth < 1.0f ? static_cast<float>(camera.depthB / (depth - camera.depthA)) : INFINITY;
  }
  std::printf("device: %s\n", device->Name().c_str());
  return result;
}

} // namespace

int main(int argc, char** argv)
try
{
  if (argc < 2)
  {
    std::fprintf(stderr, "Usage: EmbreeBenchmark SPHERES.vtk [PIXELS] [REPETITIONS]\n");
    return 2;
  }
  const Spheres spheres = benchmark::ReadSpheres(argv[1]);
  const int pixels = argc > 2 ? std::atoi(argv[2]) : 1200;
  const int repetitions = argc > 3 ? std::atoi(argv[3]) : 5;
  const rtg::Camera camera = benchmark::SpheresCamera();

  const Result embree = TraceWithEmbree(spheres, camera, pixels, repetitions);
  const Result ours = TraceWithOurs(spheres, camera, pixels, repetitions);

  // The same picture, or the speeds mean nothing.
  std::size_t hits = 0, differ = 0;
  for (std::size_t i = 0; i < embree.depth.size(); ++i)
  {
    hits += std::isfinite(embree.depth[i]);
    // Window depth as a float resolves view depth to 1e-4 here.
    differ += std::isfinite(embree.depth[i]) != std::isfinite(ours.depth[i]) ||
      (std::isfinite(embree.depth[i]) && std::abs(embree.depth[i] - ours.depth[i]) > 1e-3f);
  }
  const double rays = static_cast<double>(embree.depth.size());
  std::printf("%zu spheres, %d x %d primary rays, %.1f%% hit, %zu pixels differ\n",
    spheres.centres.size(), pixels, pixels, 100.0 * static_cast<double>(hits) / rays, differ);
  std::printf("%-22s %8s %8s %8s %16s\n", "", "build s", "wall s", "CPU s", "Mray/s per core");
  std::printf("%-22s %8.3f %8.3f %8.3f %16.2f\n", "Embree, single rays", embree.build, embree.wall,
    embree.cpu, 1e-6 * rays / embree.cpu);
  std::printf("%-22s %8.3f %8.3f %8.3f %16.2f\n", "ray-traced glyphs", ours.build, ours.wall,
    ours.cpu, 1e-6 * rays / ours.cpu);
  std::printf("ours / Embree: %.2f (asked: 0.30)\n", embree.cpu / ours.cpu);
  return differ > embree.depth.size() / 1000 ? 1 : 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "EmbreeBenchmark: %s\n", error.what());
  return 1;
}
