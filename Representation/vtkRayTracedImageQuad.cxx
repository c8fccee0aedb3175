#include "vtkRayTracedImageQuad.h"

#include "RayTracedImageQuad.h" // the shader
#include "vtkRayTracedOpenGL.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <vector>

namespace
{
std::vector<vtkOpenGLRenderPass*> Passes(vtkActor* actor)
{
  std::vector<vtkOpenGLRenderPass*> passes;
  vtkInformation* info = actor->GetPropertyKeys();
  if (info && info->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    for (int i = 0; i < info->Length(vtkOpenGLRenderPass::RenderPasses()); ++i)
    {
      passes.push_back(
        static_cast<vtkOpenGLRenderPass*>(info->Get(vtkOpenGLRenderPass::RenderPasses(), i)));
    }
  }
  return passes;
}

void Send(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, unsigned int width,
  unsigned int height, int components, int type, const void* pixels)
{
  texture->SetContext(window);
  texture->Create2DFromRaw(width, height, components, type, const_cast<void*>(pixels));
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
}
}

//----------------------------------------------------------------------------
vtkRayTracedImageQuad::vtkRayTracedImageQuad() = default;

//----------------------------------------------------------------------------
vtkRayTracedImageQuad::~vtkRayTracedImageQuad() = default;

//----------------------------------------------------------------------------
void vtkRayTracedImageQuad::SetImage(vtkOpenGLRenderWindow* window, unsigned int width,
  unsigned int height, const std::uint32_t* color, const float* depth)
{
  Send(this->Color, window, width, height, 4, VTK_UNSIGNED_CHAR, color);
  Send(this->Depth, window, width, height, 1, VTK_FLOAT, depth);
  this->Sent = true;
}

//----------------------------------------------------------------------------
void vtkRayTracedImageQuad::Draw(
  vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper, Uses use)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!this->Sent || !window)
  {
    return;
  }

  // The shader, as the passes of this stage want it
  const std::vector<vtkOpenGLRenderPass*> passes =
    use == BLEND ? Passes(actor) : std::vector<vtkOpenGLRenderPass*>();
  std::string vertex, geometry, fragment = RayTracedImageQuad;
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->PreReplaceShaderValues(vertex, geometry, fragment, mapper, actor);
  }
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->PostReplaceShaderValues(vertex, geometry, fragment, mapper, actor);
  }
  std::unique_ptr<vtkOpenGLQuadHelper>& quad = this->Quads[fragment];
  if (!quad)
  {
    quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, fragment.c_str(), nullptr);
  }
  if (!quad->Program)
  {
    return; // VTK has reported the compiler's messages
  }
  window->GetShaderCache()->ReadyShaderProgram(quad->Program);

  this->Color->Activate();
  this->Depth->Activate();
  quad->Program->SetUniformi("imageColour", this->Color->GetTextureUnit());
  quad->Program->SetUniformi("imageDepth", this->Depth->GetTextureUnit());
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->SetShaderParameters(quad->Program, mapper, actor, quad->VAO);
  }

  vtkOpenGLState* state = window->GetState();
  const bool opaque = passes.empty() && !actor->IsRenderingTranslucentPolygonalGeometry();
  int samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  {
    vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
    vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
    vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_CULL_FACE);
    if (use == IDS)
    {
      state->vtkglDisable(GL_BLEND);
    }
    const bool coverage = use == BLEND && opaque && samples > 1;
    if (coverage)
    {
      state->vtkglDisable(GL_BLEND);
      glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
      glEnable(GL_SAMPLE_ALPHA_TO_ONE);
    }
    else if (use == BLEND && opaque)
    {
      state->vtkglEnable(GL_BLEND);
    }
    quad->Render();
    if (coverage)
    {
      glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
      glDisable(GL_SAMPLE_ALPHA_TO_ONE);
    }
  }
  this->Color->Deactivate();
  this->Depth->Deactivate();
}

//----------------------------------------------------------------------------
void vtkRayTracedImageQuad::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quads.clear();
  this->Color->ReleaseGraphicsResources(window);
  this->Depth->ReleaseGraphicsResources(window);
  this->Sent = false;
}
