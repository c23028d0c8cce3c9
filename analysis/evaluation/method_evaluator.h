// SPDX-License-Identifier: MIT
// A noise of one method at points, with the parameters of any material.
#pragma once

#include "sampling/texels.h"

#include <lichen/noise_evaluator.h>

namespace lichen {

/// The decoded tables of a noise without layers. Immutable: several threads may evaluate it at
/// once.
class MethodEvaluator {
public:
  using Value = NoiseEvaluator::Value;
  using Material = shader::LichenTriplanarMaterial;

  /// A value before it is decoded. For quilting, the decoded value about its mean, plus 1/2.
  struct Gaussian {
    std::array<float, 3> value; ///< mean 1/2; deviation 1/6 where no variance is lost
    std::array<float, 3> lost;  ///< share of each channel's variance that filtering lost
  };

  virtual ~MethodEvaluator() = default;

  /// As NoiseEvaluator::evaluate(), of a map below mapCount(). `material` is what shaderMaterial()
  /// makes for this noise and the footprint's mapping, which the method supports.
  [[nodiscard]] virtual Value evaluate(std::size_t map, const Material& material,
                                       const Footprint& at, const MixPlace& mix = {}) const = 0;

  /// The same at points of a plane; `values` has as many.
  virtual void evaluate(std::size_t map, const Material& material,
                        std::span<const PlanePoint> points, std::span<Value> values) const = 0;

  /// evaluate() before decoding.
  [[nodiscard]] virtual Gaussian gaussian(std::size_t map, const Material& material,
                                          const Footprint& at, const MixPlace& mix = {}) const = 0;

  /// What a Gaussian value stands for where nothing is lost. The method is one with tables.
  [[nodiscard]] virtual Value decoded(std::size_t map,
                                      const std::array<float, 3>& gaussian) const = 0;

  /// Where the material's weight of a mix is constant or a direction, the position in the mix.
  [[nodiscard]] virtual MixPlace mixAt(const Material& material,
                                       const std::array<float, 2>& uv) const = 0;
};

/// Decodes the tables of noise `noise`, a valid index, which has no layers. Throws std::bad_alloc.
[[nodiscard]] std::shared_ptr<const MethodEvaluator>
methodEvaluator(const Bundle& bundle, std::size_t noise, const EvaluationOptions& options = {});

/// The same for the noises of one method, each in that method's evaluate.cpp.
using MethodEvaluatorMaker = std::shared_ptr<const MethodEvaluator>(const Bundle&, std::size_t,
                                                                    const EvaluationOptions&);
MethodEvaluatorMaker tilingEvaluator, textonEvaluator, localRandomPhaseEvaluator,
    multipleKernelsEvaluator, quiltingEvaluator;

/// A map of a noise, as one material uses it.
struct WideMap {
  const shader::LichenNoise& noise;
  const shader::LichenMaterial& material;
  const shader::LichenMap& map;
  const RepeatingImage& image;
  const ClampedVolume& table;
  bool nearestTableLevel;
};

/// The values at the first points; how many. Not the last ones, if their number is no multiple of
/// the lanes, and none from points on that take different branches.
using WideEvaluation = std::size_t(const WideMap&, std::span<const PlanePoint>,
                                   std::span<NoiseEvaluator::Value>);
/// Each in its method's evaluate_wide.cpp.
WideEvaluation tilingWide, localRandomPhaseWide;

} // namespace lichen
