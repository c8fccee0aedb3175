// One Vulkan device and one tracer for all tests of a program: starting a device and compiling its
// pipelines costs more than most tests.
#pragma once

#include "Tracer.h"

namespace rtg::testing
{

/// The tracer of all tests, on Device::Shared(). It keeps pipelines and buffers from test to test, as a
/// view's tracer does from image to image. A test that counts pipelines or bytes makes its own tracer.
Tracer& SharedTracer();

} // namespace rtg::testing
