/**
 * @file    RayTracedOpenGL.h
 * @brief   OpenGL functions as VTK loads them: by GLEW up to VTK 9.3, by GLAD since VTK 9.4
 *
 * The module asks for VTK::opengl and VTK::glad as optional modules (vtk.module); VTK has one of the two and says
 * which by this macro.
 */
#ifndef RayTracedOpenGL_h
#define RayTracedOpenGL_h

#if VTK_MODULE_ENABLE_VTK_glad
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
