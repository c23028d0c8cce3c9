// SPDX-License-Identifier: MIT
// Which of several methods to take for an exemplar.
#pragma once

#include <lichen/bundle.h>

#include <cstddef>
#include <span>

namespace lichen {

/// A method, what its noise costs and how near it looks.
struct MethodCandidate {
  Method method{};
  double plainFetches = 0.0; ///< time of a pixel in trilinear fetches, > 0
  double distance = 0.0;     ///< lookDistance() of its noise to the exemplar, >= 0
};

/// The index of the cheapest of at least one candidate, unless a dearer one is nearer by more than
/// a tenth and, on top, 0.002, which may be chance. Source: docs/decisions/032-method-choice.md.
[[nodiscard]] std::size_t nearestForItsCost(std::span<const MethodCandidate> candidates);

} // namespace lichen
