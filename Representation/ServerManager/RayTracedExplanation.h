/**
 * What a display has chosen from the data, in words.
 */
#ifndef RayTracedExplanation_h
#define RayTracedExplanation_h

#include <string>
#include <vector>

class vtkSMProxy;

namespace rtglyphs::RayTracedExplanation
{
/**
 * Which arrays the glyphs of a display show, and why, where they are those that the data suggest; and what is to be
 * known of them. Sentences, none where it shows no ray-traced glyphs.
 */
std::vector<std::string> Explain(vtkSMProxy* display);
}

#endif
