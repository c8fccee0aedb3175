#include "GlyphGLTFWriter.h"

#include "Box.h"

// clang-format off
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)
// clang-format on

namespace
{
using Json = nlohmann::ordered_json;

// Numbers that glTF has for things
constexpr int unsignedInteger = 5125, floatingPoint = 5126, arrayBuffer = 34962, indexBuffer = 34963;
constexpr std::uint32_t magic = 0x46546C67, version = 2, jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;

class Document
{
public:
  Document()
  {
    this->All = { { "asset", { { "version", "2.0" }, { "generator", "RayTracedGlyphs" } } }, { "scene", 0 },
      { "scenes", Json::array({ Json{ { "nodes", Json::array() } } }) }, { "nodes", Json::array() },
      { "meshes", Json::array() }, { "materials", Json::array() }, { "accessors", Json::array() },
      { "bufferViews", Json::array() } };
  }

  // The number of what is put at the end of a list.
  std::size_t Add(const char* list, Json item)
  {
    this->All[list].push_back(std::move(item));
    return this->All[list].size() - 1;
  }

  template <typename Value>
  std::size_t
  AddArray(const std::vector<Value>& values, const char* type, int component = floatingPoint, int target = 0)
  {
    Json view = { { "buffer", 0 }, { "byteOffset", this->Binary.size() },
      { "byteLength", values.size() * sizeof(Value) } };
    if (target != 0)
    {
      view["target"] = target;
    }
    const auto* bytes = reinterpret_cast<const char*>(values.data());
    this->Binary.append(bytes, values.size() * sizeof(Value));
    Json accessor = { { "bufferView", this->Add("bufferViews", std::move(view)) }, { "componentType", component },
      { "count", values.size() }, { "type", type } };
    return this->Add("accessors", std::move(accessor));
  }

  // `factor`: the color of all copies, or white for those that have their own.
  std::size_t AddMaterial(const rtglyphs::GlyphTessellatedSet& set)
  {
    const glm::vec4 factor = set.Colors.empty() ? set.Color : glm::vec4(1.0f);
    Json material = { { "name", set.Name },
      { "pbrMetallicRoughness",
        { { "baseColorFactor", { factor.r, factor.g, factor.b, factor.a } }, { "metallicFactor", set.Metallic },
          { "roughnessFactor", set.Roughness } } } };
    if (set.IsTranslucent())
    {
      material["alphaMode"] = "BLEND";
    }
    return this->Add("materials", std::move(material));
  }

  std::size_t AddMesh(const rtglyphs::GlyphTessellatedPart& part, std::size_t material)
  {
    const rtg::TriangleMesh& mesh = *part.Mesh;
    const std::size_t positions = this->AddArray(mesh.positions, "VEC3", floatingPoint, arrayBuffer);
    rtg::Box box;
    for (const glm::vec3& position : mesh.positions)
    {
      box.Include({ position, position });
    }
    this->All["accessors"][positions]["min"] = { box.lower.x, box.lower.y, box.lower.z };
    this->All["accessors"][positions]["max"] = { box.upper.x, box.upper.y, box.upper.z };
    Json attributes = { { "POSITION", positions } };
    if (!mesh.normals.empty())
    {
      attributes["NORMAL"] = this->AddArray(mesh.normals, "VEC3", floatingPoint, arrayBuffer);
    }
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * mesh.triangles.size());
    for (const glm::uvec3& triangle : mesh.triangles)
    {
      indices.insert(indices.end(), { triangle.x, triangle.y, triangle.z });
    }
    Json primitive = { { "attributes", std::move(attributes) },
      { "indices", this->AddArray(indices, "SCALAR", unsignedInteger, indexBuffer) }, { "material", material } };
    return this->Add("meshes", { { "name", part.Name }, { "primitives", Json::array({ std::move(primitive) }) } });
  }

