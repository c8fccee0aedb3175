#if VTK_MODULE_ENABLE_VTK_WrappingPythonCore && VTK_MODULE_ENABLE_VTK_PythonInterpreter
#include "vtkPython.h" // before all else

#include "PyVTKObject.h"
#include "vtkPythonInterpreter.h"
#include "vtkPythonUtil.h"
#include "vtkSmartPyObject.h"
#endif

#include "RayTracedPythonClass.h"

#if VTK_MODULE_ENABLE_VTK_WrappingPythonCore && VTK_MODULE_ENABLE_VTK_PythonInterpreter
namespace
{
PyObject* GetActor(PyObject* self, PyObject*)
{
  return vtkPythonUtil::GetObjectFromPointer(rtglyphs::RayTracedPythonClass::GetActor(PyVTKObject_GetObject(self)));
}

PyMethodDef methods[] = { { "GetActor", GetActor, METH_NOARGS, "The actor of the glyphs or the surface." },
  { nullptr, nullptr, 0, nullptr } };
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedPythonClass::Register()
{
  vtkPythonInterpreter::Initialize();
  RegisterIfPythonRuns();
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedPythonClass::RegisterIfPythonRuns()
{
  static bool registered = false;
  if (registered || !Py_IsInitialized())
  {
    return;
  }
  vtkPythonScopeGilEnsurer gil;
  vtkSmartPyObject module(PyImport_ImportModule("paraview.modules.vtkRemotingViews"));
  vtkSmartPyObject base(module ? PyObject_GetAttrString(module, "vtkGeometryRepresentation") : nullptr);
  vtkSmartPyObject bases(base ? PyTuple_Pack(1, base.GetPointer()) : nullptr);
  PyType_Slot slots[] = { { Py_tp_methods, methods }, { 0, nullptr } };
  PyType_Spec spec = { "raytracedglyphs.vtkRayTracedRepresentation", 0, 0, Py_TPFLAGS_DEFAULT, slots };
  PyObject* type = bases ? PyType_FromSpecWithBases(&spec, bases) : nullptr;
  if (type)
  {
    vtkPythonUtil::AddClassToMap(reinterpret_cast<PyTypeObject*>(type), methods, "vtkRayTracedRepresentation", nullptr);
    registered = true;
  }
  PyErr_Clear(); // on processes without ParaView's modules nobody exports either
}
#else
//----------------------------------------------------------------------------
void rtglyphs::RayTracedPythonClass::Register() {}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedPythonClass::RegisterIfPythonRuns() {}
#endif
