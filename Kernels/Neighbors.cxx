#include "Neighbors.h"

#include "GlyphArrays.h"
#include "GlyphBoxes.h"
#include "MeshTree.h"

#include <cstring>
#include <type_traits>

namespace rtg
{

namespace
{

bool Touch(const DoubleBox& a, const DoubleBox& b)
{
  return glm::all(glm::lessThanEqual(a.lower, b.upper)) && glm::all(glm::lessThanEqual(b.lower, a.upper));
}

DoubleBox Moved(const Box& box, const glm::dvec3& by)
{
  return { glm::dvec3(box.lower) + by, glm::dvec3(box.upper) + by };
}

// Keeps the values with these indices. An array without values stays so.
template <class Value>
void Keep(std::vector<Value>& values, const std::vector<std::uint32_t>& kept)
{
  if (!values.empty())
  {
    for (std::size_t i = 0; i < kept.size(); ++i) // in ascending order
    {
      values[i] = values[kept[i]];
    }
    values.resize(kept.size());
    values.shrink_to_fit();
  }
}

// A surface is a glyph of size 1 at its set's origin.
std::shared_ptr<const TriangleMesh> Cut(const GlyphInstances& instances, const DoubleBox& region)
{
  const glm::dvec3 place = instances.origin + glm::dvec3(instances.centers.front());
  const DoubleBox near{ region.lower - place, region.upper - place };
  auto mesh = std::make_shared<TriangleMesh>(*instances.mesh);
  const GlyphMotion& shutter = instances.motion;
  const TrianglePaths paths{ mesh->positions, *mesh };
  std::vector<std::uint32_t> triangles, positions;
  constexpr std::uint32_t unused = 0xffffffffu;
  std::vector<std::uint32_t> newNumber(mesh->positions.size(), unused);
  for (std::uint32_t i = 0; i < mesh->triangles.size(); ++i)
  {
    if (Touch(paths.Triangle(i, shutter.EarliestTime(0.0), shutter.LatestTime(1.0)), near))
    {
      triangles.push_back(i);
      for (int corner = 0; corner < 3; ++corner)
      {
        newNumber[mesh->triangles[i][corner]] = 0;
      }
    }
  }
  for (std::uint32_t i = 0; i < newNumber.size(); ++i)
  {
    if (newNumber[i] != unused)
    {
      newNumber[i] = static_cast<std::uint32_t>(positions.size());
      positions.push_back(i);
    }
  }
  Keep(mesh->triangles, triangles);
  Keep(mesh->triangleColors, triangles);
  Keep(mesh->positions, positions);
  Keep(mesh->normals, positions);
  Keep(mesh->positionColors, positions);
  Keep(mesh->positionValues, positions);
  Keep(mesh->motion.velocities, positions);
  Keep(mesh->motion.accelerations, positions);
  for (glm::uvec3& triangle : mesh->triangles)
  {
    triangle = { newNumber[triangle.x], newNumber[triangle.y], newNumber[triangle.z] };
  }
  return mesh;
}

class Writer
{
public:
  /// Arrays with a value for each glyph are written for the kept glyphs only.
  explicit Writer(const std::vector<std::uint32_t>& kept)
    : kept_(kept)
  {
  }
  template <class Value>
  void operator()(const Value& value)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    const auto* first = reinterpret_cast<const char*>(&value);
    this->bytes.insert(this->bytes.end(), first, first + sizeof(value));
  }
  template <class Value>
  void operator()(const std::vector<Value>& values)
  {
    (*this)(static_cast<std::uint64_t>(values.size()));
    const auto* first = reinterpret_cast<const char*>(values.data());
    this->bytes.insert(this->bytes.end(), first, first + values.size() * sizeof(Value));
  }
  template <class Array>
  void OfGlyphs(const Array& values)
  {
    (*this)(static_cast<std::uint64_t>(values.empty() ? 0 : this->kept_.size() * Flat(values).size() / values.size()));
    for (std::size_t i = 0; !values.empty() && i < this->kept_.size(); ++i)
    {
      const char* const row = Row(values, this->kept_[i]);
      this->bytes.insert(this->bytes.end(), row, row + RowBytes(values));
    }
  }

