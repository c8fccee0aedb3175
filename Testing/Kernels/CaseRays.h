// How many rays the tests of numerics send at each glyph of a case, and the seed of these: few and always the same in
// the default suite, others every day and eight times as many under the label `long`.
#pragma once

#include "HardCases.h"

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>

namespace rtg::testing
{

/// RTGLYPHS_SEED: a number, or `day` for the number of today's day, which is printed.
inline std::uint64_t Seed()
{
  const char* text = std::getenv("RTGLYPHS_SEED");
  if (!text)
  {
    return HardCaseMaker::usualSeed;
  }
  if (std::string(text) != "day")
  {
    return std::strtoull(text, nullptr, 10);
  }
  const auto days = std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()).time_since_epoch().count();
  std::cout << "RTGLYPHS_SEED=" << days << "\n";
  return std::uint64_t(days);
}

/// The cases of a subject by that seed, with the usual number of rays times RTGLYPHS_RAYS.
inline HardCaseMaker Cases(const Subject& subject, int glyphs, int usualRays)
{
  const char* times = std::getenv("RTGLYPHS_RAYS");
  return HardCaseMaker(subject, glyphs, usualRays * (times ? std::atoi(times) : 1), Seed());
}

} // namespace rtg::testing
