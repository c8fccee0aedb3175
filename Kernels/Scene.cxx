#include "SceneState.h"

#include "GlyphBoxes.h"
#include "GlyphChecks.h"
#include "Vulkan/Batch.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace rtg
{

namespace
{

// RTGLYPHS_STRUCTURE (boxes or tree) overrides, for tests and measurements.
Structure ChooseStructure(const Device& device, bool rayQueries)
{
  const char* variable = std::getenv("RTGLYPHS_STRUCTURE");
  const std::string wanted = variable ? variable : "";
  if (wanted != "boxes" && wanted != "tree" && !wanted.empty())
  {
    throw Error("Ray Traced Glyphs: RTGLYPHS_STRUCTURE is '" + wanted + "'; it can be 'boxes' or 'tree'.");
  }
  if (wanted == "boxes" && !rayQueries)
  {
    throw Error("Ray Traced Glyphs: RTGLYPHS_STRUCTURE is 'boxes', for which '" + device.Name() +
      "' lacks VK_KHR_ray_query; unset it.");
  }
  // The plugin's BVH is faster on a CPU, and on a GPU without ray-tracing hardware.
  const bool trees = wanted.empty() ? device.IsCpu() || !rayQueries : wanted == "tree";
  return trees ? Structure::Tree : Structure::Boxes;
}

// The least of the boxes' largest sides.
float SmallestExtent(const std::vector<Box>& boxes)
{
  float smallest = INFINITY;
  for (const Box& box : boxes)
  {
    const glm::vec3 extent = box.upper - box.lower;
    smallest = std::min(smallest, std::max({ extent.x, extent.y, extent.z }));
  }
  return smallest;
}

} // namespace

Scene::State::State(std::shared_ptr<Device> d, std::shared_ptr<Statistics> s)
  : device(std::move(d))
  , mostInstances(device->GetState().structureLimits.maxInstanceCount)
  , structure(ChooseStructure(*device, device->GetState().rayQueries))
  , statistics(std::move(s))
{
  if (this->structure == Structure::Boxes)
  {
    const std::uint64_t most = this->device->GetState().structureLimits.maxPrimitiveCount;
    this->mostElements = static_cast<std::size_t>(std::min<std::uint64_t>(this->mostElements, most));
  }
}

Scene::Scene(std::shared_ptr<Device> device, std::shared_ptr<Statistics> statistics)
  : state_(std::make_unique<State>(std::move(device), std::move(statistics)))
{
}

Scene::~Scene() = default;

Scene::SetId Scene::Add()
{
  return this->state_->device->GetState().Guard("adding glyphs",
    [&]
    {
      const SetId id = this->state_->nextId++;
      this->state_->sets[id];
      return id;
    });
}

void Scene::Remove(SetId id)
{
  const auto found = this->state_->sets.find(id);
  if (found != this->state_->sets.end())
  {
    this->state_->Withdraw(found->second);
    this->state_->sets.erase(found);
  }
}

void Scene::SetInstances(SetId id, GlyphInstances instances)
{
  GlyphSet& set = this->state_->Find(id);
  if (instances.shape == Shape::Mesh)
  {
    CheckMesh(instances.mesh.get(), instances.motion, this->state_->mostElements);
  }
  CheckInstances(instances, this->state_->mostElements);
  if (!HasExponents(instances.shape))
  {
    instances.exponents3 = std::vector<glm::vec3>();
  }
  if (instances.shape != Shape::Polynomial)
  {
    instances.polynomialDegree = 0;
    if (instances.shape != Shape::SweptEllipsoid)
    {
      instances.polynomials = {};
    }
  }
  set.count = instances.Count();
  set.translucentInstances = IsTranslucent(instances);
  set.instances = std::move(instances);
  set.instancesChanged = true;
  set.measured = false;
  set.boxes = std::vector<Box>(); // = {} would keep the memory
  // Colors are by glyph: those of the old glyphs mean nothing now.
  set.colors = {};
  set.colorsChanged = true;
  set.translucentColors = false;
}

void Scene::SetColors(SetId id, GlyphColors colors)
{
  GlyphSet& set = this->state_->Find(id);
  CheckColors(set.instances, colors);
  set.translucentColors = AnyTranslucent(colors);
  set.colors = std::move(colors);
  set.colorsChanged = true;
}

void Scene::SetMaterial(SetId id, const Material& material)
{
  GlyphSet& set = this->state_->Find(id);
  CheckSection(material.section);
  set.material = material;
  this->state_->recordsChanged = true;
}

void Scene::SetImages(SetId id, const PeriodicImages& images)
{
  GlyphSet& set = this->state_->Find(id);
  CheckImages(images);
  this->state_->topLevelChanged |= !(set.images == images);
  set.images = images;
}

void Scene::SetVisible(SetId id, bool visible, bool keep)
{
  GlyphSet& set = this->state_->Find(id);
  this->state_->topLevelChanged |= set.visible != visible;
  set.visible = visible;
  set.kept = keep;
}

void Scene::SetCameraVisible(SetId id, bool visible)
{
  this->state_->Find(id).cameraVisible = visible;
}

const GlyphInstances& Scene::InstancesOf(SetId id) const
{
  return this->state_->Find(id).instances;
}

std::uint32_t Scene::OriginalGlyph(SetId id, std::uint32_t glyph) const
{
  const GlyphSet& set = this->state_->Find(id);
  const auto& order = set.instances.identifyTriangles ? set.placed.mesh.order : set.sorted.order;
  if (!order.empty() && glyph >= order.size())
  {
    throw Error("Ray Traced Glyphs: glyph " + std::to_string(glyph) + " of a set of " + std::to_string(order.size()) +
      " is needed; render again.");
  }
  return order.empty() ? glyph : order[glyph];
}

const Statistics& Scene::GetStatistics() const
{
  this->state_->statistics->deviceBytes = this->state_->device->HeldBytes();
  return *this->state_->statistics;
}

std::uint64_t SceneRecords::NextVersion()
{
  static std::atomic<std::uint64_t> last{ 0 };
  return ++last;
}

bool Scene::State::Shows(bool translucent) const
{
  return std::any_of(this->sets.begin(), this->sets.end(),
    [&](const auto& entry) { return entry.second.Shown() && entry.second.Translucent() == translucent; });
}

GlyphSet& Scene::State::Find(SetId id)
{
  const auto found = this->sets.find(id);
  if (found == this->sets.end())
  {
    throw Error("Ray Traced Glyphs: the scene has no glyph set of number " + std::to_string(id) + "; add it first.");
  }
  return found->second;
}

float Scene::State::Measure()
{
  for (auto& [id, set] : this->sets)
  {
    if (set.Shown() && !set.measured)
    {
      set.boxes = ListedBoxes(set.instances);
      set.bounds = UnionOf({ set.instances, set.boxes });
      set.smallest = set.instances.shape == Shape::Mesh ? SmallestExtent(set.boxes) : 0.0f;
      set.measured = true;
      this->progress.Add(set.count);
    }
  }
  // The scene's origin is that of its first visible set: near what is looked at.
  const auto first =
    std::find_if(this->sets.begin(), this->sets.end(), [](const auto& entry) { return entry.second.Shown(); });
  const glm::dvec3 newOrigin = first == this->sets.end() ? glm::dvec3(0.0) : first->second.instances.origin;
  this->topLevelChanged |= newOrigin != this->records.origin;
  this->records.origin = newOrigin;
  float reach = 0.0f;
  for (const auto& [id, set] : this->sets)
  {
    if (set.Shown())
    {
      const glm::dvec3 offset = glm::abs(set.instances.origin - newOrigin) + set.ImageReach();
      reach = std::max(reach, set.bounds.Reach() + static_cast<float>(std::max({ offset.x, offset.y, offset.z })));
    }
  }
  return reach;
}

PlacedGlyphs Scene::State::Withdraw(GlyphSet& set)
{
  if (set.placed.any)
  {
    this->DropTopLevels();
  }
  return std::exchange(set.placed, PlacedGlyphs());
}

void Scene::State::DropTopLevels()
{
  SceneRecords none;
  none.origin = this->records.origin;
  this->records = std::move(none);
  this->topLevelChanged = true;
}

std::uint64_t Scene::State::CountStages() const
{
  constexpr std::uint64_t stagesPerGlyph = 4;
  std::uint64_t stages = 0;
  for (const auto& [id, set] : this->sets)
  {
    stages += set.Shown() && (set.instancesChanged || !set.measured) ? stagesPerGlyph * set.count : 0;
  }
  return stages;
}

void CommitProgress::Add(std::size_t glyphs)
{
  this->done += glyphs;
  if (this->report && this->stages > 0)
  {
    // The callback may use the device itself, for instance draw another view: that must not wait for the batch.
    Batch* const batch = std::exchange(Device::State::batch, nullptr);
    this->report(std::min(1.0, static_cast<double>(this->done) / static_cast<double>(this->stages)));
    Device::State::batch = batch;
  }
}

void Scene::Commit(const std::function<void(double)>& progress)
{
  State& state = *this->state_;
  state.progress = { progress, state.CountStages() };
  Device::State& vulkan = state.device->GetState();
  vulkan.Guard("sending glyphs",
    [&]
    {
      Batch batch(vulkan);
      // The batch's data are on the device after it has run.
      std::vector<GlyphSet*> sent;
      try
      {
        state.SendChanges(sent);
        batch.Run();
      }
      catch (...)
      {
        std::for_each(sent.begin(), sent.end(), [&](GlyphSet* set) { state.Withdraw(*set); });
        state.DropTopLevels();
        throw;
      }
      for (GlyphSet* set : sent)
      {
        set->instancesChanged = set->colorsChanged = false;
      }
      state.topLevelChanged = state.recordsChanged = false;
    });
}

// Puts changes into the device's batch; `sent`: sets of which something is in it.
void Scene::State::SendChanges(std::vector<GlyphSet*>& sent)
{
  for (auto& [id, set] : this->sets)
  {
    if (!set.Shown() && !set.kept)
    {
      this->Withdraw(set);
      set.boxes = std::vector<Box>();
    }
  }
  const float reach = this->Measure();
  for (auto& [id, set] : this->sets)
  {
    if (!set.Shown())
    {
      continue;
    }
    // The scene's origin may have moved.
    const bool otherMesh =
      set.instances.shape == Shape::Mesh && this->NeedsMeshTree(set) != set.placed.variants.Has(device::MESH_TREE);
    if (set.instancesChanged || !set.placed.any || 2.0f * reach > set.placed.builtReach || otherMesh)
    {
      sent.push_back(&set);
      this->Place(set, reach);
    }
    else if (set.colorsChanged)
    {
      sent.push_back(&set);
      this->SendArrays(set, set.placed, device::COLORS | device::END_COLORS);
      this->recordsChanged = true;
    }
    // The top level says which pass a set belongs to.
    this->topLevelChanged |= set.Mask() != set.listedMask;
  }
  if (this->topLevelChanged)
  {
    this->BuildTopLevels();
    this->recordsChanged = true;
  }
  if (this->recordsChanged)
  {
    this->FillRecords();
    this->records.version = SceneRecords::NextVersion();
  }
}

} // namespace rtg
