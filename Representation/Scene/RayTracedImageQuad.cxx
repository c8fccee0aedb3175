#include "RayTracedImageQuad.h"

#include "ImageQuadFragments.h" // the shaders
#include "KeptPixelsFragments.h"

#include "RayTracedOpenGL.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
// Of views that are the same: what coordinates in [-1, 1] differ by, much less than a pixel.
constexpr double sameView = 1e-5;

using Scoped = vtkOpenGLState::ScopedglEnableDisable;

std::vector<vtkOpenGLRenderPass*> Passes(vtkActor* actor)
{
  std::vector<vtkOpenGLRenderPass*> passes;
  vtkInformation* info = actor->GetPropertyKeys();
  if (info && info->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    for (int i = 0; i < info->Length(vtkOpenGLRenderPass::RenderPasses()); ++i)
    {
      passes.push_back(static_cast<vtkOpenGLRenderPass*>(info->Get(vtkOpenGLRenderPass::RenderPasses(), i)));
    }
  }
  return passes;
}

bool WantsSurface(vtkOpenGLRenderPass* pass)
{
  return pass->IsA("vtkSSAOPass");
}

// Of what the renderer's camera sees.
void SetClipToView(vtkShaderProgram* program, vtkRenderer* renderer)
{
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(renderer->GetActiveCamera()->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1));
  matrix->Invert();
  matrix->Transpose(); // column by column for the shader
  program->SetUniformMatrix("clipToView", matrix);
}

void Send(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, unsigned int width, unsigned int height,
  int components, int type, const void* pixels)
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
void rtglyphs::RayTracedImageQuad::SetImage(vtkOpenGLRenderWindow* window, unsigned int width, unsigned int height,
  const std::uint32_t* color, const float* depth, std::uint64_t version)
{
  Send(this->Color, window, width, height, 4, VTK_UNSIGNED_CHAR, color);
  Send(this->Depth, window, width, height, 1, VTK_FLOAT, depth);
  this->Sent = true;
  this->Version = version;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedImageQuad::SetCamera(const glm::dmat4& worldToClip)
{
  this->WorldToClip = worldToClip;
  this->DepthMap[0] = 1.0f;
  this->DepthMap[1] = 0.0f;
}

//----------------------------------------------------------------------------
bool rtglyphs::RayTracedImageQuad::MoveTo(const glm::dmat4& worldToClip)
{
  // From the clip coordinates of one camera to those of the other. The clipping range is in z alone.
  glm::dmat4 change = worldToClip * glm::inverse(this->WorldToClip);
  const double scale = change[2].z, offset = change[3].z;
  change[2].z = 1.0;
  change[3].z = 0.0;
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 4; ++row)
    {
      if (!(std::abs(change[column][row] - (column == row ? 1.0 : 0.0)) < sameView))
      {
        return false;
      }
    }
  }
  // Window depths are in [0, 1], those of clip coordinates in [-1, 1].
  this->DepthMap[0] = static_cast<float>(scale);
  this->DepthMap[1] = static_cast<float>(0.5 * (1.0 - scale + offset));
  return true;
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedImageQuad::Draw(vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper, Uses use)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!this->Sent || !window)
  {
    return;
  }

  // The shader, as the passes of this stage want it
  const std::vector<vtkOpenGLRenderPass*> passes = use == BLEND ? Passes(actor) : std::vector<vtkOpenGLRenderPass*>();
  // Passes that replace colors take this quad for no mapper's.
  const auto mapperFor = [mapper](vtkOpenGLRenderPass* pass) { return WantsSurface(pass) ? mapper : nullptr; };
  const bool surface = std::any_of(passes.begin(), passes.end(), WantsSurface);
  std::string vertex, geometry, fragment = ImageQuadFragments;
  if (surface)
  {
    vtkShaderProgram::Substitute(fragment, "//RayTraced::Define", "#define RAYTRACED_SURFACE\n//RayTraced::Define");
  }
  int viewport[4] = { 0, 0, 0, 0 };
  glGetIntegerv(GL_VIEWPORT, viewport);
  if (use == BLEND && static_cast<int>(this->Color->GetWidth()) < viewport[2])
  {
    vtkShaderProgram::Substitute(fragment, "//RayTraced::Define", "#define RAYTRACED_COARSE");
  }
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->PreReplaceShaderValues(vertex, geometry, fragment, mapperFor(pass), actor);
  }
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->PostReplaceShaderValues(vertex, geometry, fragment, mapperFor(pass), actor);
  }
  vtkOpenGLQuadHelper* quad = this->Ready(window, fragment);
  if (!quad)
  {
    return;
  }
  if (surface)
  {
    SetClipToView(quad->Program, renderer);
  }
  for (vtkOpenGLRenderPass* pass : passes)
  {
    pass->SetShaderParameters(quad->Program, mapperFor(pass), actor, quad->VAO);
  }

  vtkOpenGLState* state = window->GetState();
  const bool opaque = !actor->IsRenderingTranslucentPolygonalGeometry();
  int samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  const bool coverage = use == BLEND && opaque && samples > 1;
  const Scoped depthTest(state, GL_DEPTH_TEST), culling(state, GL_CULL_FACE), blending(state, GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  if (use == IDS || opaque)
  {
    state->SetEnumState(GL_BLEND, use == BLEND && !coverage);
  }
  if (coverage)
  {
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glEnable(GL_SAMPLE_ALPHA_TO_ONE);
  }
  quad->Render();
  if (coverage)
  {
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glDisable(GL_SAMPLE_ALPHA_TO_ONE);
  }
  this->Color->Deactivate();
  this->Depth->Deactivate();
}

//----------------------------------------------------------------------------
// With the image as its input. Null where the shader does not compile; VTK has then reported the compiler's messages.
vtkOpenGLQuadHelper* rtglyphs::RayTracedImageQuad::Ready(vtkOpenGLRenderWindow* window, const std::string& fragment)
{
  std::unique_ptr<vtkOpenGLQuadHelper>& quad = this->Quads[fragment];
  if (!quad)
  {
    quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, fragment.c_str(), nullptr);
  }
  if (!quad->Program)
  {
    return nullptr;
  }
  window->GetShaderCache()->ReadyShaderProgram(quad->Program);
  this->Color->Activate();
  this->Depth->Activate();
  quad->Program->SetUniformi("imageColor", this->Color->GetTextureUnit());
  quad->Program->SetUniformi("imageDepth", this->Depth->GetTextureUnit());
  quad->Program->SetUniform2f("depthMap", this->DepthMap);
  return quad.get();
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedImageQuad::DrawKept(vtkRenderer* renderer, vtkTextureObject* pixels)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLQuadHelper* quad = this->Sent && window ? this->Ready(window, KeptPixelsFragments) : nullptr;
  if (!quad)
  {
    return;
  }
  pixels->Activate();
  quad->Program->SetUniformi("pixels", pixels->GetTextureUnit());
  vtkOpenGLState* state = window->GetState();
  const Scoped depthTest(state, GL_DEPTH_TEST), culling(state, GL_CULL_FACE), blending(state, GL_BLEND);
  const vtkOpenGLState::ScopedglDepthMask depthMask(state);
  const vtkOpenGLState::ScopedglDepthFunc depthFunc(state);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(GL_LEQUAL);
  quad->Render();
  pixels->Deactivate();
  this->Color->Deactivate();
  this->Depth->Deactivate();
}

//----------------------------------------------------------------------------
void rtglyphs::RayTracedImageQuad::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quads.clear();
  this->Color->ReleaseGraphicsResources(window);
  this->Depth->ReleaseGraphicsResources(window);
  this->Sent = false;
}
