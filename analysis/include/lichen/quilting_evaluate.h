// SPDX-License-Identifier: MIT
// The CPU twin of shaders_glsl/noise/quilting.glsl, and of triplanar.glsl for quilting. Needs only
// the bundle.
#pragma once

#include <lichen/bundle.h>
#include <lichen/result.h>
#include <lichen/shader_parameters.h>
#include <lichen/tile_footprint.h>
#include <lichen/triplanar_footprint.h>

#include <array>
#include <cstddef>
#include <memory>

namespace lichen {

/// The decoded images of one noise. Immutable: several threads may evaluate it at once.
class QuiltingEvaluator {
public:
  using Value = std::array<float, 4>;

  /// Decodes the images of noise `noise`. The bundle must have been parsed or baked without error.
  /// The evaluator does not refer to the bundle afterwards. Errors: usage for an index out of range
  /// or another method; resources if memory runs out. Time and memory: 16 bytes per texel.
  [[nodiscard]] static Result<QuiltingEvaluator> create(const Bundle& bundle, std::size_t noise);

  [[nodiscard]] std::size_t mapCount() const;

  /// As TilingEvaluator::evaluate().
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenMaterial& material,
                               const TileFootprint& at) const;
  [[nodiscard]] Value evaluate(std::size_t map, const shader::LichenTriplanarMaterial& material,
                               const TriplanarFootprint& at) const;

private:
  struct Images;

  explicit QuiltingEvaluator(std::shared_ptr<const Images> images) : images_(std::move(images)) {}

  [[nodiscard]] Value blend(std::size_t map, const shader::LichenMaterial& material,
                            const TileFootprint& at) const;

  std::shared_ptr<const Images> images_;
};

} // namespace lichen