  std::size_t
  AddCopies(const rtglyphs::GlyphTessellatedSet& set, const rtglyphs::GlyphTessellatedPart& part, std::size_t material)
  {
    Json attributes = { { "TRANSLATION", this->AddArray(part.Positions, "VEC3") },
      { "ROTATION", this->AddArray(part.Orientations, "VEC4") }, { "SCALE", this->AddArray(part.Scales, "VEC3") } };
    if (!set.Colors.empty())
    {
      std::vector<glm::vec4> colors;
      colors.reserve(part.Glyphs.size());
      for (const std::uint32_t glyph : part.Glyphs)
      {
        colors.push_back(set.ColorOf(glyph));
      }
      attributes["_COLOR_0"] = this->AddArray(colors, "VEC4");
    }
    return this->Add("nodes",
      { { "name", part.Name }, { "mesh", this->AddMesh(part, material) },
        { "extensions", { { "EXT_mesh_gpu_instancing", { { "attributes", std::move(attributes) } } } } } });
  }

  Json All;
  std::string Binary;
};

void Append(std::string& to, std::uint32_t number)
{
  to.append(reinterpret_cast<const char*>(&number), sizeof(number)); // little-endian, as the arrays are
}

void AppendChunk(std::string& to, const std::string& chunk, std::uint32_t kind, char padding)
{
  const std::size_t length = (chunk.size() + 3) / 4 * 4;
  Append(to, static_cast<std::uint32_t>(length));
  Append(to, kind);
  to += chunk;
  to.append(length - chunk.size(), padding);
}

// A file's name as a relative reference: all but what RFC 3986 calls unreserved is percent-encoded.
std::string AsUri(const std::string& name)
{
  constexpr const char* digits = "0123456789ABCDEF";
  std::string uri;
  for (const unsigned char c : name)
  {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' ||
      c == '.' || c == '_' || c == '~';
    uri += plain ? std::string(1, static_cast<char>(c)) : std::string{ '%', digits[c >> 4], digits[c & 15] };
  }
  return uri;
}
}

//----------------------------------------------------------------------------
rtglyphs::GlyphGLTFWriter::File
rtglyphs::GlyphGLTFWriter::Make(const std::vector<rtglyphs::GlyphTessellatedSet>& sets, const std::string& binaryName)
{
  Document document;
  for (const rtglyphs::GlyphTessellatedSet& set : sets)
  {
    const std::size_t material = document.AddMaterial(set);
    Json children = Json::array();
    for (const rtglyphs::GlyphTessellatedPart& part : set.Parts)
    {
      children.push_back(document.AddCopies(set, part, material));
    }
    const std::size_t node = document.Add("nodes",
      { { "name", set.Name }, { "translation", { set.Origin.x, set.Origin.y, set.Origin.z } },
        { "children", std::move(children) } });
    document.All["scenes"][0]["nodes"].push_back(node);
  }
  // Readers that do not know the extension would show one copy of each mesh.
  document.All["extensionsUsed"] = document.All["extensionsRequired"] = Json::array({ "EXT_mesh_gpu_instancing" });
  Json buffer = { { "byteLength", document.Binary.size() } };
  if (!binaryName.empty())
  {
    buffer["uri"] = AsUri(binaryName);
  }
  document.All["buffers"] = Json::array({ std::move(buffer) });
  return { document.All.dump(-1, ' ', false, Json::error_handler_t::replace), std::move(document.Binary) };
}

//----------------------------------------------------------------------------
std::string rtglyphs::GlyphGLTFWriter::Together(const File& file)
{
  const std::uint64_t length = LengthTogether(file.Text.size(), file.Binary.size());
  std::string whole;
  whole.reserve(length);
  Append(whole, magic);
  Append(whole, version);
  Append(whole, static_cast<std::uint32_t>(length));
  AppendChunk(whole, file.Text, jsonChunk, ' ');
  AppendChunk(whole, file.Binary, binaryChunk, '\0');
  return whole;
}
