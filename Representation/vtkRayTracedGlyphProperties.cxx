// The properties of vtkRayTracedGlyphRepresentation: what proxies set.
#include "vtkRayTracedGlyphRepresentation.h"

#include "vtkActor.h"
#include "vtkGlyphStepVelocity.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkRayTracedGlyphCompanion.h"
#include "vtkRayTracedGlyphMapper.h"
#include "vtkScalarsToColors.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>

namespace
{
// The server manager's names of nothing are null.
std::string Text(const char* name)
{
  return name ? name : "";
}

double InRange(double value, double least, double most, double otherwise)
{
  return std::isnan(value) ? otherwise : std::clamp(value, least, most);
}

std::array<double, 3> ColorInRange(double red, double green, double blue)
{
  return { InRange(red, 0.0, 1.0, 1.0), InRange(green, 0.0, 1.0, 1.0), InRange(blue, 0.0, 1.0, 1.0) };
}
}

//****************************************************************************
// Settings of the glyphs
//****************************************************************************

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphShape(int shape)
{
  vtkGlyphInstanceBuilder::Settings& glyphs = this->Mapper->Glyphs;
  const bool tensor = shape >= TENSOR_ELLIPSOID && shape <= SIGNED_TENSOR_SUPERQUADRIC;
  if (!tensor && shape != MESH && (shape < 0 || shape > static_cast<int>(rtg::Shape::Superquadric)))
  {
    vtkErrorMacro("GlyphShape is " << shape << "; it must lie between 0 (Sphere) and "
                                   << static_cast<int>(rtg::Shape::Superquadric) << " (Superquadric), or between "
                                   << TENSOR_ELLIPSOID << " (Tensor Ellipsoid) and "
                                   << SIGNED_TENSOR_SUPERQUADRIC << " (Signed Tensor Superquadric), or be " << MESH
                                   << " (Mesh).");
    return;
  }
  this->GlyphShape = shape;
  glyphs.Tensors.On = tensor;
  if (tensor)
  {
    glyphs.Tensors.Kind = static_cast<rtg::TensorGlyphKind>(shape - TENSOR_ELLIPSOID);
    glyphs.Shape =
      shape == TENSOR_ELLIPSOID ? rtg::Shape::Sphere : rtg::Shape::NestedSuperquadric;
  }
  else
  {
    glyphs.Shape = shape == MESH ? rtg::Shape::Mesh : static_cast<rtg::Shape>(shape);
    if (glyphs.Shape == rtg::Shape::Superquadric && this->NestedExponents)
    {
      glyphs.Shape = rtg::Shape::NestedSuperquadric;
    }
  }
}

