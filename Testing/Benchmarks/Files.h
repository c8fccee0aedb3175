// The benchmarks' scenes from legacy VTK files (Data/).
#pragma once

#include "Crowds.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmark
{

/// Big-endian floats from the stream, as legacy VTK files hold them.
inline std::vector<float> ReadFloats(std::istream& in, std::size_t count)
{
  std::vector<std::uint32_t> raw(count);
  in.read(reinterpret_cast<char*>(raw.data()), static_cast<std::streamsize>(4 * count));
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::uint32_t swapped = __builtin_bswap32(raw[i]);
    std::memcpy(&values[i], &swapped, 4);
  }
  return values;
}

inline std::vector<glm::vec3> ToVectors(const std::vector<float>& values)
{
  std::vector<glm::vec3> vectors(values.size() / 3);
  for (std::size_t i = 0; i < vectors.size(); ++i)
  {
    vectors[i] = { values[3 * i], values[3 * i + 1], values[3 * i + 2] };
  }
  return vectors;
}

/// The points of a binary legacy file of floats.
inline std::vector<glm::vec3> ReadPoints(std::istream& in)
{
  std::string word;
  while (in >> word && word != "POINTS")
  {
  }
  std::size_t count = 0;
  in >> count >> word;
  in.get();
  return ToVectors(ReadFloats(in, 3 * count));
}

/// The first `count` floats of the array of that name, which comes after what was read so far.
inline std::vector<float> ReadArray(std::istream& in, const std::string& name, std::size_t count)
{
  std::string word;
  while (in >> word && word != name)
  {
  }
  std::getline(in, word);
  return ReadFloats(in, count);
}

struct Spheres
{
  std::vector<glm::vec3> centers;
  float radius = 0.0f;
};

/// A file by Data/spheres_280k.py: its points and the first value of its array `radius`.
inline Spheres ReadSpheres(const std::string& path)
{
  Spheres spheres;
  std::ifstream in(path, std::ios::binary);
  spheres.centers = ReadPoints(in);
  const std::vector<float> radii = ReadArray(in, "radius", 1);
  if (!in || spheres.centers.empty())
  {
    throw std::runtime_error(path + " is no file by spheres_280k.py");
  }
  spheres.radius = radii[0];
  return spheres;
}

/// The camera of spheres_280k.py: the box's near face just fills a square view of 30 degrees.
inline rtg::Camera SpheresCamera()
{
  return LookAt({ 50.0, 50.0, 286.6025 }, { 50.0, 50.0, 0.0 }, { 0.0, 1.0, 0.0 }, 30.0, 180.0, 300.0);
}

} // namespace benchmark
