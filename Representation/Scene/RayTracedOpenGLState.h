/**
 * OpenGL's state of a window, around code that may make other contexts current or bind objects in the window's: Qt's
 * widgets that paint.
 */
#ifndef RayTracedOpenGLState_h
#define RayTracedOpenGLState_h

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

namespace rtglyphs::RayTracedOpenGLState
{
inline void Save(vtkOpenGLRenderWindow* window)
{
  window->GetState()->Reset(); // records what is bound, which VTK does not follow
  window->GetState()->Push();
}

inline void Restore(vtkOpenGLRenderWindow* window)
{
  window->MakeCurrent();
  window->GetState()->Pop();
}
}

#endif
