/**
 * @class   vtkRayTracedMapper
 * @brief   what is traced of one actor: instances and colors, each built when what they depend on changes
 *
 * Subclasses make glyphs or surfaces of the points. Rendering draws nothing: vtkRayTracedScene draws the image of all
 * mappers of a renderer. For a selector, rendering invokes vtkCommand::RenderEvent with the actor, and the scene draws
 * the ids.
 */
#ifndef vtkRayTracedMapper_h
#define vtkRayTracedMapper_h

#include "Glyphs.h"
#include "RayTracedBlocks.h"
#include "RayTracedCache.h"
#include "RayTracedParallel.h"
#include "RayTracedOriginalIds.h"
#include "vtkDataObject.h"
#include "vtkMapper.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkActor;
class vtkDataSetAttributes;
class vtkPolyData;
class vtkUnsignedCharArray;

class vtkRayTracedMapper : public vtkMapper
{
public:
  vtkTypeMacro(vtkRayTracedMapper, vtkMapper);

  ///@{
  /**
   * Data of glyphs or surfaces: blocks, and their points one after the other. Not an input of the mapper:
   * the inputs of a mapper are what VTK's exporters write, and the points are not what is shown.
   */
  void SetBlocks(const rtglyphs::RayTracedBlocks& blocks);
  vtkPolyData* GetPolyData() const { return this->PolyData; }
  ///@}

  /**
   * The result of GetBounds(), before the actor's transform; it computes none itself.
   * Compositing between ranks and selecting leave out what lies outside.
   */
  void SetKnownBounds(const double bounds[6]) { std::copy_n(bounds, 6, this->Bounds); }

  /**
   * Color of what RayTracedArrays::Selected has a 1 for: glyphs of such points, lines that are such cells, and pieces
   * of tubes on both sides of such points. Default is magenta.
   */
  void SetSelectionColor(const std::array<double, 3>& color);

  /**
   * The cut, which the caller may change later.
   */
  void SetSection(std::shared_ptr<const rtg::Section> section) { this->Section = std::move(section); }

  /**
   * The periodic images, in world coordinates, which the caller may change later.
   */
  void SetImages(std::shared_ptr<const rtg::PeriodicImages> images) { this->Images = std::move(images); }

  /**
   * Receives the progress of building instances.
   */
  void SetBuildProgress(const rtglyphs::RayTracedParallel::Progress& progress) { this->BuildProgress = progress; }

  ///@{
  /**
   * For the scene. Update() brings instances and colors up to date, whose versions then differ from all earlier ones of
   * any mapper; it may throw std::bad_alloc and is then to be called again. Instances that are built again and equal
   * `sent`, those of GetInstanceVersion() (null: nobody has them), keep their version. NeedsBuild() says whether it
   * would build instances. TakeInstances() hands them over, and builds them again for a second taker; GetInstances() is
   * null when they have been taken.
   */
  void Update(vtkActor* actor, const rtg::GlyphInstances* sent);
  bool NeedsBuild(vtkActor* actor) const;
  std::uint64_t GetInstanceVersion() const { return this->InstanceVersion; }
  std::uint64_t GetColorVersion() const { return this->ColorVersion; }
  virtual rtg::GlyphInstances TakeInstances(vtkActor* actor);
  const rtg::GlyphInstances* GetInstances() const { return this->InstancesTaken ? nullptr : &this->Instances; }
  const rtg::GlyphColors& GetColors() const { return this->Colors; }
  virtual void AddToMaterial(rtg::Material&) const {}
  const rtg::Section& GetSection() const { return *this->Section; }
  const rtg::PeriodicImages& GetImages() const { return *this->Images; }
  bool IsTranslucent() const { return this->Translucent || this->TranslucentInstances; }
  ///@}

  ///@{
  /**
   * Counters: glyphs or triangles shown, those left out because something of them is not finite, how often instances
   * and colors were built, and the seconds of that.
   */
  vtkIdType GetNumberOfGlyphs() const { return this->OriginalIds.size(); }
  vtkIdType GetSkippedGlyphs() const { return this->Skipped; }
  std::uint64_t GetInstanceBuilds() const { return this->InstanceBuilds; }
  std::uint64_t GetColorBuilds() const { return this->ColorBuilds; }
  double GetInstanceSeconds() const { return this->InstanceSeconds; }
  double GetColorSeconds() const { return this->ColorSeconds; }
  ///@}

