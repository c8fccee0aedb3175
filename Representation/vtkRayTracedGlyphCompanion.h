/**
 * @class   vtkRayTracedGlyphCompanion
 * @brief   a further set of glyphs of a representation's points, which follows its first in all but the glyphs' form
 *
 * The arrows of antisymmetric parts, and the further forms of a table of meshes.
 */
#ifndef vtkRayTracedGlyphCompanion_h
#define vtkRayTracedGlyphCompanion_h

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkRayTracedGlyphMapper.h"

class vtkPVRenderView;
class vtkPolyData;
class vtkPVDataRepresentation;

class vtkRayTracedGlyphCompanion
{
public:
  vtkRayTracedGlyphCompanion();

  /**
   * Its Glyphs say what it shows.
   */
  vtkRayTracedGlyphMapper& GetMapper() { return *this->Mapper; }
  vtkProperty* GetProperty() { return this->Actor->GetProperty(); }

  ///@{
  /**
   * Joins or leaves a view, as part of that representation.
   */
  void AddTo(vtkPVRenderView* view, vtkPVDataRepresentation* representation);
  void RemoveFrom(vtkPVRenderView* view, vtkPVDataRepresentation* representation);
  ///@}

  /**
   * Shows its glyphs of these points from now on, with the leader's blocks, light, samples, properties and place.
   */
  void Follow(vtkPolyData* points, vtkRayTracedGlyphMapper* leader, vtkActor* leadersActor);

  /**
   * Shows the colours that the leader shows; without it, one colour.
   */
  void FollowColors(vtkRayTracedGlyphMapper* leader);

  ///@{
  /**
   * Until the next Follow() it shows nothing. Its visibility is the leader's else.
   */
  void Hide();
  void SetVisibility(bool visible);
  ///@}

private:
  vtkNew<vtkRayTracedGlyphMapper> Mapper;
  vtkNew<vtkActor> Actor;
};

#endif
