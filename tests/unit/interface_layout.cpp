// SPDX-License-Identifier: MIT
// The structs of shaders_glsl/interface/ have the same layout in std140, std430 and C++. The
// asserts are generated from a probe shader's SPIR-V (cmake/check_interface_layout.cmake).
#include <lichen/lichen.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <interface_layout_asserts.h>
#include <lichen_interface.h>
#include <type_traits>

TEST_CASE("the blocks of the C interface are the shader's") {
  CHECK(sizeof(lichen::shader::LichenNoiseConstants) == LICHEN_NOISE_BYTES);
  CHECK(sizeof(lichen::shader::LichenMaterial) == LICHEN_MATERIAL_BYTES);
  CHECK(sizeof(lichen::shader::LichenTriplanarMaterial) == LICHEN_TRIPLANAR_MATERIAL_BYTES);
  CHECK(sizeof(lichen::shader::LichenLayeredMaterial) == LICHEN_LAYERED_MATERIAL_BYTES);
}

TEST_CASE("the methods' parts of a material fit its own words") {
  constexpr std::size_t kOwn =
      sizeof(lichen::shader::LichenMaterial) - offsetof(lichen::shader::LichenMaterial, own0);
  CHECK(sizeof(lichen::shader::LichenTilingMaterial) <= kOwn);
  CHECK(sizeof(lichen::shader::LichenTextonMaterial) <= kOwn);
  CHECK(sizeof(lichen::shader::LichenCosinesMaterial) <= kOwn);
  CHECK(sizeof(lichen::shader::LichenKernelsMaterial) <= kOwn);
}

TEST_CASE("the methods' parts of a noise fit its own words") {
  constexpr std::size_t kOwn =
      sizeof(lichen::shader::LichenNoise) - offsetof(lichen::shader::LichenNoise, own0);
  CHECK(sizeof(lichen::shader::LichenTilingNoise) <= kOwn);
  CHECK(sizeof(lichen::shader::LichenTextonNoise) <= kOwn);
  CHECK(sizeof(lichen::shader::LichenCosinesNoise) <= kOwn);
  CHECK(sizeof(lichen::shader::LichenKernelsNoise) <= kOwn);
  CHECK(sizeof(lichen::shader::LichenQuiltingNoise) <= kOwn);
}

TEST_CASE("an array of noise constants fits any device's minUniformBufferOffsetAlignment") {
  constexpr int kLargestAllowed = 256; // Vulkan 1.0, Required Limits
  CHECK(LICHEN_NOISE_BYTES % kLargestAllowed == 0);
}