  ///@{
  /**
   * The representation's work on its data before rendering: how often, and its seconds.
   */
  struct DataStatistics
  {
    unsigned int Representation = 0; // vtkPVDataRepresentation::GetUniqueIdentifier(); 0: of a layer of another one
    std::uint64_t Gathers = 0, BoundsBuilds = 0;
    double GatherSeconds = 0.0, BoundsSeconds = 0.0;
  };
  void SetDataStatistics(const DataStatistics& statistics) { this->OfData = statistics; }
  const DataStatistics& GetDataStatistics() const { return this->OfData; }
  ///@}

  ///@{
  /**
   * Missing input that the user must choose; empty: none. In a window, where choices are made one after the other, no
   * warning says so.
   */
  const std::string& GetMissingInput() const { return this->MissingInput; }
  void SetInWindow(bool inWindow) { this->InWindow = inWindow; }
  ///@}

  ///@{
  /**
   * The next frames show something else in its place, and later ones the mapper again: its glyphs stay on the device.
   * Default is false.
   */
  void SetSuspended(bool suspended) { this->Suspended = suspended; }
  bool IsSuspended() const { return this->Suspended; }
  ///@}

  ///@{
  /**
   * Warnings that came up since the last call, for the scene to report. The counts of a message change with each time
   * step and differ between ranks; without them the result is the same.
   */
  std::vector<std::string> TakeMessages() { return std::exchange(this->NewMessages, {}); }
  static std::string WithoutCounts(const std::string& message);
  ///@}

  /**
   * Pick result of a position on a glyph or triangle.
   */
  struct Origin
  {
    vtkIdType Id =
      -1; // of the point or cell; -1: there is none to select, but nothing behind it can be selected either
    unsigned int CompositeIndex = 0;
    int Process = -1; // -1: this one
  };
  /**
   * `association` is a vtkDataObject::FieldAssociations, `position` in world coordinates. Of a glyph that is no longer
   * there nothing can be selected.
   */
  Origin OriginOf(vtkIdType glyph, int association, const double position[3])
  {
    const bool known = this->PolyData && glyph >= 0 && glyph < this->GetNumberOfGlyphs();
    return known ? this->FindOrigin(glyph, association, position) : Origin();
  }

  /**
   * FieldAssociations of what a glyph or triangle primarily stands for.
   */
  virtual int GetNaturalAssociation() const = 0;

  // vtkMapper
  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  double* GetBounds() override { return this->Bounds; }
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  bool GetSupportsSelection() override { return true; }

protected:
  vtkRayTracedMapper();
  ~vtkRayTracedMapper() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  ///@{
  /**
   * For subclasses. Instances are built when their settings or arrays have changed; colors when the points chosen,
   * their arrays, the lookup table or anything of ColorState() has.
   */
  virtual bool HaveSettingsChanged() const = 0;
  virtual std::vector<vtkObject*> InstanceInputs(vtkPolyData* points) const = 0;
  virtual void BuildInstances(vtkPolyData* points, vtkActor* actor) = 0;
  virtual void BuildColors(vtkPolyData* points) = 0;
  virtual std::vector<vtkMTimeType> ColorState() const { return {}; }
  virtual bool NeedsSolidColor() const { return false; } // even where no glyph has a color
  virtual Origin FindOrigin(vtkIdType glyph, int association, const double position[3]) = 0;
  ///@}

  /**
   * A number that no mapper of this process has had as a version.
   */
  static std::uint64_t NewVersion();

  static std::uint32_t Pack(const std::array<double, 4>& rgba);

  /**
   * A tuple of RGB or RGBA bytes; without an alpha that of `rgba` stays.
   */
  static void ReadColor(vtkUnsignedCharArray* colors, vtkIdType tuple, std::array<double, 4>& rgba);

  ///@{
  /**
   * Which points or cells are selected, null where none is; and the color of what is, with the opacity that a packed
   * color has.
   */
  static vtkUnsignedCharArray* Selected(vtkDataSetAttributes* data);
  std::uint32_t Tinted(std::uint32_t color) const { return this->SelectionColor | (color & 0xff000000u); }
  ///@}

