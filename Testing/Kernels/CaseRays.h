// How many rays the tests of numerics send at each glyph of a case, and the seed of these: few and always the same in
// the default suite, others every day and sixteen times as many under the label `long`.
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

/// RTGLYPHS_RAYS: so many times the usual number of rays.
inline int TimesRays()
{
  const char* times = std::getenv("RTGLYPHS_RAYS");
  return times ? std::atoi(times) : 1;
}

/// The cases of a subject by that seed.
inline HardCaseMaker Cases(const Subject& subject, int glyphs, int usualRays)
{
  return HardCaseMaker(subject, glyphs, usualRays * TimesRays(), Seed());
}

} // namespace rtg::testing
