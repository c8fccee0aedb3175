#include "GlyphArrayRoles.h"

#include "GlyphJoinedArrays.h"
#include "HarmonicForms.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <unordered_map>

namespace
{
using namespace rtglyphs::GlyphArrayRoles;
using Words = std::vector<std::string>;

// Meanings of a name. The first word that a name has counts.
struct Meaning
{
  Words Names;                             // words that begin so where they end with *; " word": the only word
  std::array<int, NUMBER_OF_ROLES> Scores; // 0: never in this role
  double Diameters = 0.0;
  bool Decades = false; // values of many powers of ten are usual
};

constexpr int active = 45; // ParaView's attribute
constexpr int turns = 120; // a rotation orients a body, before any vector
constexpr int tensor = 60; // the name of one

// Columns: DIRECTION, ROTATION, SIZE, LENGTH, VELOCITY, TENSOR, HARMONICS, EXPONENTS
const Meaning meanings[] = {
  { { "colo*", "rgb*", "rgba", "texture*", "tcoord*", "normalmap" }, {} },
  { { "imag*", "im", "error*", "std*", "residual*", "uncertain*" },
    { 10, 10, 10, 10, 0, 20, 20, 0 } }, // beside a quantity
  { { "blockiness*", "exponent*", "roundness*", " block" }, { 0, 0, 0, 0, 0, 0, 0, 80 } },
  { { "radius*", "radii", "rvir", "pscale" }, { 0, 0, 90, 20, 0, 0, 0, 0 }, 2.0 },
  { { "diameter*", "diam", "esd", " d" }, { 0, 0, 88, 20, 0, 0, 0, 0 }, 1.0 },
  { { "spacing" }, { 0, 0, 80, 18, 0, 0, 0, 0 }, 1.0 },
  { { "smoothing*", "size*", "length*", "shape*", "scale*", "dimension*", "extent*", " h" },
    { 0, 0, 70, 16, 0, 0, 0, 0 } },
  { { "id", "ids", "atomic*", "type*", "material*", "block*", "index", "label*", "rank*", "process*", "proc", "ghost*",
      "vtk*", "mol", "molecule*", "element*", "group*", "mask*", "flag*", "status*", "state*", "is", "idp",
      "subdomain*", "partition*", " image", "period*" },
    {} },
  { { "eigenval*", "eigval*", "evals", "eval" }, { 0, 0, 20, 20, 0, 20, 0, 0 } },
  { { "fod*", "wmfod*", "odf*", "sh", "harmonic*" }, { 20, 20, 20, 20, 0, 0, 60, 0 } },
  { { "tensor*" }, { 20, 20, 15, 20, 0, tensor, 20, 0 } },
  { { "angle*", "euler*", "position*", "pos", "coord*", "location*", "point*", " xyz" }, {} },
  { { "quat*", "q", "rot", "rotation*", "matrix", "axes", "frame", "basis", "transform*" },
    { 48, turns, 0, 0, 0, 0, 0, 0 } },
  { { "orient*" }, { 48, turns, 0, 0, 0, 0, 0, 0 } },
  { { "angular*", "ang", "angvel", "omega" }, { 44, 44, 10, 44, 0, tensor, 0, 0 } },
  { { "stress*", "strain*", "sigma", "epsilon", "diffusion*", "dti", "hessian*", "inertia*", "conductivity*",
      "permeability*", "virial*", "reynolds*", "fabric*", "cov", "covar*" },
    { 20, 20, 15, 20, 0, tensor, 20, 0 } },
  { { "vel*", "speed*", "v", "u", "vx" }, { 60, 60, 25, 60, 90, 20, 0, 0 } },
  { { "displac*", "disp", "displ", "depl" }, { 58, 58, 24, 58, 0, 20, 0, 0 } },
  { { "force*", "f" }, { 56, 56, 24, 56, 0, 20, 0, 0 } },
  { { "accel*", "moment*", "mom", "flux*", "flow*", "wind*", "current*", "field*", "magnet*", "dipole*", "spin*",
      "grad*", "direct*", "dir", "vector*", "vec", "tangent*", "axis", "vorticity", "torque*" },
    { 50, 50, 22, 50, 0, tensor, 0, 0 } },
  { { "pressure*" }, { 20, 20, 20, 20, 0, tensor, 0, 0 } },
  { { "peak*" }, { 20, 20, 20, 20, 0, 0, 0, 0 } }, // of distributions, some vectors each
  { { "normal*" }, { 7, 7, 0, 7, 0, 0, 0, 0 } },
  { { "mass*", "mvir", "dens*", "energ*", "edep", "lumin*", "viscos*", "resistiv*", "concentr*", "dissip*" },
    { 20, 20, 20, 20, 0, 20, 20, 0 }, 0.0, true },
};
// Of one component, in degrees or radians.
const Words angles = { "angle*", "azim*", "bearing*", "heading*", "strike*", "dip", "rake", "trend", "plunge", "yaw",
  "inclination", "direct*", "dir", "orient*" };
const Meaning unnamed = { {}, { 20, 20, 20, 20, 1, 20, 20, 0 } };

// The capital before small letters ends a row of capitals: UMean, but not IDs.
bool BeginsWord(const std::string& name, std::size_t i)
{
  const auto isSmall = [&name](std::size_t at)
  { return at < name.size() && std::islower(static_cast<unsigned char>(name[at])); };
  return std::isupper(static_cast<unsigned char>(name[i])) && isSmall(i + 1) && isSmall(i + 2);
}

// In lower case.
Words WordsOf(const std::string& name)
{
  Words words(1);
  char before = 0;
  for (std::size_t i = 0; i < name.size(); ++i)
  {
    const auto c = static_cast<unsigned char>(name[i]);
    const bool camel = std::isupper(c) && (std::islower(static_cast<unsigned char>(before)) || BeginsWord(name, i));
    if (!std::isalpha(c) || camel)
    {
      words.emplace_back();
    }
    if (std::isalpha(c))
    {
      words.back() += static_cast<char>(std::tolower(c));
    }
    before = name[i];
  }
  words.erase(std::remove(words.begin(), words.end(), std::string()), words.end());
  return words;
}

// A letter alone is the name of a number only.
bool HasOneOf(const Words& words, const Words& names, int components)
{
  return std::any_of(names.begin(), names.end(),
    [&](const std::string& known)
    {
      if (known[0] == ' ')
      {
        return words.size() == 1 && words[0] == known.substr(1) && (known.size() > 2 || components == 1);
      }
      return std::any_of(words.begin(), words.end(),
        [&known](const std::string& word) {
          return known.back() == '*' ? word.compare(0, known.size() - 1, known, 0, known.size() - 1) == 0
                                     : word == known;
        });
    });
}

const Meaning& MeaningOf(const std::string& name, int components)
{
  const Words words = WordsOf(name);
  const auto found = std::find_if(std::begin(meanings), std::end(meanings),
    [&](const Meaning& meaning) { return HasOneOf(words, meaning.Names, components); });
  return found != std::end(meanings) ? *found : unnamed;
}

const Meaning& MeaningOf(const Array& array)
{
  return MeaningOf(array.Columns.empty() ? array.Name : array.Columns, array.Components);
}

// Sizes that suit the distances of the points; unknown ones do.
bool IsPlausible(const Array& array, double spacing)
{
  return !array.IsKnown() || !(spacing > 0.0) ||
    (array.Least >= 0.0 && array.Largest < 2.0 * spacing && array.Largest > 0.02 * spacing);
}

// All of one magnitude: quaternions, rotation matrices.
bool HasLength(const Array& array, double length)
{
  return array.IsKnown() && std::abs(array.Least - length) < 1e-3 && std::abs(array.Largest - length) < 1e-3;
}

bool IsRotation(const Array& array)
{
  return (array.Components == 9 && HasLength(array, std::sqrt(3.0))) ||
    (array.Components == 4 && HasLength(array, 1.0));
}

// A letter alone may be anything, no rotation has five, six or seven components, orientations of fibers are tensors,
// and five numbers Q, too, those of a nematic.
const Meaning& MeaningOf(const Array& array, double spacing)
{
  const Words words = WordsOf(array.Columns.empty() ? array.Name : array.Columns);
  const bool letter = words.size() == 1 && words.front().size() == 1;
  const Meaning& meaning = MeaningOf(array);
  const bool turning = meaning.Scores[ROTATION] == turns;
  const bool tuple = !array.IsPlace && (array.Components > 3) == turning;
  const bool meant = array.Components > 1 ? tuple : meaning.Scores[SIZE] >= 70 && IsPlausible(array, spacing);
  const bool fiber =
    turning && meaning.Names.front() == "orient*" && array.Components == 9 && array.IsKnown() && !IsRotation(array);
  const bool other = array.HasTensorNames || (array.Components > 4 && array.Components < 9) || fiber;
  return turning && array.Components == 5      ? MeaningOf("tensor", 5)
    : (letter && !meant) || (turning && other) ? unnamed
                                               : meaning;
}

// Three components under the name of a rotation are angles.
bool IsNeverVector(const Meaning& meaning)
{
  return meaning.Scores[ROTATION] == turns && meaning.Names.front() != "orient*";
}

// The number of components that a role takes; a plane's vectors and tensors where more than the number says so.
bool Fits(Role role, const Array& array, const Meaning& meaning)
{
  const int n = array.Components;
  const bool vector = !array.HasTensorNames && (n == 3 || (n == 2 && &meaning != &unnamed));
  const bool turning = meaning.Scores[ROTATION] == turns || IsRotation(array);
  switch (role)
  {
    case DIRECTION:
      return (vector && !IsNeverVector(meaning)) || (n == 4 && turning);
    case ROTATION:
      return (vector && !IsNeverVector(meaning)) || ((n == 4 || n == 9) && turning);
    case SIZE:
    case LENGTH:
      return n == 1 || vector;
    case VELOCITY:
      return vector;
    case EXPONENTS:
      return n == 2 || n == 3;
    case TENSOR:
      return (n >= 5 && n <= 7) || n == 9 || n == 15 || n == 21 || n == 36 || n == 81 ||
        (n >= 2 && n <= 4 &&
          (array.HasTensorNames ||
            (meaning.Scores[TENSOR] == tensor && meaning.Scores[DIRECTION] == unnamed.Scores[DIRECTION])));
    default:
      return n > 9 && rtg::FormMap::IsHarmonicsLength(n); // those of one and six components are seldom harmonics
  }
}

struct Evidence
{
  int Score = 0;             // 1 or less: not in this role
  const char* Why = nullptr; // null: nothing but the number of components
};

Evidence Weigh(Role role, const Array& array, double spacing)
{
  const Meaning& meaning = MeaningOf(array, spacing);
  const bool named = &meaning != &unnamed;
  Evidence evidence{ meaning.Scores[role], named ? "its name" : nullptr };
  int& score = evidence.Score;
  const bool isZero = role != VELOCITY && role != EXPONENTS && array.IsZero();
  if (array.IsColor || score == 0 || !Fits(role, array, meaning) || (role == TENSOR && IsRotation(array)) || isZero)
  {
    return {}; // of zeros there is nothing to see yet
  }
  if (array.IsActive[role])
  {
    evidence.Why = score < active ? "an active array of the data" : evidence.Why;
    score += active;
  }
  score -= array.Columns.empty() ? 0 : 1; // arrays of the data first
  if ((role == DIRECTION || role == ROTATION) && array.Components == 4)
  {
    const int less = array.Name.size() == 1 ? 30 : 6; // arrows follow a vector, if there is one
    score -= role == DIRECTION ? less : 0;
  }
  if (role == ROTATION && IsRotation(array))
  {
    score += turns;
    evidence.Why = evidence.Why ? evidence.Why : "its values, which are rotations";
  }
  if (role == TENSOR && array.HasTensorNames)
  {
    score += tensor;
    evidence.Why = "the names of its components";
  }
  if (role == TENSOR && (array.Components > 9 || array.Components == 5))
  {
    score = 1 + score / 16; // of second order first
  }
  else if (role == TENSOR && array.Components < 5 && !array.HasTensorNames)
  {
    score /= 4; // vectors, as stresses at a wall, if there are other tensors
  }
  if (IsAngle(array))
  {
    score = std::min(score, 10);
  }
  if (array.Components == 1 && (role == SIZE || role == LENGTH))
  {
    if (role == LENGTH)
    {
      score = 1 + score / 8; // arrows are as long as a vector, if there is one
    }
    if (array.IsKnown() && !named)
    {
      const bool plausible = array.Least > 0.0 && spacing > 0.0 && IsPlausible(array, spacing);
      const bool same = array.Least == array.Largest || array.IsWhole;
      if (plausible)
      {
        score += 6; // more than a vector's name
        evidence.Why = evidence.Why ? evidence.Why : "its values, which suit the distances of the points";
      }
      score -= same ? 2 : 0; // a number of kinds, or nothing to see
    }
  }
  else if (!named && array.IsPlace)
  {
    return {}; // the points' coordinates once more
  }
  return evidence;
}

// Names of the components of tensors, quaternions and vectors.
std::vector<Words> Indices()
{
  std::vector<Words> indices;
  const auto add = [&](const char* names, const char* letters)
  {
    Words index(1);
    for (const char* name = names; *name; ++name)
    {
      if (*name == ' ')
      {
        index.emplace_back();
      }
      else
      {
        index.back() += letters && *name >= 'x' && *name <= 'z' ? letters[*name - 'x'] : *name;
      }
    }
    indices.push_back(index);
  };
  for (const char* letters : { "xyz", "XYZ", "123" })
  {
    for (const char* names : { "xx xy xz yx yy yz zx zy zz", "xx yy zz xy yz xz", "xx yy zz xy yz zx", "xx xy xz yy yz",
           "xx yy zz xy", "xx yy xy", "xx xy" })
    {
      add(names, letters);
    }
  }
  for (const char* names :
    { "w x y z", "w i j k", "x y z", "X Y Z", "i j k", "u v w", "U V W", "e n u", "E N U", "east north up",
      "East North Up", "x y", "X Y", "u v", "U V", "east north", "East North", "zonal meridional", "Zonal Meridional" })
  {
    add(names, nullptr);
  }
  return indices;
}

std::string Replaced(const std::string& name, std::size_t at, std::size_t length, const std::string& by)
{
  return name.substr(0, at) + by + name.substr(at + length);
}

// Columns of a table, of which some become components of joined arrays.
struct Columns
{
  std::unordered_map<std::string, const Array*> Left;
  bool Plane = false;
  std::vector<Array> Joined;

