// SPDX-License-Identifier: MIT
// The structs of shaders_glsl/interface/ have the same layout in std140, std430 and C++. The
// asserts are generated from a probe shader's SPIR-V (cmake/check_interface_layout.cmake).
#include <lichen/lichen.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <interface_layout_asserts.h>
#include <lichen_interface.h>
#include <type_traits>

TEST_CASE("the uniform block of the C interface is the shader's") {
  CHECK(sizeof(lichen::shader::LichenUniforms) == LICHEN_UNIFORM_BYTES);
}

TEST_CASE("an array of uniform blocks fits any device's minUniformBufferOffsetAlignment") {
  constexpr int kLargestAllowed = 256; // Vulkan 1.0, Required Limits
  CHECK(LICHEN_UNIFORM_BYTES % kLargestAllowed == 0);
}
