#include "RayTracedSection.h"

#include "vtkAbstractTransform.h"
#include "vtkNew.h"
#include "vtkPVBox.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>

namespace
{
void Check(const char* name, std::span<const double> numbers, bool good, const char* remedy, std::string& problem)
{
  if (!good || !std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); }))
  {
    std::ostringstream message;
    message << "Ray Traced Glyphs: " << name << " is ";
    for (const double number : numbers)
    {
      message << number << ' ';
    }
    problem = message.str();
    problem.back() = ',';
    problem += std::string(" so nothing is cut; ") + remedy + '.';
  }
}
}

//----------------------------------------------------------------------------
rtg::Section rtglyphs::RayTracedSection::Make(std::string& problem) const
{
  rtg::Section section;
  if (this->Kind == Kinds::None)
  {
    return section;
  }
  section.keepsInside = this->Invert;
  const Faces faces = this->Face;
  section.faces = faces == Faces::ColoredCaps ? rtg::Section::Faces::Caps : static_cast<rtg::Section::Faces>(faces);
  if (faces == Faces::ColoredCaps)
  {
    section.capColor = glm::vec3(glm::make_vec3(this->CapColor.data()));
  }
  if (this->Kind == Kinds::Plane)
  {
    const glm::dvec3 origin = glm::make_vec3(this->Origin.data()), across = glm::make_vec3(this->Normal.data());
    const double length = glm::length(across);
    Check("SectionNormal", this->Normal, length > 0.0, "give it a length", problem);
    Check("SectionOrigin", this->Origin, true, "give it three numbers", problem);
    Check("SectionThickness", { &this->Thickness, 1 }, this->Thickness >= 0.0, "give it a width, or 0 for one side",
      problem);
    const glm::dvec3 normal = across / length, half = 0.5 * this->Thickness * normal;
    section.planes.push_back({ origin + half, normal });
    if (this->Thickness > 0.0)
    {
      section.planes.push_back({ origin - half, -normal });
    }
  }
  else
  {
    Check("SectionLength", this->Length, true, "give it three lengths", problem);
    Check("SectionPosition", this->Position, true, "give it three numbers", problem);
    Check("SectionRotation", this->Rotation, true, "give it three angles", problem);
    // ParaView's box is the unit cube in its own frame. Along an axis without length it has no ends.
    std::array<double, 3> scale = this->Length;
    std::replace(scale.begin(), scale.end(), 0.0, 1.0);
    vtkNew<vtkPVBox> box;
    box->SetPosition(this->Position.data());
    box->SetRotation(this->Rotation.data());
    box->SetScale(scale.data());
    const auto toWorld = [&](const glm::dvec3& in)
    {
      glm::dvec3 out;
      box->GetTransform()->GetInverse()->TransformPoint(&in.x, &out.x);
      return out;
    };
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 lower(0.5), upper(0.5);
      lower[axis] = 0.0;
      upper[axis] = 1.0;
      const glm::dvec3 first = toWorld(lower), last = toWorld(upper), normal = glm::normalize(last - first);
      if (this->Length[axis] != 0.0)
      {
        section.planes.insert(section.planes.end(), { { first, -normal }, { last, normal } });
      }
    }
  }
  if (!problem.empty())
  {
    section = rtg::Section();
  }
  return section;
}
