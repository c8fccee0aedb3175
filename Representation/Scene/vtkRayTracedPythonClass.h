/**
 * vtkRayTracedRepresentation as Python sees it: a vtkGeometryRepresentation whose GetActor() is the one
 * that is shown. ParaView's exporter of .vtkjs files, which is in part written in Python, asks the representation of
 * every source for it. Without Python nothing is done.
 */
#ifndef vtkRayTracedPythonClass_h
#define vtkRayTracedPythonClass_h

class vtkObjectBase;

struct vtkRayTracedPythonClass
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

#endif
// VTK-HeaderTest-Exclude: vtkRayTracedPythonClass.h
