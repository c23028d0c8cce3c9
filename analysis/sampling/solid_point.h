// SPDX-License-Identifier: MIT
// What solids of all methods share: a point and its footprint in the space of tiles, and what sums
// over waves stand for. The CPU twin of solid_footprint.glsl and solid_method.glsl
// (shaders_glsl/noise) and of mapping/solid.glsl.
#pragma once

#include "gaussianization/value_decoder.h"
#include "vec3.h"

#include <lichen/shader_parameters.h>
#include <lichen/solid_footprint.h>

#include <array>

namespace lichen::solid {

using space::combined;
using space::dot;
using space::Vec3;

[[nodiscard]] Vec3 product(const Vec3& a, const Vec3& b);

/// The largest third frequency of a wave over the length of the two of the exemplar.
inline constexpr float kMostDepth = 1.2f;

/// Metres in space -> tiles, of a vector: the exemplar lies as on the plane that looks along z.
[[nodiscard]] Vec3 inTiles(const Vec3& metres, const shader::LichenMaterial& material,
                           const shader::LichenNoise& noise);

/// lichenSolidFootprint: axes of the footprint [tiles], less what a texel averages along each.
[[nodiscard]] std::array<Vec3, 2> footprintOf(const SolidFootprint& at,
                                              const shader::LichenMaterial& material,
                                              const shader::LichenNoise& noise);

/// Sums over the waves around a point.
struct Sum {
  std::array<float, 3> gaussian{};   ///< Gaussian values less their mean
  float depthSlope = 0.0f;           ///< of slopes: that along z, stored
  float squares = 0.0f, lost = 0.0f; ///< squared amplitudes, and what the footprint takes of them
};

/// The Gaussian value, and the share of its variance that filtering loses.
[[nodiscard]] std::array<float, 4> gaussianOf(const Sum& sum,
                                              const shader::LichenMaterial& material);

/// The decoded value; of slopes the gradient in space, and the lost variance.
[[nodiscard]] std::array<float, 4> valueOf(const Sum& sum,
                                           const gaussianization::ValueDecoder& decoder,
                                           const shader::LichenMaterial& material);

} // namespace lichen::solid
