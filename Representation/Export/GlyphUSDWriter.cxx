#include "GlyphUSDWriter.h"

#include "Box.h"
#include "vtkNumberToString.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <locale>
#include <sstream>
#include <type_traits>

namespace
{
// Numbers as text, shortest first.
class GlyphFileText
{
public:
  GlyphFileText() { this->Text.imbue(std::locale::classic()); }
  GlyphFileText& operator<<(const char* text)
  {
    this->Text << text;
    return *this;
  }
  GlyphFileText& operator<<(const std::string& text) { return *this << text.c_str(); }
  template <typename Number>
  requires std::is_arithmetic_v<Number> GlyphFileText& operator<<(Number number)
  {
    using Tag = std::conditional_t<std::is_same_v<Number, float>, vtkNumberToString::TagFloat,
      std::conditional_t<std::is_same_v<Number, double>, vtkNumberToString::TagDouble, Number>>;
    this->Text << Tag(number);
    return *this;
  }
  template <int Length, typename Number, glm::qualifier Q>
  GlyphFileText& operator<<(const glm::vec<Length, Number, Q>& tuple)
  {
    for (int c = 0; c < Length; ++c)
    {
      *this << (c == 0 ? "(" : ", ") << tuple[c];
    }
    return *this << ")";
  }
  /// Between brackets: what `item` writes of each of so many.
  template <typename Item>
  GlyphFileText& List(std::size_t count, const Item& item)
  {
    *this << "[";
    for (std::size_t k = 0; k < count; ++k)
    {
      *this << (k == 0 ? "" : ", ");
      item(k);
    }
    return *this << "]";
  }

