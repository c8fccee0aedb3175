#include "RayTracedImages.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkProcessModule.h"

#include <algorithm>
#include <chrono>

namespace
{
// Most images that are kept: those of two eyes, and as many of a capture, in each pass.
constexpr std::size_t mostEntries = 4 * rtglyphs::RayTracedImages::Passes;
// Frames after which an image that none of them has used is given up.
constexpr std::uint64_t keptFrames = 6;

// The device lives as long as ParaView's session, and with it its compiled programs: a view that is opened after the
// last one with glyphs was closed waits for none of them. The end of the session lets it go, after what is being
// compiled: later, the driver destroys what threads that compile would use. Scripts may exit when they have
// disconnected.
std::shared_ptr<rtg::Device> DeviceOfProcess()
{
  static auto* const kept = new std::shared_ptr<rtg::Device>;
  static const vtkNew<vtkCallbackCommand> end;
  std::shared_ptr<rtg::Device> device = rtg::Device::Shared();
  if (vtkProcessModule* const module = vtkProcessModule::GetProcessModule())
  {
    end->SetCallback([](vtkObject*, unsigned long, void*, void*) { kept->reset(); });
    for (const auto event : { vtkCommand::ExitEvent, vtkCommand::ConnectionClosedEvent })
    {
      if (!module->HasObserver(event, end))
      {
        module->AddObserver(event, end);
      }
    }
    *kept = device;
  }
  return device;
}
}

// The tracer of an entry's image.
class rtglyphs::RayTracedImages::Source : public rtg::ImageSource
{
public:
  Source(rtglyphs::RayTracedImages& images, Entry& entry)
    : Images(images)
    , Own(entry)
  {
  }

  bool Prepare() override
  {
    if (!this->Images.Device || this->Images.Device->Lost())
    {
      this->Images.Scene.reset();
      this->Images.Resources.reset();
      for (auto& [place, entry] : this->Images.Entries)
      {
        entry->Tracer.reset();
        entry->PreviewTracer.reset();
      }
      this->Images.Device.reset();
      this->Images.Device = DeviceOfProcess();
    }
    if (!this->Images.Resources)
    {
      this->Images.Resources = rtg::MakeTracerResources(this->Images.Device, this->Images.Counters);
    }
    if (!this->Images.Scene)
    {
      this->Images.Scene = std::make_unique<rtg::Scene>(this->Images.Device, this->Images.Counters);
      ++this->Images.SceneNumber;
    }
    try
    {
      this->Images.CommitTo(*this->Images.Scene, this->Images.SceneNumber);
    }
    catch (...)
    {
      // A partial upload must not be taken for a complete one.
      this->Images.Scene.reset();
      throw;
    }
    const bool kept = this->Own.Tracer && this->Own.SceneNumber == this->Images.SceneNumber;
    if (!kept)
    {
      this->Own.Tracer = std::make_unique<rtg::Tracer>(this->Images.Resources);
      this->Own.PreviewTracer = std::make_unique<rtg::Tracer>(this->Images.Resources);
      this->Own.SceneNumber = this->Images.SceneNumber;
    }
    return kept;
  }

  rtg::Image
  Trace(const rtg::ImageView& view, const rtg::TraceSettings& settings, const rtg::Interrupt& interrupt) override
  {
    return this->Own.Tracer->Trace(*this->Images.Scene, view.camera, view.lights, settings, view.pass, interrupt);
  }

  rtg::Image Resume(std::uint32_t samples, const rtg::Interrupt& interrupt) override
  {
    return this->Own.Tracer->Resume(*this->Images.Scene, samples, interrupt);
  }

  rtg::Image
  Preview(const rtg::ImageView& view, const rtg::TraceSettings& settings, const rtg::Interrupt& interrupt) override
  {
    return this->Own.PreviewTracer->Trace(
      *this->Images.Scene, view.camera, view.previewLights, settings, view.pass, interrupt);
  }

  void Expect(const rtg::ImageView& view, const std::vector<rtg::TraceSettings>& settings) override
  {
    this->Own.Tracer->CompileAhead(*this->Images.Scene, view.lights, settings);
  }

  std::function<std::vector<std::uint32_t>()> Denoise(std::stop_token stop) override
  {
    return this->Own.Tracer->Denoise(std::move(stop));
  }

  bool HasDevice() const override { return this->Images.Device && !this->Images.Device->Lost(); }
  bool IsDeviceLost() const override { return this->Images.Device && this->Images.Device->Lost(); }
  std::uint64_t HeldBytes() const override { return this->Images.Device ? this->Images.Device->HeldBytes() : 0; }

  double Now() const override
  {
    const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
    return now.count();
  }

private:
  rtglyphs::RayTracedImages& Images;
  Entry& Own;
};

