// One Vulkan device and one tracer for all tests of a program: starting a device and compiling its
// pipelines costs more than most tests.
#pragma once

#include "SceneState.h"
#include "Tracer.h"

#include <gtest/gtest.h>

#include <string>

namespace rtg::testing
{

/// The tracer of all tests, on Device::Shared(). It keeps pipelines and buffers from test to test, as a
/// view's tracer does from image to image. A test that counts pipelines or bytes makes its own tracer.
Tracer& SharedTracer();

/// What the device of all tests lacks for scenes with such structures; empty where it lacks nothing.
std::string WhatLacksFor(Structure structure);

/// Of the rtg::Error that work() throws; empty: it throws none.
template <class Work>
std::string MessageOf(const Work& work)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}

/// Skips a test of such scenes, with a word, where the device lacks something. In SetUp() or in the test itself.
#define RTG_NEEDS(structure)                                                                                           \
  do                                                                                                                   \
  {                                                                                                                    \
    const std::string lacks = rtg::testing::WhatLacksFor(structure);                                                   \
    if (!lacks.empty())                                                                                                \
    {                                                                                                                  \
      GTEST_SKIP() << "the device lacks " << lacks;                                                                    \
    }                                                                                                                  \
  } while (false)

/// A fixture with a scene, once with the driver's structure, as on GPUs, and once with our tree, as on CPU devices.
template <class Fixture>
class WithStructure
  : public Fixture
  , public ::testing::WithParamInterface<Structure>
{
protected:
  void SetUp() override
  {
    RTG_NEEDS(this->GetParam());
    this->Fixture::SetUp();
    this->scene.GetState().structure = this->GetParam();
  }
};

} // namespace rtg::testing