  std::ostringstream Text;
};

constexpr double degrees = 57.295779513082323;

// Through all copies of all parts, part by part.
template <typename Item>
void ListCopies(GlyphFileText& out, const rtglyphs::GlyphTessellatedSet& set, const Item& item)
{
  bool first = true;
  out << "[";
  for (std::size_t p = 0; p < set.Parts.size(); ++p)
  {
    for (std::size_t k = 0; k < set.Parts[p].Glyphs.size(); ++k)
    {
      out << (first ? "" : ", ");
      first = false;
      item(set.Parts[p], p, k);
    }
  }
  out << "]";
}

void WriteVectors(GlyphFileText& out, const rtglyphs::GlyphTessellatedSet& set, const char* name,
  std::vector<glm::vec3> rtglyphs::GlyphTessellatedPart::*values, double factor = 1.0)
{
  if (std::any_of(set.Parts.begin(), set.Parts.end(), [values](const auto& part) { return !(part.*values).empty(); }))
  {
    out << "            vector3f[] " << name << " = ";
    ListCopies(out, set,
      [&](const rtglyphs::GlyphTessellatedPart& part, std::size_t, std::size_t k)
      { out << glm::vec3(glm::dvec3((part.*values)[k]) * factor); });
    out << "\n";
  }
}

void WriteMesh(GlyphFileText& out, const rtglyphs::GlyphTessellatedPart& part)
{
  const rtg::TriangleMesh& mesh = *part.Mesh;
  rtg::Box box;
  for (const glm::vec3& p : mesh.positions)
  {
    box.Include({ p, p });
  }
  const std::string indent(20, ' ');
  out << "                def Mesh \"" << part.Name << "\"\n                {\n";
  out << indent << "float3[] extent = [" << box.lower << ", " << box.upper << "]\n"
      << indent << "int[] faceVertexCounts = ";
  out.List(mesh.triangles.size(), [&](std::size_t) { out << 3; });
  out << "\n" << indent << "int[] faceVertexIndices = ";
  out.List(mesh.triangles.size(),
    [&](std::size_t k) { out << mesh.triangles[k].x << ", " << mesh.triangles[k].y << ", " << mesh.triangles[k].z; });
  out << "\n" << indent << "point3f[] points = ";
  out.List(mesh.positions.size(), [&](std::size_t k) { out << mesh.positions[k]; });
  if (!mesh.normals.empty())
  {
    out << "\n" << indent << "normal3f[] normals = ";
    out.List(mesh.normals.size(), [&](std::size_t k) { out << mesh.normals[k]; });
    out << " (\n" << indent << "    interpolation = \"vertex\"\n" << indent << ")";
  }
  out << "\n" << indent << "uniform token subdivisionScheme = \"none\"\n                }\n";
}

void WriteColors(GlyphFileText& out, const rtglyphs::GlyphTessellatedSet& set)
{
  const bool each = !set.Colors.empty();
  const auto write = [&](const char* name, const auto& value)
  {
    const std::string indent(12, ' ');
    out << indent << name << " = ";
    if (each)
    {
      ListCopies(out, set, [&](const auto& part, std::size_t, std::size_t k) { value(set.ColorOf(part.Glyphs[k])); });
    }
    else
    {
      out.List(1, [&](std::size_t) { value(set.Color); });
    }
    out << " (\n" << indent << "    interpolation = \"" << (each ? "varying" : "constant") << "\"\n" << indent << ")\n";
  };
  write("color3f[] primvars:displayColor", [&](const glm::vec4& color) { out << glm::vec3(color); });
  if (set.IsTranslucent())
  {
    write("float[] primvars:displayOpacity", [&](const glm::vec4& color) { out << color.a; });
  }
}

void WriteSet(GlyphFileText& out, const rtglyphs::GlyphTessellatedSet& set)
{
  const std::string indent(12, ' ');
  out << "    def Xform \"" << set.Name << "\"\n    {\n        double3 xformOp:translate = " << set.Origin
      << "\n        uniform token[] xformOpOrder = [\"xformOp:translate\"]\n\n"
      << "        def PointInstancer \"Instances\"\n        {\n"
      << indent << "int[] protoIndices = ";
  ListCopies(out, set, [&](const rtglyphs::GlyphTessellatedPart&, std::size_t p, std::size_t) { out << p; });
  out << "\n" << indent << "rel prototypes = ";
  out.List(set.Parts.size(),
    [&](std::size_t p) { out << "</Glyphs/" << set.Name << "/Instances/Prototypes/" << set.Parts[p].Name << ">"; });
  out << "\n" << indent << "point3f[] positions = ";
  ListCopies(out, set, [&](const auto& part, std::size_t, std::size_t k) { out << part.Positions[k]; });
  out << "\n" << indent << "quath[] orientations = ";
  ListCopies(out, set,
    [&](const auto& part, std::size_t, std::size_t k)
    {
      const glm::vec4& q = part.Orientations[k];
      out << glm::vec4(q.w, q.x, q.y, q.z);
    });
  out << "\n" << indent << "float3[] scales = ";
  ListCopies(out, set, [&](const auto& part, std::size_t, std::size_t k) { out << part.Scales[k]; });
  out << "\n";
  WriteVectors(out, set, "velocities", &rtglyphs::GlyphTessellatedPart::Velocities);
  WriteVectors(out, set, "accelerations", &rtglyphs::GlyphTessellatedPart::Accelerations);
  WriteVectors(out, set, "angularVelocities", &rtglyphs::GlyphTessellatedPart::AngularVelocities, degrees);
  WriteColors(out, set);
  out << "\n            def Scope \"Prototypes\"\n            {\n";
  for (const rtglyphs::GlyphTessellatedPart& part : set.Parts)
  {
    WriteMesh(out, part);
  }
  out << "            }\n        }\n    }\n";
}
}

//----------------------------------------------------------------------------
std::string rtglyphs::GlyphUSDWriter::Text(const std::vector<rtglyphs::GlyphTessellatedSet>& sets)
{
  GlyphFileText out;
  out << "#usda 1.0\n(\n    defaultPrim = \"Glyphs\"\n    metersPerUnit = 1\n    upAxis = \"Z\"\n)\n\n"
      << "def Xform \"Glyphs\"\n{\n";
  for (const rtglyphs::GlyphTessellatedSet& set : sets)
  {
    WriteSet(out, set);
  }
  out << "}\n";
  return out.Text.str();
}
