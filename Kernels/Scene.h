#pragma once

#include "Glyphs.h"

#include <cstdint>
#include <map>
#include <functional>
#include <memory>

namespace rtg
{

class Device;

/// Work done and memory held; every count only grows. Seconds are wall-clock. The scenes and tracers of a view count in
/// one object.
struct Statistics
{
  std::uint64_t structureBuilds = 0; ///< trees, or bottom-level structures of the driver, built
  std::uint64_t topLevelBuilds = 0;  ///< lists of the visible sets, or top-level structures of the driver, built
  std::uint64_t instanceUploads = 0; ///< glyph sets whose centers, sizes, rotations, exponents were sent
  std::uint64_t colorUploads = 0;    ///< glyph sets whose colors were sent
  std::uint64_t sorts = 0;           ///< glyph sets put into another order; new instances may do with the last one's
  std::uint64_t programsAhead = 0;   ///< that are still to be compiled ahead on the device
  std::uint64_t pipelineBuilds = 0;  ///< programs compiled for these tracers, without those of others that they use
  std::uint64_t dispatches = 0;      ///< images or sample batches traced
  std::uint64_t primaryRays = 0;
  std::uint64_t deviceBytes = 0; ///< held now, not a running count
  double sortSeconds = 0.0;
  double buildSeconds = 0.0;
  double uploadSeconds = 0.0;
  double traceSeconds = 0.0;
  double denoiseSeconds = 0.0;
};

/// The glyph sets of one view and their acceleration structures on one device.
/// Setters only record; Commit() uploads and builds what has changed and nothing else. A set that is not visible holds
/// no memory of the device unless it is kept. A Commit() that throws leaves the scene empty to tracers; the next one
/// goes on where it stopped. Not thread-safe. All members throw rtg::Error and nothing else.
class Scene
{
public:
  using SetId = std::uint32_t;

  explicit Scene(
    std::shared_ptr<Device> device, std::shared_ptr<Statistics> statistics = std::make_shared<Statistics>());
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Adds an empty, visible set.
  SetId Add();
  void Remove(SetId id);

  void SetInstances(SetId id, GlyphInstances instances);
  void SetColors(SetId id, GlyphColors colors);
  void SetMaterial(SetId id, const Material& material);
  void SetImages(SetId id, const PeriodicImages& images);
  /// `keep`: what of the set is on the device stays there, for it to be visible again at once.
  void SetVisible(SetId id, bool visible, bool keep = false);
  /// False: camera rays do not see the set, which shades the others all the same: another process shows it.
  void SetCameraVisible(SetId id, bool visible);

  const GlyphInstances& InstancesOf(SetId id) const;
  /// Index into the set's GlyphInstances of a glyph id as Image::glyphIds has it, of an image of these instances.
  std::uint32_t OriginalGlyph(SetId id, std::uint32_t glyphId) const;

  /// `progress` gets the fraction of the work done, in [0, 1], after each stage.
  void Commit(const std::function<void(double fraction)>& progress = {});

  const Statistics& GetStatistics() const;

  struct State; ///< device side; for Tracer
  State& GetState() { return *this->state_; }

private:
  std::unique_ptr<State> state_;
};

} // namespace rtg