//----------------------------------------------------------------------------
int vtkRayTracedGlyphRepresentation::GetGlyphShape()
{
  return this->GlyphShape;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphExponents(double r, double s, double t)
{
  double* exponents = this->Mapper->Glyphs.Exponents;
  exponents[0] = r;
  exponents[1] = s;
  exponents[2] = t;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphExponentArray(const char* name)
{
  this->Mapper->Glyphs.ExponentArray = Text(name);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphExponentForm(int form)
{
  this->NestedExponents = form == 1;
  this->SetGlyphShape(this->GlyphShape);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphTensorArray(const char* name)
{
  this->Mapper->Glyphs.Tensors.Array = Text(name);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphTensorLayout(int layout)
{
  this->Mapper->Glyphs.Tensors.Layout =
    static_cast<rtg::TensorLayout>(vtkMath::ClampValue(layout, 0, 3));
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphTensorSharpness(double sharpness)
{
  this->Mapper->Glyphs.Tensors.Sharpness = vtkMath::ClampValue(sharpness, 0.0, 10.0);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphTensorColoring(int coloring)
{
  this->Mapper->Glyphs.Tensors.Coloring = coloring;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphTensorPositiveColor(double red, double green, double blue)
{
  this->Mapper->Glyphs.Tensors.PositiveColor = ColorInRange(red, green, blue);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphTensorNegativeColor(double red, double green, double blue)
{
  this->Mapper->Glyphs.Tensors.NegativeColor = ColorInRange(red, green, blue);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphMeshTable(bool use)
{
  if (this->GlyphMeshTable != use)
  {
    this->GlyphMeshTable = use;
    this->MarkModified();
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphMeshIndexArray(const char* name)
{
  this->Mapper->Glyphs.TableIndexArray = Text(name);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphTensorAxis(bool on)
{
  this->TensorAxis = on;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphTensorAxisColor(double red, double green, double blue)
{
  this->TensorAxisColor = ColorInRange(red, green, blue);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphScaling(bool on)
{
  this->Mapper->Glyphs.Scaling = on;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphScaleArray(const char* name)
{
  this->Mapper->Glyphs.ScaleArray = Text(name);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphScaleMode(int mode)
{
  this->Mapper->Glyphs.ScaleMode = mode;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphScaleFactor(double factor)
{
  this->Mapper->Glyphs.ScaleFactor = factor;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphOrient(bool on)
{
  this->Mapper->Glyphs.Orient = on;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphOrientationArray(const char* name)
{
  this->Mapper->Glyphs.OrientationArray = Text(name);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphOrientationMode(int mode)
{
  this->Mapper->Glyphs.OrientationMode = mode;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetArrowHeads(int heads)
{
  this->Mapper->Glyphs.Arrow.fixedHeads = heads == 0;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetArrowReferenceMagnitude(double magnitude)
{
  this->Mapper->Glyphs.ArrowReference = magnitude;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetArrowShaftRadius(double radius)
{
  this->Mapper->Glyphs.Arrow.shaftRadius =
    static_cast<float>(vtkMath::ClampValue(radius, 0.0, 0.5));
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetArrowTipRadius(double radius)
{
  this->Mapper->Glyphs.Arrow.tipRadius = static_cast<float>(vtkMath::ClampValue(radius, 0.0, 0.5));
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetArrowTipLength(double length)
{
  this->Mapper->Glyphs.Arrow.tipLength =
    static_cast<float>(vtkMath::ClampValue(length, 0.001, 1.0));
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetArrowTipRounding(double rounding)
{
  this->Mapper->Glyphs.Arrow.tipRounding =
    static_cast<float>(vtkMath::ClampValue(rounding, 0.0, 1.0));
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetMotionBlur(bool on)
{
  this->Mapper->Glyphs.Motion.On = on;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetVelocityArray(const char* name)
{
  this->Mapper->Glyphs.Motion.Velocity = Text(name);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetVelocityFromPreviousStep(bool on)
{
  if (this->Mapper->Glyphs.Motion.FromPreviousStep != on)
  {
    this->Mapper->Glyphs.Motion.FromPreviousStep = on;
    this->StepVelocity->Reset();
    this->MarkModified(); // the points must be gathered again
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetPointIdArray(const char* name)
{
  const std::string wanted = Text(name);
  if (this->PointIdArray != wanted)
  {
    this->PointIdArray = wanted;
    this->StepVelocity->Reset();
    if (this->Mapper->Glyphs.Motion.FromPreviousStep)
    {
      this->MarkModified();
    }
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetAccelerationArray(const char* name)
{
  this->Mapper->Glyphs.Motion.Acceleration = Text(name);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetAngularVelocityArray(const char* name)
{
  this->Mapper->Glyphs.Motion.AngularVelocity = Text(name);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetShutterTime(double time)
{
  // NaN would make the settings differ from themselves.
  this->Mapper->Glyphs.Motion.ShutterTime = std::isnan(time) ? 0.0 : time;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetShutterOpening(int opening)
{
  this->Mapper->Glyphs.Motion.Opening = std::clamp(opening, 0, 2);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphMask(bool on)
{
  this->Mapper->Glyphs.Mask = on;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetMaximumNumberOfGlyphs(int number)
{
  this->Mapper->Glyphs.MaximumNumberOfGlyphs = number;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetGlyphSeed(int seed)
{
  this->Mapper->Glyphs.Seed = seed;
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetReplicateGlyphs(bool on)
{
  if (this->ReplicateGlyphs != on)
  {
    this->ReplicateGlyphs = on;
    this->MarkModified(); // the points must be delivered again
  }
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetShadingMode(int mode)
{
  this->Mapper->Light.ShadingMode = std::clamp(mode, 0, 2);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetAmbientOcclusionRadius(double radius)
{
  this->Mapper->Light.AmbientOcclusionRadius = InRange(radius, 0.0, 1e30, 0.0);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetAmbientOcclusionRays(int rays)
{
  this->Mapper->Light.AmbientOcclusionRays = std::clamp(rays, 1, 64);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetPathsPerSample(int paths)
{
  this->Mapper->Light.PathsPerSample = std::clamp(paths, 1, 64);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetMaximumBounces(int bounces)
{
  this->Mapper->Light.MaximumBounces = std::clamp(bounces, 1, 1000);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetLightIntensity(double intensity)
{
  this->Mapper->Light.LightIntensity = InRange(intensity, 0.0, 1e6, 1.0);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetEnvironmentColor(double red, double green, double blue)
{
  this->Mapper->Light.EnvironmentColor = ColorInRange(red, green, blue);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetToneMapping(int kind)
{
  this->Mapper->Light.ToneMapping = std::clamp(kind, 0, 1);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetExposure(double stops)
{
  this->Mapper->Light.Exposure = InRange(stops, -100.0, 100.0, 0.0);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetDenoising(int when)
{
  this->Mapper->Light.Denoising = std::clamp(when, 0, 2);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetFeatureImageFile(const char* name)
{
  this->Mapper->FeatureImageFile = Text(name);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetSamplesPerPixel(int samples)
{
  this->Mapper->SetSamplesPerPixel(samples);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetSamplesPerRender(int samples)
{
  this->Mapper->SetSamplesPerRender(samples);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetInteractiveReduction(int step)
{
  this->Mapper->SetInteractiveReduction(step);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetStepwiseRendering(bool stepwise)
{
  this->Mapper->SetStepwiseRendering(stepwise);
}

//****************************************************************************
// Appearance
//****************************************************************************

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetLookupTable(vtkScalarsToColors* table)
{
  this->Mapper->SetLookupTable(table);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetMapScalars(int map)
{
  this->Mapper->SetColorMode(map ? VTK_COLOR_MODE_MAP_SCALARS : VTK_COLOR_MODE_DIRECT_SCALARS);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetOpacity(double opacity)
{
  this->Property->SetOpacity(opacity);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetAmbientColor(double r, double g, double b)
{
  this->Property->SetAmbientColor(r, g, b);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetDiffuseColor(double r, double g, double b)
{
  this->Property->SetDiffuseColor(r, g, b);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetSpecularColor(double r, double g, double b)
{
  this->Property->SetSpecularColor(r, g, b);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetAmbient(double ambient)
{
  this->Property->SetAmbient(ambient);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetDiffuse(double diffuse)
{
  this->Property->SetDiffuse(diffuse);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetSpecular(double specular)
{
  this->Property->SetSpecular(specular);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetSpecularPower(double power)
{
  this->Property->SetSpecularPower(power);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetMetallic(double metallic)
{
  this->Property->SetMetallic(metallic);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetRoughness(double roughness)
{
  this->Property->SetRoughness(roughness);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetCoatStrength(double strength)
{
  this->Property->SetCoatStrength(strength);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetCoatIOR(double ior)
{
  this->Property->SetCoatIOR(ior);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetCoatRoughness(double roughness)
{
  this->Property->SetCoatRoughness(roughness);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetCoatColor(double red, double green, double blue)
{
  this->Property->SetCoatColor(red, green, blue);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetPosition(double x, double y, double z)
{
  this->Position = { x, y, z };
  this->Place();
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetTranslation(double x, double y, double z)
{
  this->Translation = { x, y, z };
  this->Place();
}

//----------------------------------------------------------------------------
// ParaView knows one of the two names, and the other stays zero.
void vtkRayTracedGlyphRepresentation::Place()
{
  this->Actor->SetPosition(this->Position[0] + this->Translation[0],
    this->Position[1] + this->Translation[1], this->Position[2] + this->Translation[2]);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetScale(double x, double y, double z)
{
  this->Actor->SetScale(x, y, z);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetOrientation(double x, double y, double z)
{
  this->Actor->SetOrientation(x, y, z);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetOrigin(double x, double y, double z)
{
  this->Actor->SetOrigin(x, y, z);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetUserTransform(const double matrix[16])
{
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  this->Actor->SetUserTransform(transform);
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetPickable(int pickable)
{
  this->Actor->SetPickable(pickable);
}

//****************************************************************************
// Blocks
//****************************************************************************

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::AddBlockSelector(const char* selector)
{
  this->NoteBlocks(this->Mapper->Blocks.AddSelector(selector));
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::RemoveAllBlockSelectors()
{
  this->NoteBlocks(this->Mapper->Blocks.RemoveAllSelectors());
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetBlockColor(
  const char* selector, double r, double g, double b)
{
  this->NoteBlocks(this->Mapper->Blocks.SetColor(selector, r, g, b));
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::RemoveAllBlockColors()
{
  this->NoteBlocks(this->Mapper->Blocks.RemoveAllColors());
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::SetBlockOpacity(const char* selector, double opacity)
{
  this->NoteBlocks(this->Mapper->Blocks.SetOpacity(selector, opacity));
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::RemoveAllBlockOpacities()
{
  this->NoteBlocks(this->Mapper->Blocks.RemoveAllOpacities());
}

//----------------------------------------------------------------------------
void vtkRayTracedGlyphRepresentation::NoteBlocks(bool changed)
{
  if (changed)
  {
    this->Mapper->BlocksModified();
  }
}
