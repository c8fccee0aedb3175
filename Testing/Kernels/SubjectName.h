#pragma once

#include "HardCases.h"

#include <gtest/gtest.h>

#include <cctype>
#include <string>

namespace rtg::testing
{

/// A subject's name as GoogleTest allows it in that of a test.
inline std::string SubjectName(const ::testing::TestParamInfo<Subject>& info)
{
  std::string name = info.param.name;
  for (char& c : name)
  {
    c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  }
  return name;
}

} // namespace rtg::testing
