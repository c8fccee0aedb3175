#include "GlyphArrayNames.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace
{
using Words = std::vector<std::string>;

// In lower case.
Words WordsOf(const std::string& name)
{
  Words words(1);
  char before = 0;
  for (char letter : name)
  {
    const auto c = static_cast<unsigned char>(letter);
    const bool camel = std::isupper(c) && std::islower(static_cast<unsigned char>(before));
    if (!std::isalpha(c) || camel)
    {
      words.emplace_back();
    }
    if (std::isalpha(c))
    {
      words.back() += static_cast<char>(std::tolower(c));
    }
    before = letter;
  }
  return words;
}

// Whether one of the words is one of `known`; those that end with * are beginnings.
bool Say(const Words& words, const Words& known)
{
  return std::any_of(words.begin(), words.end(),
    [&](const std::string& word)
    {
      return std::any_of(known.begin(), known.end(),
        [&](const std::string& one)
        { return one.back() == '*' ? word.compare(0, one.size() - 1, one, 0, one.size() - 1) == 0 : word == one; });
    });
}

const Words angular = { "angular*", "ang", "angvel", "rotation*", "omega" };
const Words velocity = { "veloc*", "vel", "speed*", "v", "u" };
const Words normal = { "normal*", "normals" };
const Words rotation = { "rot", "rotation*", "matrix", "orient*", "axes", "frame", "basis", "quat*", "transform*" };
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphArrayNames::IsRadius(const std::string& name)
{
  return Say(WordsOf(name), { "radius*", "radii" });
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphArrayNames::IsDiameter(const std::string& name)
{
  return Say(WordsOf(name), { "diameter*", "diam" });
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphArrayNames::IsVelocity(const std::string& name)
{
  const Words words = WordsOf(name);
  return Say(words, velocity) && !Say(words, angular);
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphArrayNames::IsNormal(const std::string& name)
{
  return Say(WordsOf(name), normal);
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphArrayNames::IsQuaternion(const std::string& name)
{
  return Say(WordsOf(name), { "quat*", "q", "orient*" });
}

//----------------------------------------------------------------------------
int rtglyphs::GlyphArrayNames::DirectionRank(const std::string& name)
{
  const Words words = WordsOf(name);
  static const Words nowhere = { "position*", "pos", "coord*", "location*", "point*", "xyz", "angle*", "euler*", "rot",
    "rotation*", "colo*", "rgb", "length*", "size*", "shape*", "dimension*", "extent*", "radius*", "radii", "diameter*",
    "diam", "scale*", "id", "ids", "index", "texture*", "tcoord*", "image*", "period*" };
  static const std::vector<Words> directions = { velocity, { "displac*", "disp" }, { "force*", "f" }, normal,
    { "acceler*", "moment*", "mom", "flux*", "flow*", "wind*", "current*", "field*", "magnet*", "dipole*", "spin*",
      "grad*", "direct*", "dir", "vector*", "vec", "tangent*", "axis", "orient*", "vorticity", "torque*" } };
  if (Say(words, nowhere))
  {
    return -1;
  }
  if (Say(words, angular))
  {
    return static_cast<int>(directions.size()); // along the axis of turning
  }
  for (std::size_t rank = 0; rank < directions.size(); ++rank)
  {
    if (Say(words, directions[rank]))
    {
      return static_cast<int>(rank);
    }
  }
  return unknown;
}

//----------------------------------------------------------------------------
int rtglyphs::GlyphArrayNames::TensorRank(const std::string& name)
{
  const Words words = WordsOf(name);
  static const Words tensors = { "tensor*", "stress*", "strain*", "sigma", "epsilon", "diffusion*", "dti", "grad*",
    "hessian*", "inertia*", "conductivity*", "permeability*", "virial*", "pressure*", "reynolds*", "fabric*" };
  return Say(words, tensors) ? 0 : Say(words, rotation) ? -1 : unknown;
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphArrayNames::IsLabel(const std::string& name)
{
  return Say(WordsOf(name),
    { "id", "ids", "type*", "material*", "block*", "index", "label*", "rank*", "process*", "proc", "ghost*", "vtk*",
      "mol", "molecule*", "element*", "group*" });
}
