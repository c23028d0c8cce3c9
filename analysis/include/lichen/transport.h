// SPDX-License-Identifier: MIT
// What a bake spends on optimal transport, and what it can prove of the result.
#pragma once

namespace lichen {

/// How near to the optimum a transport is brought: what it costs over the optimum at most, measured
/// on the exemplars of docs/decisions/008-multiscale-transport.md.
enum class TransportEffort {
  fast,     ///< 0.4 %; for a first look
  standard, ///< 0.1 %; for production
  exact,    ///< 0.02 %, and proves it; ten times as long or more, most of it for the proof
};

/// Cost of a matching and a certified lower bound of every matching's. All in squared units of the
/// points, means over the pairs.
struct TransportBound {
  double lowerBound = 0.0; ///< no bijection costs less
  double cost = 0.0;       ///< mean squared distance over the pairs matched
  /// `cost` less the squared distance of the two means, which every bijection pays.
  double centredCost = 0.0;

  /// The part of centredCost that a better matching might save, at most.
  [[nodiscard]] double excess() const {
    return centredCost > 0.0 ? (cost - lowerBound) / centredCost : 0.0;
  }
};

} // namespace lichen
