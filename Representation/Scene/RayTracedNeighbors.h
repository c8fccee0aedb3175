/**
 * Light across ranks: each rank gets the glyphs and triangles of the others that overlap its neighborhood, which
 * shade what it shows and are invisible themselves.
 *
 * A rank's neighborhood is the box round what it shows, grown by the distance from which things occlude. What comes
 * from others is exchanged again only when something of any rank has changed.
 */
#ifndef RayTracedNeighbors_h
#define RayTracedNeighbors_h

#include "Glyphs.h"
#include "Scene.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rtglyphs
{

class RayTracedNeighbors
{
public:
  /**
   * This rank's part of a display. Displays have the same numbers on all ranks.
   */
  struct Shown
  {
    int Display = 0;
    const rtg::GlyphInstances* Instances = nullptr;
    const rtg::GlyphColors* Colors = nullptr;
  };

  /**
   * To be called by all ranks at once. `changed`: what this rank shows is not what it was at the last call; only then,
   * on some rank, `shown` is called. `displays` is the number of displays. Returns what went wrong on this rank;
   * nothing is sent when something has gone wrong on any.
   */
  std::string Exchange(double reach, bool changed, int displays, const std::function<std::vector<Shown>()>& shown);

  void Clear();

  /**
   * Grows with each exchange.
   */
  std::uint64_t GetVersion() const { return this->Version; }

  /**
   * Brings the kernels' scene of that number up to date. `material` is that of a display.
   */
  void Commit(rtg::Scene& scene, std::uint64_t sceneNumber, const std::function<rtg::Material(int display)>& material);

  ///@{
  /**
   * Of the last exchange: glyphs or triangles that came from other ranks, and the bytes in which they came.
   */
  std::uint64_t GetNumberOfGlyphs() const { return this->Glyphs; }
  std::uint64_t GetNumberOfBytes() const { return this->Bytes; }
  ///@}

private:
  struct Set
  {
    int Display = 0;
    rtg::GlyphInstances Instances;
    rtg::GlyphColors Colors;
  };
  void SendNear(const std::vector<Shown>& sets);
  void Receive(const std::vector<char>& bytes);

  std::vector<Set> Sets;
  std::uint64_t Version = 0, Glyphs = 0, Bytes = 0;
  double Reach = -1.0; // of the last exchange; negative: there was none
  // Its part in the kernels.
  std::uint64_t SentVersion = 0, SentScene = 0;
  std::vector<rtg::Scene::SetId> Sent;
  std::vector<rtg::Material> SentMaterials;
};

} // namespace rtglyphs

#endif