  bool Has(const std::string& name) const { return this->Left.count(name) > 0; }

  // Of columns numbered from 0 or 1 all that there are. Six from 1 are those of LAMMPS, in its order of tensors.
  Words NumbersFrom(const std::string& first, std::size_t at) const
  {
    Words index;
    for (int number = first[at] - '0'; this->Has(Replaced(first, at, 1, std::to_string(number))); ++number)
    {
      index.push_back(std::to_string(number));
    }
    if (index.size() == 6 && first[at] == '1')
    {
      std::swap(index[4], index[5]);
    }
    const std::size_t n = index.size();
    const bool known = n == 2 || n == 3 || n == 4 || n == 6 || n == 7 || n == 9;
    return known || (n > 9 && rtg::FormMap::IsHarmonicsLength(n)) ? index : Words();
  }

  // Of a first column whose name has the first component's at a place, and those of the other components.
  void Join(const std::string& first, std::size_t at, const Words& index)
  {
    const auto isAt = [&](std::size_t place)
    { return place < first.size() && std::isalnum(static_cast<unsigned char>(first[place])); };
    if (index.empty())
    {
      return;
    }
    const std::size_t length = index.front().size();
    Array array;
    Words names;
    for (const std::string& one : index)
    {
      names.push_back(Replaced(first, at, length, one));
      array.Name += (array.Name.empty() ? "" : ", ") + names.back();
      if (!this->Has(names.back()))
      {
        return;
      }
    }
    array.Columns = Replaced(first, at, length, " ");
    array.Components = static_cast<int>(index.size());
    array.HasTensorNames = length == 2;
    const bool speed = index.front() == "u" || index.front() == "U";
    if (speed && &MeaningOf(array) == &unnamed)
    {
      array.Columns += " velocity";
    }
    // The component's name ends a word, or begins that of a vector: xvel, but not xs.
    const Words words = WordsOf(array.Columns);
    const Meaning& meaning = MeaningOf(array);
    const bool ends = !isAt(at + length) || (at > 0 && BeginsWord(first, at + length)) ||
      (at > 0 && std::islower(static_cast<unsigned char>(first[at])) &&
        std::isupper(static_cast<unsigned char>(first[at + length]))); // ExRe
    const bool named = !words.empty() && words.front().size() > 1 && meaning.Scores[DIRECTION] > 20;
    const bool begins = at == 0 && (named || (speed && first.size() == 2)); // uo, ua: of oceans and the atmosphere
    const bool running = index.front() == "11" && this->Has(Replaced(first, at, length, "10"));
    const bool whole =
      std::all_of(names.begin(), names.end(), [this](const std::string& name) { return this->Left[name]->IsWhole; });
    const bool flat = speed || length > 1; // of a map, traceless tensors
    const bool meant = &meaning != &unnamed ? array.Components > 2 || !flat || this->Plane
                                            : array.Components > 2 && !whole;            // images, indices of a grid
    const bool bare = words.empty() && !(array.HasTensorNames && array.Components >= 6); // coordinates
    if (bare || !(ends || begins) || !meant || running)
    {
      return;
    }
    array.IsNegative = this->Left[names.front()]->IsNegative;
    if (std::ranges::all_of(names, [this](const std::string& name) { return this->Left[name]->IsZero(); }))
    {
      array.Largest = 0.0;
    }
    for (const std::string& name : names)
    {
      this->Left.erase(name);
    }
    this->Joined.push_back(array);
  }
};
}

