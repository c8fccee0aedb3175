/**
 * Features of an image besides its colors, as a file for scripts: XML image data (.vti) with one point a pixel, the
 * lower left one first. Point arrays: Color (RGBA), WindowDepth, ViewDepth (world units), Normal (unit, world frame),
 * Albedo (color without light), all means over the samples that hit and 0 where nothing was hit (WindowDepth: 1);
 * Representation (number of the view's ray-traced representation), OriginalId (its input's point, or a surface's cell;
 * -1: nothing was hit) and CompositeIndex (its block), of the pixel's center; SampleCount.
 */
#ifndef RayTracedFeatureImage_h
#define RayTracedFeatureImage_h

#include "Scene.h"
#include "Tracer.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkRayTracedMapper;

namespace rtglyphs::RayTracedFeatureImage
{
/**
 * Writes finished images and their features, which show the same view. Of several ranks each writes its own, with -RANK
 * before the extension. `eyeDepth` is added to view depths: parallel rays start from another plane than the camera's.
 * Returns what is wrong; empty: nothing.
 */
std::string Write(const std::string& fileName,
  const std::vector<std::pair<const rtg::Image*, rtg::ImageFeatures>>& images, const rtg::Scene& scene,
  const std::map<rtg::Scene::SetId, vtkRayTracedMapper*>& mappers, double eyeDepth);
}

#endif