  std::vector<char> bytes;

private:
  const std::vector<std::uint32_t>& kept_;
};

class Reader
{
public:
  explicit Reader(const std::vector<char>& from)
    : bytes_(from)
  {
  }
  template <class Value>
  void operator()(Value& value)
  {
    this->Take(&value, sizeof(value));
  }
  template <class Value>
  void operator()(std::vector<Value>& values)
  {
    std::uint64_t count = 0;
    (*this)(count);
    if (count > (this->bytes_.size() - this->at_) / sizeof(Value))
    {
      this->Fail();
    }
    values.resize(count);
    this->Take(values.data(), count * sizeof(Value));
  }
  template <class Array>
  void OfGlyphs(Array& values)
  {
    (*this)(Flat(values));
  }

private:
  void Take(void* target, std::size_t size)
  {
    if (size > this->bytes_.size() - this->at_)
    {
      this->Fail();
    }
    if (size > 0)
    {
      std::memcpy(target, this->bytes_.data() + this->at_, size);
    }
    this->at_ += size;
  }
  [[noreturn]] void Fail() const
  {
    throw Error("Ray Traced Glyphs: glyphs of another rank arrived incomplete, in " +
      std::to_string(this->bytes_.size()) + " bytes; render again.");
  }

  const std::vector<char>& bytes_;
  std::size_t at_ = 0;
};

// All of a set but its mesh, with a Writer or a Reader: one order for both.
template <class Instances, class Colors, class Transfer>
void Visit(Instances& instances, Colors& colors, Transfer& transfer)
{
#define RTG_TRANSFER(type, name, value) transfer(value);
  RTG_GLYPH_NUMBERS(RTG_TRANSFER)
#undef RTG_TRANSFER
  transfer(instances.polynomials.width);
  transfer(instances.origin);
  transfer(colors.table);
  ForEachArray(
    instances, colors, [&](std::size_t, std::uint32_t, auto& values, const char*) { transfer.OfGlyphs(values); });
}

template <class Mesh, class Transfer>
void VisitMesh(Mesh& mesh, Transfer& transfer)
{
  transfer(mesh.positions);
  transfer(mesh.triangles);
  transfer(mesh.normals);
  transfer(mesh.positionColors);
  transfer(mesh.triangleColors);
  transfer(mesh.positionValues);
  transfer(mesh.valueColors);
  transfer(mesh.motion.velocities);
  transfer(mesh.motion.accelerations);
}

} // namespace

std::vector<char> PackNear(
  const GlyphInstances& instances, const GlyphColors& colors, const std::vector<Box>& boxes, const DoubleBox& region)
{
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    if (Touch(Moved(boxes[i], instances.origin), region))
    {
      kept.push_back(static_cast<std::uint32_t>(i));
    }
  }
  std::shared_ptr<const TriangleMesh> mesh =
    instances.identifyTriangles && !kept.empty() ? Cut(instances, region) : instances.mesh;
  if (kept.empty() || (mesh && mesh->triangles.empty()))
  {
    return {};
  }
  Writer writer(kept);
  Visit(instances, colors, writer);
  if (mesh)
  {
    VisitMesh(*mesh, writer);
  }
  return std::move(writer.bytes);
}

void Unpack(const std::vector<char>& bytes, GlyphInstances& instances, GlyphColors& colors)
{
  Reader reader(bytes);
  Visit(instances, colors, reader);
  instances.mesh.reset();
  if (instances.shape == Shape::Mesh)
  {
    auto mesh = std::make_shared<TriangleMesh>();
    VisitMesh(*mesh, reader);
    instances.mesh = std::move(mesh);
  }
}

DoubleBox BoundsOf(const GlyphInstances& instances, const std::vector<Box>& boxes)
{
  return Moved(UnionOf(boxes), instances.origin);
}

} // namespace rtg
