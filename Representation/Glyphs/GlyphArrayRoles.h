/**
 * Which array of the data has which role for glyphs. The table in GlyphArrayRoles.cxx weighs what is known of an array:
 * the words of its name, ParaView's attributes, the number of components, and the range of its values.
 *
 * Case, digits and punctuation separate words: 'c_radius', 'ParticleRadius' and 'radius2' are named a radius,
 * 'radiation' is not.
 */
#ifndef GlyphArrayRoles_h
#define GlyphArrayRoles_h

#include <string>
#include <vector>

namespace rtglyphs::GlyphArrayRoles
{
enum Role
{
  DIRECTION, // of arrows and cones
  ROTATION,  // of all other shapes
  SIZE,
  LENGTH, // of arrows
  VELOCITY,
  TENSOR, // of second order, else of fourth
  HARMONICS,
  EXPONENTS, // of superquadrics
  NUMBER_OF_ROLES
};

struct Array
{
  std::string Name;
  std::string Columns; // what the names of joined arrays have in common; empty: one array
  int Components = 1;
  bool IsColor = false;                // bytes, or an attribute that is no quantity
  bool IsWhole = false;                // of an integer type
  bool IsActive[NUMBER_OF_ROLES] = {}; // ParaView's attribute of that kind
  bool HasTensorNames = false;         // its components are named xx, xy, ...
  bool IsNegative = false;             // its first number, xx of a tensor, and by no noise
  bool IsPlace = false;                // three components with the ranges of the points' coordinates
  double Least = 0.0, Largest = -1.0;  // value, of several components magnitude; Largest < Least: not known
  bool IsKnown() const { return this->Least <= this->Largest; }
  bool IsConstant() const { return this->Least == this->Largest; }
  bool IsZero() const { return this->Least == 0.0 && this->Largest == 0.0; }
  explicit operator bool() const { return !this->Name.empty(); }
};

// Without a name: none.
struct Choice : Array
{
  std::string Why;        // the reason, in a few words
  bool IsEvident = false; // more than the number of some columns speaks for it
};

/**
 * The array with the most evidence for a role. `spacing` is the usual distance between points, 0: not known.
 */
Choice Choose(Role role, const std::vector<Array>& arrays, double spacing);

/**
 * Vectors, quaternions, tensors and exponents that tables have as columns, whose names differ in an index only: vx, vy
 * and vz, xvel, ..., u, v and w, Velocity:0, ..., quatw, quati, ... Their name is what properties call joined arrays,
 * with commas between. Of u and v alone only if the points lie in a plane. And radii of atomic numbers.
 */
std::vector<Array> Join(const std::vector<Array>& numbers, bool plane);

/**
 * Whether values and name are those of angles, of which nobody knows from where they are counted.
 */
bool IsAngle(const Array& array);

/**
 * Whether the name is that of a size.
 */
bool IsSize(const std::string& name);

/**
 * Whether colors of the array need a logarithmic scale: by its name, and values over more than three powers of ten.
 */
bool IsOverDecades(const Array& array);

/**
 * Factor from a size of that name to a diameter: 2 for a radius, 1 for a diameter. 0: the name is not that
 * of an exact size.
 */
double DiametersOf(const std::string& name);
}

#endif
