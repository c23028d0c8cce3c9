// SPDX-License-Identifier: MIT
// Adapts the twin of a method that lies in planes, with the mappings uv and triplanar, and surface
// and solid if it has them, to the interface that all methods share.
#pragma once

#include <lichen/noise_evaluator.h>

#include <cassert>
#include <memory>
#include <utility>

namespace lichen {

/// `Twin` has the two functions evaluate(map, material, footprint) of TilingEvaluator, and those of
/// MultipleKernelsEvaluator for surfaces, solids and gradients if it has these.
template <class Twin>
class PlaneEvaluator final : public NoiseEvaluator {
public:
  PlaneEvaluator(Twin twin, const Noise& noise, const shader::LichenTriplanarMaterial& constants)
      : NoiseEvaluator(noise, constants), twin_(std::move(twin)) {}

  [[nodiscard]] Value evaluate(std::size_t map, const TileFootprint& at,
                               const MixPlace&) const override {
    return twin_.evaluate(map, constants(), at);
  }
  [[nodiscard]] Value evaluate(std::size_t map, const TriplanarFootprint& at,
                               const MixPlace&) const override {
    return twin_.evaluate(map, planes(), at);
  }
  [[nodiscard]] Value evaluate(std::size_t map, const SurfaceFootprint& at,
                               const MixPlace&) const override {
    if constexpr (requires { twin_.evaluate(map, constants(), at); })
      return twin_.evaluate(map, constants(), at);
    assert(!"the method does not fit the mapping surface, and create() refuses it");
    return {};
  }
  [[nodiscard]] Value evaluate(std::size_t map, const SolidFootprint& at) const override {
    if constexpr (requires { twin_.evaluate(map, constants(), at); })
      return twin_.evaluate(map, constants(), at);
    assert(!"the method does not fit the mapping solid, and create() refuses it");
    return {};
  }
  [[nodiscard]] std::array<float, 3> evaluateGradient(std::size_t map, const TileFootprint& at,
                                                      const MixPlace& mix) const override {
    if constexpr (requires { twin_.gradient(map, constants(), at); })
      return twin_.gradient(map, constants(), at);
    return NoiseEvaluator::evaluateGradient(map, at, mix);
  }

private:
  Twin twin_;
};

/// The evaluator of `created`, or its error.
template <class Twin>
[[nodiscard]] Result<std::unique_ptr<const NoiseEvaluator>>
planeEvaluator(Result<Twin> created, const Bundle& bundle, const MaterialNoise& material,
               const Placement& placement) {
  if (!created)
    return created.error();
  return std::unique_ptr<const NoiseEvaluator>(std::make_unique<PlaneEvaluator<Twin>>(
      std::move(created).value(), bundle.noises[material.noise],
      shaderMaterial(bundle, material, placement)));
}

} // namespace lichen