  ///@{
  /**
   * Maps the arrays that color the blocks, each block by itself, as VTK's mappers do. Where values of points are
   * interpolated before they are mapped, all by one table, and no block has a color or opacity, it gives values in
   * [0, 1], negative for NaN, and that table (rtg::GlyphColors, rtg::TriangleMesh). `what`: what messages call it.
   * ColorOf() is the color of a point, or of its cell, with the solid color of the block where it has no other.
   */
  struct MappedColors
  {
    struct OfBlock
    {
      vtkSmartPointer<vtkUnsignedCharArray> Colors; // null: it has none
      int Association = 0;                          // 0 of points, 1 of cells, 2 one for the block
    };
    std::vector<OfBlock> Blocks;
    bool Any = false, OfCells = false; // some block has colors; some of those are of cells
    bool OneTable = true;
    std::vector<float> Values; // of points
    std::vector<std::uint32_t> Table;
  };
  MappedColors MapColors(bool interpolateValues, const char* what, std::vector<std::string>& messages);
  std::array<double, 4> ColorOf(const MappedColors& mapped, vtkIdType point, vtkIdType cell) const;
  ///@}

  /**
   * Whether some block has its own color or opacity.
   */
  bool HasBlockColors() const;

  /**
   * The number of a point's block.
   */
  std::size_t BlockOf(vtkIdType point) const;

  /**
   * Where a point and its cell, -1 for none, come from; of cells, or of points.
   */
  Origin OriginOfPoint(vtkIdType point, vtkIdType cell, bool ofCells) const;

  /**
   * The missing input of instances, and its `messages`; with the latter, but
   * not in a window.
   */
  void ReportInstances(std::vector<std::string> messages, const std::string& missingInput);
  void Report(const std::vector<std::string>& messages, std::vector<std::string>& reported);

  /**
   * Colors that were built, which have a new version where they differ from the last ones, and what is to be reported
   * of them.
   */
  void SetColors(rtg::GlyphColors colors, const std::vector<std::string>& messages);

  std::vector<rtglyphs::RayTracedBlocks::Block> Blocks;
  rtglyphs::RayTracedRanges Hidden; // points
  std::uint64_t BlocksVersion = 0;
  rtglyphs::RayTracedOriginalIds OriginalIds; // point of each glyph, cell of each triangle
  vtkIdType Skipped = 0;
  rtg::GlyphInstances Instances; // unless they are taken
  std::string MissingInput;
  bool InWindow = false, Suspended = false;
  rtg::GlyphColors Colors;
  bool Translucent = false, TranslucentInstances = false; // by colors, by instances
  std::array<double, 3> SolidColor{ { 1.0, 1.0, 1.0 } }; // diffuse color of glyphs without a color, where some have one
  std::uint64_t InstanceVersion = 0, ColorVersion = 0, InstanceBuilds = 0, ColorBuilds = 0;
  double InstanceSeconds = 0.0, ColorSeconds = 0.0;
  rtglyphs::RayTracedParallel::Progress BuildProgress;
  std::vector<std::string> ReportedInstances, ReportedColors, ReportedSizes, NewMessages;

private:
  // Dependencies of instances besides the settings. Time stamps identify arrays, also in another vtkPolyData.
  struct InstanceKey
  {
    std::vector<vtkMTimeType> Times;
    rtglyphs::RayTracedRanges Hidden;
    std::array<double, 16> Matrix{};
    bool operator==(const InstanceKey&) const = default;
  };
  struct ColorKey
  {
    std::vector<vtkMTimeType> Times, State;
    std::uint64_t InstanceBuilds = 0;
    std::vector<rtglyphs::RayTracedBlocks::Attributes> Blocks;
    std::array<double, 3> SolidColor{};
    vtkMTimeType Selected = 0;
    std::uint32_t SelectionColor = 0;
    bool operator==(const ColorKey&) const = default;
  };

  InstanceKey KeyOf(vtkActor* actor) const;
  void MapBlock(std::size_t number, bool interpolateValues, MappedColors& mapped);
  bool ReadColorTexture(const rtglyphs::RayTracedBlocks::Block& block, MappedColors& mapped);
  void ReportSizes();

  vtkSmartPointer<vtkPolyData> PolyData;
  bool InstancesTaken = false;
  DataStatistics OfData;
  rtglyphs::RayTracedCache<InstanceKey> Built;
  rtglyphs::RayTracedCache<ColorKey> Colored;
  std::shared_ptr<const rtg::Section> Section = std::make_shared<rtg::Section>();
  std::shared_ptr<const rtg::PeriodicImages> Images = std::make_shared<rtg::PeriodicImages>();
  std::uint32_t SelectionColor = 0x00ff00ffu; // packed, without an opacity
};

#endif
