#pragma once

#include <glm/glm.hpp>

#include <stop_token>
#include <vector>

namespace rtg
{

struct ImageFeatures;

/// Smooths the light of an image of few samples, within surfaces but not over their edges: an edge-avoiding wavelet
/// transform (Dammertz, Sewtz, Hanika and Lensch, "Edge-Avoiding A-Trous Wavelet Transform for fast Global Illumination
/// Filtering", HPG 2010) of the light divided by the surfaces' colors, whose steps follow the noise's own variance as
/// Schied et al. do ("Spatiotemporal Variance-Guided Filtering", HPG 2017), estimated in the image itself.
/// `means`: color times opacity, and opacity; opacities are not changed, nor pixels of which nothing is known. Albedos
/// of `guides`: the surfaces' colors in the units of the light, divided out and put back. Deterministic, on any number
/// of threads. Throws rtg::Error soon after a stop is requested.
void Denoise(std::vector<glm::vec4>& means, const ImageFeatures& guides, const std::stop_token& stop = {});

} // namespace rtg
