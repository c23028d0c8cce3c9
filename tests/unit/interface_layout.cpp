// SPDX-License-Identifier: MIT
// The structs of shaders_glsl/interface/ are laid out alike in std140, std430 and C++. The asserts
// are generated from a probe shader's SPIR-V (cmake/check_interface_layout.cmake).
#include <lichen/lichen.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <interface_layout_asserts.h>
#include <lichen_interface.h>
#include <type_traits>

TEST_CASE("the uniform block of the C interface is the shader's") {
  CHECK(sizeof(lichen::shader::LichenUniforms) == LICHEN_UNIFORM_BYTES);
}
