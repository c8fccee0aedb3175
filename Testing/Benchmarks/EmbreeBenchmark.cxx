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
#include <memory>
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
  const glm::vec3 origin(ray.org_x, ray.org_y, ray.org_z), direction(ray.dir_x, ray.dir_y, ray.dir_z);
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
  std::vector<float> depth;      // view depth by pixel, bottom row first; infinity: nothing hit
  std::vector<double> wall, cpu; // seconds a frame
  double build = 0.0;            // wall seconds
};

class Embree
{
public:
  Embree(const Spheres& spheres, const rtg::Camera& camera, int pixels)
    : camera_(camera)
    , pixels_(pixels)
  {
    RTCGeometry geometry = rtcNewGeometry(this->device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(spheres.centres.size()));
    rtcSetGeometryUserData(geometry, const_cast<Spheres*>(&spheres));
    rtcSetGeometryBoundsFunction(geometry, SphereBounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, SphereIntersect);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->scene_, geometry);
    rtcReleaseGeometry(geometry);
    const double start = WallSeconds();
    rtcCommitScene(this->scene_);
    this->result.build = WallSeconds() - start;
    this->result.depth.resize(static_cast<std::size_t>(pixels) * pixels);
  }
  ~Embree()
  {
    rtcReleaseScene(this->scene_);
    rtcReleaseDevice(this->device_);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  void Frame()
  {
    const int tiles = (this->pixels_ + 7) / 8;
    const double wall = WallSeconds(), cpu = benchmark::CpuSeconds();
    for (int tile = 0; tile < tiles * tiles; ++tile)
    {
      for (int lane = 0; lane < 64; ++lane)
      {
        const int column = (tile % tiles) * 8 + lane % 8, row = (tile / tiles) * 8 + lane / 8;
        if (column < this->pixels_ && row < this->pixels_)
        {
          this->Ray(column, row);
        }
      }
    }
    this->result.wall.push_back(WallSeconds() - wall);
    this->result.cpu.push_back(benchmark::CpuSeconds() - cpu);
  }

  Result result;

private:
  void Ray(int column, int row)
  {
    const rtg::Camera& camera = this->camera_;
    const double x = (column + 0.5) / this->pixels_ * 2.0 - 1.0, y = (row + 0.5) / this->pixels_ * 2.0 - 1.0;
    const glm::vec3 origin(camera.eye), direction(camera.forward + x * camera.right + y * camera.up);
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
    rtcIntersect1(this->scene_, &context, &query);
    this->result.depth[static_cast<std::size_t>(row) * this->pixels_ + column] =
      query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? INFINITY : query.ray.tfar;
  }

  RTCDevice device_ = rtcNewDevice("threads=1");
  RTCScene scene_ = rtcNewScene(this->device_);
  rtg::Camera camera_;
  int pixels_;
};

class Ours
{
public:
  Ours(const Spheres& spheres, const rtg::Camera& camera, int pixels)
    : camera_(camera)
  {
    rtg::GlyphInstances instances;
    instances.shape = rtg::Shape::Sphere;
    instances.origin = glm::dvec3(50.0);
    instances.uniformSize = 2.0f * spheres.radius;
    for (const glm::vec3& centre : spheres.centres)
    {
      instances.centres.emplace_back(centre - glm::vec3(50.0f));
    }
    this->scene_.SetInstances(this->scene_.Add(), std::move(instances));
    const double start = WallSeconds();
    this->scene_.Commit();
    this->result.build = WallSeconds() - start;
    this->settings_.width = this->settings_.height = static_cast<std::uint32_t>(pixels);
    // The first image compiles the pipeline; it does not count.
    this->tracer_.Trace(this->scene_, camera, this->lights_, this->settings_);
    std::printf("device: %s\n", this->device_->Name().c_str());
  }

  void Frame()
  {
    const double wall = WallSeconds(), cpu = benchmark::CpuSeconds();
    const rtg::Image image = this->tracer_.Trace(this->scene_, this->camera_, this->lights_, this->settings_);
    this->result.wall.push_back(WallSeconds() - wall);
    this->result.cpu.push_back(benchmark::CpuSeconds() - cpu);
    this->result.depth.assign(image.depth, image.depth + std::size_t(image.width) * image.height);
    for (float& depth : this->result.depth)
    {
      depth = depth < 1.0f ? static_cast<float>(this->camera_.depthB / (depth - this->camera_.depthA)) : INFINITY;
    }
  }

  Result result;

private:
  std::shared_ptr<rtg::Device> device_ = rtg::Device::Shared();
  rtg::Scene scene_{ this->device_ };
  rtg::Tracer tracer_{ this->device_ };
  rtg::TraceSettings settings_;
  std::vector<rtg::Light> lights_{ 1 };
  rtg::Camera camera_;
};

void Print(const char* name, const Result& result)
{
  const double cpu = benchmark::Quantile(result.cpu, 0.5);
  std::printf("%-22s %8.3f %8.3f %8.3f %16.2f\n", name, result.build, benchmark::Quantile(result.wall, 0.5), cpu,
    1e-6 * static_cast<double>(result.depth.size()) / cpu);
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
  const int repetitions = argc > 3 ? std::max(std::atoi(argv[3]), 1) : 9;
  const rtg::Camera camera = benchmark::SpheresCamera();

  // Frame by frame in turns, so that both see the machine in the same state.
  Embree embree(spheres, camera, pixels);
  Ours ours(spheres, camera, pixels);
  std::vector<double> ratios;
  for (int repetition = 0; repetition < repetitions; ++repetition)
  {
    embree.Frame();
    ours.Frame();
    ratios.push_back(embree.result.cpu.back() / ours.result.cpu.back());
  }

  // The same picture, or the speeds mean nothing.
  const std::vector<float>&a = embree.result.depth, &b = ours.result.depth;
  std::size_t hits = 0, differ = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    hits += std::isfinite(a[i]);
    // Window depth as a float resolves view depth to 1e-4 here.
    differ += std::isfinite(a[i]) != std::isfinite(b[i]) || (std::isfinite(a[i]) && std::abs(a[i] - b[i]) > 1e-3f);
  }
  std::printf("%zu spheres, %d x %d primary rays, %.1f%% hit, %zu pixels differ\n", spheres.centres.size(), pixels,
    pixels, 100.0 * static_cast<double>(hits) / static_cast<double>(a.size()), differ);
  std::printf("%-22s %8s %8s %8s %16s   (medians of %d frames in turns)\n", "", "build s", "wall s", "CPU s",
    "Mray/s per core", repetitions);
  Print("Embree, single rays", embree.result);
  Print("ray-traced glyphs", ours.result);
  std::printf("ours / Embree: %.2f (quartiles %.2f, %.2f; asked: 0.30)\n", benchmark::Quantile(ratios, 0.5),
    benchmark::Quantile(ratios, 0.25), benchmark::Quantile(ratios, 0.75));
  return differ > a.size() / 1000 ? 1 : 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "EmbreeBenchmark: %s\n", error.what());
  return 1;
}
