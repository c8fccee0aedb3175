#include "SceneState.h"

#include "GlyphBoxes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rtg
{

namespace
{

// A device whose traversal runs on the CPU does better with our own; RTGLYPHS_STRUCTURE (boxes or tree)
// overrides, for measurements.
Structure ChooseStructure(const Device& device, bool canTree)
{
  const char* wanted = std::getenv("RTGLYPHS_STRUCTURE");
  if (wanted && std::string(wanted) == "boxes")
  {
    return Structure::Boxes;
  }
  if (wanted && std::string(wanted) != "tree" && *wanted)
  {
    throw Error("Ray Traced Glyphs: RTGLYPHS_STRUCTURE is '" + std::string(wanted) +
      "'; it can be 'boxes' or 'tree'.");
  }
  return canTree && (device.IsCpu() || (wanted && *wanted)) ? Structure::Tree : Structure::Boxes;
}

// Throws unless every array has an entry a glyph or none.
void CheckLengths(const GlyphInstances& instances)
{
  const auto check = [&](const char* name, std::size_t found)
  {
    if (found != 0 && found != instances.Count())
    {
      throw Error("Ray Traced Glyphs: " + std::to_string(found) + " " + name + " for " +
        std::to_string(instances.Count()) + " glyphs; give one a glyph or none.");
    }
  };
  check("sizes along three axes", instances.sizes3.size());
  check("sizes", instances.sizes1.size());
  check("rotations", instances.rotations.size());
  check("exponents", instances.exponents3.size());
  check("quadratic forms", instances.forms.size());
  if (!instances.sizes3.empty() && !instances.sizes1.empty())
  {
    throw Error("Ray Traced Glyphs: glyphs have sizes along three axes and single ones; give one kind of them.");
  }
}

} // namespace

void Bounds::Include(const glm::vec3& a, const glm::vec3& b)
{
  this->lower = glm::min(this->lower, a);
  this->upper = glm::max(this->upper, b);
}

float Bounds::Reach() const
{
  const glm::vec3 reach = glm::max(glm::abs(this->lower), glm::abs(this->upper));
  return this->Empty() ? 0.0f : std::max({ reach.x, reach.y, reach.z });
}

Statistics& Statistics::operator+=(const Statistics& other)
{
  this->structureBuilds += other.structureBuilds;
  this->topLevelBuilds += other.topLevelBuilds;
  this->instanceUploads += other.instanceUploads;
  this->colourUploads += other.colourUploads;
  this->sorts += other.sorts;
  this->pipelineBuilds += other.pipelineBuilds;
  this->dispatches += other.dispatches;
  this->primaryRays += other.primaryRays;
  this->deviceBytes = std::max(this->deviceBytes, other.deviceBytes);
  this->sortSeconds += other.sortSeconds;
  this->buildSeconds += other.buildSeconds;
  this->uploadSeconds += other.uploadSeconds;
  this->traceSeconds += other.traceSeconds;
  this->denoiseSeconds += other.denoiseSeconds;
  return *this;
}

Scene::State::State(std::shared_ptr<Device> d)
  : device(std::move(d))
  , mostInstances(device->GetState().structureLimits.maxInstanceCount)
  , structure(ChooseStructure(*device, device->GetState().int64))
{
}

Scene::Scene(std::shared_ptr<Device> device)
  : state_(std::make_unique<State>(std::move(device)))
{
}

Scene::~Scene() = default;

Scene::SetId Scene::Add()
{
  const SetId id = this->state_->nextId++;
  this->state_->sets[id];
  return id;
}

void Scene::Remove(SetId id)
{
  this->state_->topLevelChanged |= this->state_->sets.erase(id) > 0;
}

void Scene::SetInstances(SetId id, GlyphInstances instances)
{
  GlyphSet& set = this->state_->sets.at(id);
  if (instances.shape == Shape::Mesh)
  {
    CheckMesh(instances.mesh.get(), instances.motion);
  }
  CheckLengths(instances);
  CheckMotion(instances.motion, instances.Count());
  set.count = instances.Count();
  const auto seeThrough = [](std::uint32_t colour) { return (colour >> 24) != 255; };
  const TriangleMesh* mesh = instances.shape == Shape::Mesh ? instances.mesh.get() : nullptr;
  set.translucentMesh = mesh &&
    (std::any_of(mesh->positionColours.begin(), mesh->positionColours.end(), seeThrough) ||
      std::any_of(mesh->triangleColours.begin(), mesh->triangleColours.end(), seeThrough) ||
      std::any_of(mesh->valueColours.begin(), mesh->valueColours.end(), seeThrough));
  set.instances = std::move(instances);
  set.instancesChanged = true;
  // Colours are by glyph: those of the old glyphs mean nothing now.
  set.colours.clear();
  set.coloursChanged = true;
  set.translucentColours = false;
}

void Scene::SetColours(SetId id, GlyphColours colours)
{
  GlyphSet& set = this->state_->sets.at(id);
  if (!colours.empty() && colours.size() != set.count)
  {
    throw Error("Ray Traced Glyphs: " + std::to_string(colours.size()) + " colours for " +
      std::to_string(set.count) + " glyphs; give one colour a glyph or none.");
  }
  set.translucentColours = std::any_of(
    colours.begin(), colours.end(), [](std::uint32_t colour) { return (colour >> 24) != 255; });
  set.colours = std::move(colours);
  set.coloursChanged = true;
}

void Scene::SetMaterial(SetId id, const Material& material)
{
  GlyphSet& set = this->state_->sets.at(id);
  set.material = material;
  this->state_->recordsChanged = true;
}

void Scene::SetVisible(SetId id, bool visible)
{
  GlyphSet& set = this->state_->sets.at(id);
  this->state_->topLevelChanged |= set.visible != visible;
  set.visible = visible;
}

std::size_t Scene::GlyphCount(SetId id) const
{
  return this->state_->sets.at(id).count;
}

std::uint32_t Scene::OriginalGlyph(SetId set, std::uint32_t sorted) const
{
  const GlyphSet& glyphs = this->state_->sets.at(set);
  const auto& order = glyphs.instances.identifyTriangles ? glyphs.mesh.order : glyphs.order;
  return order.empty() ? sorted : order.at(sorted);
}

bool Scene::HasTranslucent() const
{
  const auto& sets = this->state_->sets;
  return std::any_of(sets.begin(), sets.end(),
    [](const auto& entry)
    { return entry.second.visible && entry.second.count && entry.second.Translucent(); });
}

bool Scene::HasOpaque() const
{
  const auto& sets = this->state_->sets;
  return std::any_of(sets.begin(), sets.end(),
    [](const auto& entry)
    { return entry.second.visible && entry.second.count && !entry.second.Translucent(); });
}

const Statistics& Scene::GetStatistics() const
{
  this->state_->statistics.deviceBytes = this->state_->device->GetState().bytes;
  return this->state_->statistics;
}

void Scene::Commit()
{
  State& state = *this->state_;
  state.device->GetState().Guard("sending glyphs",
    [&]
    {
      // Ray origins are at most a scene away from a set, so every set's padding depends on all the others' extent.
      float reach = 0.0f;
      for (auto& [id, set] : state.sets)
      {
        if (set.instancesChanged)
        {
          set.bounds = Bounds();
          set.boxes = GlyphBoxes(set.instances);
          for (const Box& box : set.boxes)
          {
            set.bounds.Include(box.lower, box.upper);
          }
        }
      }
      // The scene's origin is that of its first set: near the data, and it stays put.
      const auto first = std::find_if(state.sets.begin(), state.sets.end(),
        [](const auto& entry) { return entry.second.count > 0; });
      const glm::dvec3 origin =
        first == state.sets.end() ? glm::dvec3(0.0) : first->second.instances.origin;
      if (origin != state.origin)
      {
        state.origin = origin;
        state.topLevelChanged = true;
      }
      for (const auto& [id, set] : state.sets)
      {
        const glm::dvec3 offset = glm::abs(set.instances.origin - origin);
        reach = std::max(reach,
          set.bounds.Reach() + static_cast<float>(std::max({ offset.x, offset.y, offset.z })));
      }

      for (auto& [id, set] : state.sets)
      {
        if (set.instancesChanged || (set.count && 2.0f * reach > set.builtReach))
        {
          state.SendInstances(set, reach);
          state.topLevelChanged = true;
        }
        if (set.coloursChanged)
        {
          state.SendColours(set);
          state.recordsChanged = true;
        }
      }
      // The top level says which hit group and which pass a set belongs to.
      for (const auto& [id, set] : state.sets)
      {
        state.topLevelChanged |= set.visible && set.count &&
          !(set.group == set.placedGroup && set.Translucent() == set.placedTranslucent);
      }
      if (state.topLevelChanged)
      {
        state.BuildTopLevel();
        state.recordsChanged = true;
      }
      if (state.recordsChanged)
      {
        state.FillRecords();
        ++state.version;
      }
      state.topLevelChanged = state.recordsChanged = false;
    });
}

} // namespace rtg
