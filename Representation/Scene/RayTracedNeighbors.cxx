#include "RayTracedNeighbors.h"

#include "GlyphBoxes.h"
#include "Neighbors.h"
#include "RayTracedRanks.h"
#include "vtkCommunicator.h"

#include <glm/gtc/type_ptr.hpp>

#include <cstring>

namespace
{
// Before each set in a message between ranks.
struct Header
{
  std::int64_t Display;
  std::uint64_t Size; // bytes that follow
};

void Append(std::vector<char>& message, int display, const std::vector<char>& bytes)
{
  if (!bytes.empty())
  {
    const Header header{ display, bytes.size() };
    const auto* first = reinterpret_cast<const char*>(&header);
    message.insert(message.end(), first, first + sizeof(header));
    message.insert(message.end(), bytes.begin(), bytes.end());
  }
}
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedNeighbors::Clear()
{
  if (this->Reach >= 0.0 || !this->Sets.empty())
  {
    this->Sets.clear();
    this->Glyphs = this->Bytes = 0;
    this->Reach = -1.0;
    ++this->Version;
  }
}

//----------------------------------------------------------------------------
std::string rtglyphs::RayTracedNeighbors::Exchange(
  double reach, bool changed, int displays, const std::function<std::vector<Shown>()>& shown)
{
  std::vector<double> largest{ changed || reach != this->Reach ? 1.0 : 0.0, double(displays), -double(displays) };
  rtglyphs::RayTracedRanks::Reduce(largest, vtkCommunicator::MAX_OP);
  if (largest[0] == 0.0)
  {
    return std::string();
  }
  this->Clear();
  this->Reach = reach;
  ++this->Version;
  if (largest[1] != -largest[2])
  {
    return "Ray Traced Glyphs: ranks have " + std::to_string(static_cast<int>(-largest[2])) + " to " +
      std::to_string(static_cast<int>(largest[1])) +
      " displays, so their glyphs do not shade each other. Render again.";
  }
  const std::string problem = rtglyphs::RayTracedRanks::Problem([&] { this->SendNear(shown()); });
  if (problem.empty())
  {
    return std::string();
  }
  this->Sets.clear();
  return "Ray Traced Glyphs: glyphs of other ranks cannot shade those of this one (" + problem +
    "). Make AmbientOcclusionRadius smaller, or set ParallelLight to Local.";
}

//----------------------------------------------------------------------------
// To each rank what overlaps its neighborhood.
void rtglyphs::RayTracedNeighbors::SendNear(const std::vector<Shown>& sets)
{
  std::vector<std::vector<rtg::Box>> boxes;
  rtg::DoubleBox bounds;
  for (const Shown& set : sets)
  {
    boxes.push_back(rtg::GlyphBoxes(*set.Instances));
    bounds.Include(rtg::BoundsOf(*set.Instances, boxes.back()));
  }
  const auto& [low, high] = bounds; // of nothing with lower ends above the upper ones
  const std::vector<double> own{ low.x, low.y, low.z, high.x, high.y, high.z };
  const std::vector<double> all = rtglyphs::RayTracedRanks::Gather(own);
  std::vector<std::vector<char>> messages(rtglyphs::RayTracedRanks::Count());
  for (int to = 0; to < rtglyphs::RayTracedRanks::Count(); ++to)
  {
    const rtg::DoubleBox region{ glm::make_vec3(&all[6 * to]), glm::make_vec3(&all[6 * to + 3]) };
    for (std::size_t i = 0; to != rtglyphs::RayTracedRanks::Own() && !region.Empty() && i < sets.size(); ++i)
    {
      Append(messages[to], sets[i].Display,
        rtg::PackNear(*sets[i].Instances, *sets[i].Colors, boxes[i], region.Widened(this->Reach)));
    }
  }
  this->Receive(rtglyphs::RayTracedRanks::Exchange(std::move(messages)));
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedNeighbors::Receive(const std::vector<char>& bytes)
{
  this->Bytes = bytes.size();
  for (std::size_t at = 0; at + sizeof(Header) <= bytes.size();)
  {
    Header header;
    std::memcpy(&header, bytes.data() + at, sizeof(header));
    at += sizeof(header);
    Set& set = this->Sets.emplace_back();
    set.Display = static_cast<int>(header.Display);
    rtg::Unpack({ bytes.begin() + at, bytes.begin() + at + header.Size }, set.Instances, set.Colors);
    at += header.Size;
    this->Glyphs += set.Instances.identifyTriangles ? set.Instances.mesh->triangles.size() : set.Instances.Count();
  }
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedNeighbors::Commit(
  rtg::Scene& scene, std::uint64_t sceneNumber, const std::function<rtg::Material(int display)>& material)
{
  if (this->SentScene != sceneNumber)
  {
    this->Sent.clear(); // they went with the scene
    this->SentScene = sceneNumber;
    this->SentVersion = 0;
  }
  if (this->SentVersion != this->Version)
  {
    for (const rtg::Scene::SetId id : this->Sent)
    {
      scene.Remove(id);
    }
    this->Sent.clear();
    this->SentMaterials.assign(this->Sets.size(), rtg::Material());
    for (const Set& set : this->Sets)
    {
      const rtg::Scene::SetId id = scene.Add();
      this->Sent.push_back(id);
      scene.SetCameraVisible(id, false);
      scene.SetInstances(id, set.Instances);
      scene.SetColors(id, set.Colors);
    }
    this->SentVersion = this->Version;
  }
  for (std::size_t i = 0; i < this->Sent.size(); ++i)
  {
    const rtg::Material wanted = material(this->Sets[i].Display);
    if (!(this->SentMaterials[i] == wanted))
    {
      scene.SetMaterial(this->Sent[i], wanted);
      this->SentMaterials[i] = wanted;
    }
  }
}
