/**
 * @class   RayTracedParts
 * @brief   actors of a representation in the view's scene, each with its mapper: the main one, and others besides it
 */
#ifndef RayTracedParts_h
#define RayTracedParts_h

#include "Glyphs.h"
#include "RayTracedParallel.h"
#include "vtkNew.h"
#include "vtkRayTracedActors.h"
#include "vtkRayTracedMapper.h"
#include "vtkSmartPointer.h"

#include <memory>

class vtkPVDataRepresentation;
class vtkPVRenderView;

namespace rtglyphs
{

class RayTracedParts
{
public:
  vtkNew<vtkRayTracedActor> Actor;            // in no renderer until it is shown
  vtkSmartPointer<vtkRayTracedMapper> Mapper; // null until something is rendered

  ///@{
  /**
   * Settings of all mappers.
   */
  const std::shared_ptr<rtg::PeriodicImages> Images = std::make_shared<rtg::PeriodicImages>();
  const std::shared_ptr<rtg::Section> Section = std::make_shared<rtg::Section>();
  RayTracedParallel::Progress Progress;
  ///@}

  ///@{
  /**
   * Adds an actor to the view's renderer and scene as part of the representation, or takes it out.
   */
  void Add(vtkPVDataRepresentation* owner, vtkPVRenderView* view, vtkRayTracedActor* actor, vtkRayTracedMapper* mapper);
  void
  Remove(vtkPVDataRepresentation* owner, vtkPVRenderView* view, vtkRayTracedActor* actor, vtkRayTracedMapper* mapper);
  ///@}

  /**
   * Gives the main actor the appearance and place of ParaView's, which is not rendered and may have NaN or infinite
   * numbers.
   */
  void UpdateActor(vtkActor* actor);

  /**
   * Gives one actor the appearance and place of another, whose numbers are finite.
   */
  static void Copy(vtkActor* from, vtkActor* to);
};

} // namespace rtglyphs

#endif
