#include "RayTracedFeatureImage.h"

#include "RayTracedArrays.h"
#include "RayTracedRanks.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRayTracedMapper.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLImageDataWriter.h"

#include <filesystem>

namespace
{
template <class Array>
Array* Add(vtkImageData* data, const char* name, int components)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  data->GetPointData()->AddArray(array);
  return array;
}

// Every rank has an image of its own.
std::string NameOfRank(const std::string& name)
{
  if (rtglyphs::RayTracedRanks::Count() < 2)
  {
    return name;
  }
  std::filesystem::path path(name);
  const std::string rank = "-" + std::to_string(rtglyphs::RayTracedRanks::Own());
  return path.replace_filename(path.stem().string() + rank + path.extension().string()).string();
}
}

//----------------------------------------------------------------------------
std::string rtglyphs::RayTracedFeatureImage::Write(const std::string& fileName,
  const std::vector<std::pair<const rtg::Image*, rtg::ImageFeatures>>& images, const rtg::Scene& scene,
  const std::map<rtg::Scene::SetId, vtkRayTracedMapper*>& mappers, double eyeDepth)
{
  vtkNew<vtkImageData> data;
  data->SetDimensions(static_cast<int>(images[0].first->width), static_cast<int>(images[0].first->height), 1);
  auto* colors = Add<vtkUnsignedCharArray>(data, "Color", 4);
  auto* windowDepths = Add<vtkFloatArray>(data, "WindowDepth", 1);
  auto* viewDepths = Add<vtkFloatArray>(data, "ViewDepth", 1);
  auto* normals = Add<vtkFloatArray>(data, "Normal", 3);
  auto* albedos = Add<vtkFloatArray>(data, "Albedo", 3);
  auto* representations = Add<vtkIntArray>(data, "Representation", 1);
  auto* ids = Add<vtkIdTypeArray>(data, "OriginalId", 1);
  auto* blocks = Add<vtkIntArray>(data, "CompositeIndex", 1);
  auto* samples = Add<vtkIntArray>(data, "SampleCount", 1);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const auto* nearest = &images[0];
    for (const auto& other : images)
    {
      const bool hit = other.first->glyphIds[i] != rtg::Image::noGlyph;
      nearest = hit && other.first->depth[i] < nearest->first->depth[i] ? &other : nearest;
    }
    const auto& [image, features] = *nearest;
    const std::uint32_t color = image->color[i];
    colors->SetTuple4(i, color & 255, (color >> 8) & 255, (color >> 16) & 255, color >> 24);
    windowDepths->SetValue(i, image->depth[i]);
    viewDepths->SetValue(
      i, features.normals[i] == glm::vec3(0.0f) ? 0.0f : features.viewDepths[i] + static_cast<float>(eyeDepth));
    const glm::vec3 normal = features.normals[i], albedo = features.albedos[i];
    normals->SetTuple3(i, normal.x, normal.y, normal.z);
    albedos->SetTuple3(i, albedo.x, albedo.y, albedo.z);
    samples->SetValue(i, static_cast<int>(image->samples));

    const auto source = mappers.find(image->setIds[i]);
    const bool hit = image->glyphIds[i] != rtg::Image::noGlyph && source != mappers.end();
    vtkRayTracedMapper::Origin origin;
    if (hit)
    {
      const double anywhere[3] = { 0.0, 0.0, 0.0 };
      origin = source->second->OriginOf(
        scene.OriginalGlyph(source->first, image->glyphIds[i]), source->second->GetNaturalAssociation(), anywhere);
    }
    // Sets are numbered in the order in which they came.
    representations->SetValue(i, hit ? static_cast<int>(std::distance(mappers.begin(), source)) : -1);
    ids->SetValue(i, rtglyphs::RayTracedArrays::InputId(origin.Id));
    blocks->SetValue(i, static_cast<int>(origin.CompositeIndex));
  }

  const std::string name = NameOfRank(fileName);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(name.c_str());
  writer->SetInputData(data);
  // Raw bytes in XML are refused by newer versions of libexpat.
  writer->SetDataModeToBinary();
  const vtkTypeBool shown = vtkObject::GetGlobalWarningDisplay();
  vtkObject::SetGlobalWarningDisplay(0); // one message is enough
  const bool written = writer->Write() != 0 && writer->GetErrorCode() == vtkErrorCode::NoError;
  vtkObject::SetGlobalWarningDisplay(shown);
  return written ? std::string()
                 : "The feature image could not be written to '" + name +
      "'. Give the path of a file (.vti) in a folder that exists and may be written to.";
}
