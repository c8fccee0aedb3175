// Embree's rays through sets of glyphs, as a yardstick of what the cores can do; the plugin itself never needs it.
//
// Spheres of one size are Embree's own, surfaces its triangles, copies of meshes its instances. Other shapes are user
// geometry that intersects them as the plugin does, with the plugin's own text as C++.
#pragma once

#include "Camera.h"
#include "Glyphs.h"
#include "Shapes/Shapes.h"

#include <embree3/rtcore.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace benchmark
{

class EmbreeScene
{
public:
  /// One thread, so that processor time is that of rays alone.
  EmbreeScene() = default;
  ~EmbreeScene()
  {
    rtcReleaseScene(this->scene_);
    rtcReleaseDevice(this->device_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  void Add(const rtg::GlyphInstances& instances)
  {
    if (instances.shape == rtg::Shape::Mesh && instances.identifyTriangles)
    {
      this->Attach(this->Triangles(*instances.mesh));
    }
    else if (instances.shape == rtg::Shape::Mesh)
    {
      this->AddCopies(instances);
    }
    else if (instances.shape == rtg::Shape::Sphere && instances.sizes3.empty() && instances.sizes1.empty())
    {
      this->Attach(this->Points(instances));
    }
    else
    {
      this->Attach(this->User(instances));
    }
  }

  void Commit() { rtcCommitScene(this->scene_); }

  /// View depth by pixel, bottom row first, infinity where nothing is hit: an image of `pixels` x `pixels` in tiles of
  /// 8 x 8, ray by ray or in packets of eight.
  void Trace(const rtg::Camera& camera, int pixels, bool packets, std::vector<float>& depth)
  {
    depth.assign(static_cast<std::size_t>(pixels) * pixels, INFINITY);
    for (int y = 0; y < pixels; y += 8)
    {
      for (int x = 0; x < pixels; x += 8)
      {
        // Eight blocks of 4 x 2 pixels a tile
        for (int block = 0; block < 8; ++block)
        {
          const int left = x + 4 * (block % 2), lower = y + 2 * (block / 2);
          packets ? Packet(camera, pixels, left, lower, depth) : Singles(camera, pixels, left, lower, depth);
        }
      }
    }
  }

private:
  using Shapes = rtg::shapes::Kernel<float>;

  // Glyphs of one shape as Embree's callbacks find them.
  struct UserGlyphs
  {
    rtg::Shape shape;
    std::vector<Shapes::Glyph> glyphs;
  };

  void Attach(RTCGeometry geometry)
  {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->scene_, geometry);
    rtcReleaseGeometry(geometry);
  }

  RTCGeometry Points(const rtg::GlyphInstances& instances)
  {
    RTCGeometry geometry = rtcNewGeometry(this->device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* spheres = static_cast<glm::vec4*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(glm::vec4), instances.Count()));
    for (const glm::vec3& center : instances.centers)
    {
      *spheres++ = glm::vec4(center, 0.5f * instances.uniformSize);
    }
    return geometry;
  }

  RTCGeometry Triangles(const rtg::TriangleMesh& mesh)
  {
    RTCGeometry geometry = rtcNewGeometry(this->device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.positions.size()));
    for (const glm::vec3& position : mesh.positions)
    {
      *corners++ = position.x;
      *corners++ = position.y;
      *corners++ = position.z;
    }
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles)
    {
      *indices++ = triangle.x;
      *indices++ = triangle.y;
      *indices++ = triangle.z;
    }
    return geometry;
  }

  void AddCopies(const rtg::GlyphInstances& instances)
  {
    RTCScene form = rtcNewScene(this->device_);
    RTCGeometry triangles = this->Triangles(*instances.mesh);
    rtcCommitGeometry(triangles);
    rtcAttachGeometry(form, triangles);
    rtcReleaseGeometry(triangles);
    rtcCommitScene(form);
    for (std::size_t i = 0; i < instances.Count(); ++i)
    {
      const Shapes::Glyph glyph = Glyph(instances, i);
      float columns[12];
      for (int axis = 0; axis < 4; ++axis)
      {
        glm::vec3 column = glyph.center;
        if (axis < 3)
        {
          column = glm::vec3(0.0f);
          column[axis] = glyph.size[axis];
          column = Shapes::RotateToWorld(glyph, column);
        }
        columns[3 * axis] = column.x;
        columns[3 * axis + 1] = column.y;
        columns[3 * axis + 2] = column.z;
      }
      RTCGeometry copy = rtcNewGeometry(this->device_, RTC_GEOMETRY_TYPE_INSTANCE);
      rtcSetGeometryInstancedScene(copy, form);
      rtcSetGeometryTransform(copy, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
      this->Attach(copy);
    }
    rtcReleaseScene(form);
  }

  static Shapes::Glyph Glyph(const rtg::GlyphInstances& instances, std::size_t i)
  {
    Shapes::Glyph glyph{};
    glyph.center = instances.centers[i];
    glyph.size = instances.sizes3.empty() ? glm::vec3(instances.uniformSize) : instances.sizes3[i];
    glyph.sameSize = instances.sizes3.empty();
    glyph.rotated = !instances.rotations.empty();
    glyph.rotation = glyph.rotated ? instances.rotations[i] : glm::vec4(0, 0, 0, 1);
    glyph.arrow = glm::vec4(
      instances.arrow.shaftRadius, instances.arrow.tipRadius, instances.arrow.tipLength, instances.arrow.tipRounding);
    glyph.fixedHeads = instances.arrow.fixedHeads;
    glyph.unitLength = instances.arrow.unitLength;
    glyph.exponents = instances.exponents3.empty() ? instances.uniformExponents : instances.exponents3[i];
    glyph.before = instances.before.empty() ? glm::vec4(0.0f) : instances.before[i];
    glyph.after = instances.after.empty() ? glm::vec4(0.0f) : instances.after[i];
    return glyph;
  }

  RTCGeometry User(const rtg::GlyphInstances& instances)
  {
    auto user = std::make_unique<UserGlyphs>();
    user->shape = instances.shape;
    for (std::size_t i = 0; i < instances.Count(); ++i)
    {
      user->glyphs.push_back(Glyph(instances, i));
    }
    RTCGeometry geometry = rtcNewGeometry(this->device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(instances.Count()));
    rtcSetGeometryUserData(geometry, user.get());
    rtcSetGeometryBoundsFunction(geometry, Bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, Intersect);
    this->user_.push_back(std::move(user));
    return geometry;
  }

  static void Bounds(const RTCBoundsFunctionArguments* arguments)
  {
    const auto& user = *static_cast<const UserGlyphs*>(arguments->geometryUserPtr);
    const Shapes::Glyph& glyph = user.glyphs[arguments->primID];
    glm::vec3 lower, upper;
    Shapes::GlyphBounds(user.shape, glyph, lower, upper);
    const glm::vec3 padding = 1e-5f * glyph.size;
    lower -= padding;
    upper += padding;
    *arguments->bounds_o = { lower.x, lower.y, lower.z, 0.0f, upper.x, upper.y, upper.z, 0.0f };
  }

  static void Intersect(const RTCIntersectFunctionNArguments* arguments)
  {
    const auto& user = *static_cast<const UserGlyphs*>(arguments->geometryUserPtr);
    const Shapes::Glyph& glyph = user.glyphs[arguments->primID];
    const unsigned count = arguments->N;
    RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, count);
    RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, count);
    for (unsigned i = 0; i < count; ++i)
    {
      if (arguments->valid[i] == 0)
      {
        continue;
      }
      Shapes::GlyphRay ray;
      ray.origin = { RTCRayN_org_x(rays, count, i), RTCRayN_org_y(rays, count, i), RTCRayN_org_z(rays, count, i) };
      ray.originLow = glm::vec3(0.0f);
      ray.direction = { RTCRayN_dir_x(rays, count, i), RTCRayN_dir_y(rays, count, i), RTCRayN_dir_z(rays, count, i) };
      const float near = RTCRayN_tnear(rays, count, i);
      float& far = RTCRayN_tfar(rays, count, i);
      float t = 0.0f, low = 0.0f, high = 0.0f;
      if (Shapes::EstimateGlyph(user.shape, ray, glyph, near, far, low, high) != Shapes::missed &&
        Shapes::IntersectGlyph(user.shape, ray, glyph, near, far, t))
      {
        far = t;
        const glm::vec3 normal = Shapes::GlyphNormal(user.shape, ray, glyph, t);
        RTCHitN_Ng_x(hits, count, i) = normal.x;
        RTCHitN_Ng_y(hits, count, i) = normal.y;
        RTCHitN_Ng_z(hits, count, i) = normal.z;
        RTCHitN_primID(hits, count, i) = arguments->primID;
        RTCHitN_geomID(hits, count, i) = arguments->geomID;
        RTCHitN_instID(hits, count, i, 0) = arguments->context->instID[0];
      }
    }
  }

  static glm::vec3 Direction(const rtg::Camera& camera, int pixels, int column, int row)
  {
    const double x = (column + 0.5) / pixels * 2.0 - 1.0, y = (row + 0.5) / pixels * 2.0 - 1.0;
    return glm::vec3(camera.forward + x * camera.right + y * camera.up);
  }

  static RTCIntersectContext Context()
  {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return context;
  }

  void Singles(const rtg::Camera& camera, int pixels, int left, int lower, std::vector<float>& depth) const
  {
    const glm::vec3 origin(camera.eye);
    for (int lane = 0; lane < 8; ++lane)
    {
      const int column = left + lane % 4, row = lower + lane / 4;
      if (column >= pixels || row >= pixels)
      {
        continue;
      }
      const glm::vec3 direction = Direction(camera, pixels, column, row);
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
      query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      RTCIntersectContext context = Context();
      rtcIntersect1(this->scene_, &context, &query);
      depth[static_cast<std::size_t>(row) * pixels + column] =
        query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? INFINITY : query.ray.tfar;
    }
  }

  void Packet(const rtg::Camera& camera, int pixels, int left, int lower, std::vector<float>& depth) const
  {
    const glm::vec3 origin(camera.eye);
    RTCRayHit8 query = {};
    alignas(32) int valid[8];
    for (int lane = 0; lane < 8; ++lane)
    {
      const int column = left + lane % 4, row = lower + lane / 4;
      valid[lane] = column < pixels && row < pixels ? -1 : 0;
      const glm::vec3 direction = Direction(camera, pixels, column, row);
      query.ray.org_x[lane] = origin.x;
      query.ray.org_y[lane] = origin.y;
      query.ray.org_z[lane] = origin.z;
      query.ray.dir_x[lane] = direction.x;
      query.ray.dir_y[lane] = direction.y;
      query.ray.dir_z[lane] = direction.z;
      query.ray.tnear[lane] = static_cast<float>(camera.nearDepth);
      query.ray.tfar[lane] = static_cast<float>(camera.farDepth);
      query.ray.mask[lane] = ~0u;
      query.hit.geomID[lane] = query.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context = Context();
    rtcIntersect8(valid, this->scene_, &context, &query);
    for (int lane = 0; lane < 8; ++lane)
    {
      if (valid[lane])
      {
        depth[static_cast<std::size_t>(lower + lane / 4) * pixels + left + lane % 4] =
          query.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID ? INFINITY : query.ray.tfar[lane];
      }
    }
  }

  RTCDevice device_ = rtcNewDevice("threads=1");
  RTCScene scene_ = rtcNewScene(this->device_);
  std::vector<std::unique_ptr<UserGlyphs>> user_;
};

} // namespace benchmark
