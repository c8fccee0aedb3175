/**
 * vtkRayTracedRepresentation as Python sees it: a vtkGeometryRepresentation whose GetActor() is the one
 * that is shown. ParaView's exporter of .vtkjs files, which is in part written in Python, asks the representation of
 * every source for it. Without Python nothing is done.
 */
#ifndef RayTracedPythonClass_h
#define RayTracedPythonClass_h

class vtkObjectBase;

namespace rtglyphs
{

struct RayTracedPythonClass
{
  ///@{
  /**
   * Makes the class known to Python, once. Register() starts the interpreter where it does not run.
   */
  static void Register();
  static void RegisterIfPythonRuns();
  ///@}

  /**
   * The actor of a vtkRayTracedRepresentation, which sets this function.
   */
  static inline vtkObjectBase* (*GetActor)(vtkObjectBase* representation) = nullptr;
};

} // namespace rtglyphs

#endif
// VTK-HeaderTest-Exclude: RayTracedPythonClass.h