//----------------------------------------------------------------------------
void rtglyphs::RayTracedImages::StartFrame(bool capture)
{
  this->Capture = capture;
  const auto stays = [&](const auto& kept) { return capture && !kept.second->Capture; };
  for (const auto& kept : this->Entries)
  {
    kept.second->LastUsed += stays(kept); // does not age
  }
  std::erase_if(this->Entries, [&](const auto& kept) { return kept.second->LastUsed + keptFrames < this->Frame; });
  while (this->Entries.size() > mostEntries)
  {
    const auto oldest = std::min_element(this->Entries.begin(), this->Entries.end(),
      [&](const auto& a, const auto& b)
      { return std::pair(stays(a), a.second->LastUsed) < std::pair(stays(b), b.second->LastUsed); });
    if (stays(*oldest))
    {
      break;
    }
    this->Entries.erase(oldest);
  }
  ++this->Frame;
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedImages::Entry& rtglyphs::RayTracedImages::Get(const Place& place)
{
  std::unique_ptr<Entry>& entry = this->Entries[place];
  if (!entry)
  {
    entry = std::make_unique<Entry>();
  }
  entry->LastUsed = this->Frame;
  entry->Capture &= this->Capture;
  return *entry;
}

//----------------------------------------------------------------------------
std::array<rtglyphs::RayTracedImages::Entry*, rtglyphs::RayTracedImages::Passes>
rtglyphs::RayTracedImages::GetLast(Place place)
{
  std::array<Entry*, Passes> last{};
  std::uint64_t frame = 1;
  for (place.Pass = 0; place.Pass < Passes; ++place.Pass)
  {
    const auto found = this->Entries.find(place);
    if (found != this->Entries.end() && found->second->Shown >= frame)
    {
      found->second->LastUsed = this->Frame;
      last[place.Pass] = found->second.get();
      frame = found->second->Shown;
    }
  }
  for (Entry*& entry : last)
  {
    entry = entry && entry->Shown == frame ? entry : nullptr;
  }
  return last;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedImages::Send(
  Entry& entry, const rtg::Image& image, const rtg::ScreenEffects& effects, vtkOpenGLRenderWindow* window)
{
  const std::uint64_t version = entry.Image.Version();
  if (entry.Quad.Shows(version) && entry.Effects == effects)
  {
    return;
  }
  entry.Effects = effects;
  if (!effects.Any())
  {
    entry.Quad.SetImage(window, image.width, image.height, image.color, image.depth, version);
    return;
  }
  rtg::OutlinedSets sets;
  sets.kind = [this](std::uint32_t set)
  {
    const rtg::GlyphInstances& glyphs = this->Scene->InstancesOf(set);
    const bool tubes = glyphs.shape == rtg::Shape::RoundCone || glyphs.shape == rtg::Shape::SweptEllipsoid;
    return glyphs.identifyTriangles ? rtg::OutlinedSets::Kind::Surface
      : tubes                       ? rtg::OutlinedSets::Kind::Tubes
                                    : rtg::OutlinedSets::Kind::Glyphs;
  };
  sets.piece = [this](std::uint32_t set, std::uint32_t glyph)
  {
    const std::uint32_t number = this->Scene->OriginalGlyph(set, glyph);
    const glm::dvec3 size = this->Scene->InstancesOf(set).SizeOf(number);
    return rtg::OutlinedSets::Piece{ number, 0.5 * (size.y + size.z) };
  };
  sets.pathLength = [this](std::uint32_t set, std::uint32_t glyph)
  {
    const rtg::GlyphInstances& glyphs = this->Scene->InstancesOf(set);
    const rtg::GlyphMotion& motion = glyphs.identifyTriangles ? glyphs.mesh->motion : glyphs.motion;
    if (!motion.Moves())
    {
      return 0.0;
    }
    const std::uint32_t original = this->Scene->OriginalGlyph(set, glyph);
    const std::size_t mover = glyphs.identifyTriangles ? glyphs.mesh->triangles[original].x : original;
    return glm::distance(
      motion.Displacement(mover, glyphs.motion.shutterOpen), motion.Displacement(mover, glyphs.motion.shutterClose));
  };
  const rtg::EffectImage shown = rtg::Apply(effects, image, entry.Image.View().camera, sets);
  entry.Quad.SetImage(window, image.width, image.height, shown.colors.data(), shown.depths.data(), version);
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedImages::Draw(
  Entry& entry, bool again, vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper)
{
  entry.Quad.Draw(renderer, actor, mapper, rtglyphs::RayTracedImageQuad::BLEND);
  entry.Drawn = this->Frame;
  entry.Shown = again ? entry.Shown : entry.Drawn;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedImages::DrawKept(vtkRenderer* renderer, vtkTextureObject* pixels)
{
  for (auto& [place, entry] : this->Entries)
  {
    if (entry->Drawn == this->Frame)
    {
      entry->Quad.DrawKept(renderer, pixels);
    }
  }
}

//----------------------------------------------------------------------------
rtglyphs::RayTracedImages::Entry* rtglyphs::RayTracedImages::FindSame(const rtg::ImageView& view)
{
  for (const auto& [place, entry] : this->Entries)
  {
    const rtg::ImageView& other = entry->Image.View();
    if (entry->Image.GetState() != rtg::ProgressiveImage::State::Failed && entry->Image.IsComplete() &&
      other.settings.parts == 1 && other.pass == view.pass && other.sceneVersion == view.sceneVersion &&
      other.camera.IsNear(view.camera) && other.settings.width == view.settings.width &&
      other.settings.height == view.settings.height)
    {
      return entry.get();
    }
  }
  return nullptr;
}

//----------------------------------------------------------------------------
const rtg::Image* rtglyphs::RayTracedImages::Update(
  Entry& entry, const rtg::ImageView& view, const rtg::ImageEffort& effort, const rtg::Interrupt& interrupt)
{
  Source source(*this, entry);
  return entry.Image.Update(source, view, effort, interrupt);
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedImages::DropImages()
{
  this->Scene.reset();
  this->Entries.clear();
}

//----------------------------------------------------------------------------
rtg::Statistics rtglyphs::RayTracedImages::GetStatistics() const
{
  rtg::Statistics now = this->Resources ? rtg::StatisticsOf(*this->Resources) : *this->Counters;
  now.deviceBytes = this->Device ? this->Device->HeldBytes() : 0;
  return now;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedImages::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& [place, entry] : this->Entries)
  {
    entry->Quad.ReleaseGraphicsResources(window);
  }
}
