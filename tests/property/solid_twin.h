// SPDX-License-Identifier: MIT
// The CPU twin of whichever method a bundle's noise has, of those that have solids.
#pragma once

#include <lichen/local_random_phase_evaluate.h>
#include <lichen/multiple_kernels_evaluate.h>

#include <array>
#include <optional>

namespace lichen::test {

/// Evaluates the first map of the first noise.
class SolidTwin {
public:
  explicit SolidTwin(const Bundle& bundle) {
    if (bundle.noises[0].method() == Method::multipleKernels)
      kernels_ = MultipleKernelsEvaluator::create(bundle, 0).value();
    else
      cosines_ = LocalRandomPhaseEvaluator::create(bundle, 0).value();
  }

  template <class Footprint>
  [[nodiscard]] std::array<float, 4> gaussian(const shader::LichenMaterial& material,
                                              const Footprint& at) const {
    return kernels_ ? kernels_->gaussian(0, material, at) : cosines_->gaussian(0, material, at);
  }
  template <class Footprint>
  [[nodiscard]] std::array<float, 4> evaluate(const shader::LichenMaterial& material,
                                              const Footprint& at) const {
    return kernels_ ? kernels_->evaluate(0, material, at) : cosines_->evaluate(0, material, at);
  }

private:
  std::optional<MultipleKernelsEvaluator> kernels_;
  std::optional<LocalRandomPhaseEvaluator> cosines_;
};

} // namespace lichen::test