//----------------------------------------------------------------------------
Choice rtglyphs::GlyphArrayRoles::Choose(Role role, const std::vector<Array>& arrays, double spacing)
{
  Choice best;
  Evidence most{ 1, nullptr };
  int alike = 0; // arrays that as much speaks for
  for (const Array& array : arrays)
  {
    const Evidence evidence = Weigh(role, array, spacing);
    alike = evidence.Score > most.Score ? 1 : alike + (evidence.Score == most.Score ? 1 : 0);
    if (evidence.Score > most.Score)
    {
      most = evidence;
      static_cast<Array&>(best) = array;
    }
  }
  if (best)
  {
    best.IsEvident = most.Why || (best.Components >= 6 && best.Name.find(", ") == std::string::npos);
    best.Why = most.Why ? most.Why : "its number of components";
    best.Why += alike > 1 ? ", as the first of " + std::to_string(alike) + " equal candidates" : "";
  }
  return best;
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphArrayRoles::IsAngle(const Array& array)
{
  return array.Components == 1 && array.IsKnown() && array.Least >= -360.0 && array.Largest <= 360.0 &&
    HasOneOf(WordsOf(array.Name), angles, 1);
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphArrayRoles::IsSize(const std::string& name)
{
  return MeaningOf(name, 1).Scores[SIZE] >= 70;
}

//----------------------------------------------------------------------------
bool rtglyphs::GlyphArrayRoles::IsOverDecades(const Array& array)
{
  return MeaningOf(array).Decades && array.Components == 1 && array.Least > 0.0 && array.Largest > 1e3 * array.Least;
}

//----------------------------------------------------------------------------
std::vector<Array> rtglyphs::GlyphArrayRoles::Join(const std::vector<Array>& numbers, bool plane)
{
  static const std::vector<Words> indices = Indices();
  Columns columns;
  columns.Plane = plane;
  for (const Array& number : numbers)
  {
    columns.Left[number.Name] = &number;
    const Words words = WordsOf(number.Name);
    if (words.size() == 2 && words[0] == "atomic" && (words[1] == "number" || words[1] == "numbers"))
    {
      Array radii;
      radii.Name = rtglyphs::GlyphJoinedArrays::vanDerWaals + number.Name;
      radii.Columns = "radius";
      columns.Joined.push_back(radii);
    }
  }
  for (const Words& index : indices)
  {
    for (const Array& number : numbers)
    {
      const std::string& first = number.Name;
      for (std::size_t at = first.rfind(index.front()); at != std::string::npos;
           at = at > 0 ? first.rfind(index.front(), at - 1) : std::string::npos)
      {
        columns.Join(first, at, index);
      }
    }
  }
  for (const Array& number : numbers)
  {
    const std::string& first = number.Name;
    for (std::size_t at = first.size(); at-- > 0;)
    {
      if (first[at] == '0' || (first[at] == '1' && !columns.Has(Replaced(first, at, 1, "0"))))
      {
        columns.Join(first, at, columns.NumbersFrom(first, at));
      }
    }
  }
  return columns.Joined;
}

//----------------------------------------------------------------------------
double rtglyphs::GlyphArrayRoles::DiametersOf(const std::string& name)
{
  return MeaningOf(name, 1).Diameters;
}
