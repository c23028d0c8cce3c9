// SPDX-License-Identifier: MIT
// How much effort a bake spends on optimal transport, and what it can prove about the result.
#pragma once

namespace lichen {

/// How close to the optimum a transport gets: its largest cost above the optimum, measured on the
/// exemplars of docs/decisions/008-multiscale-transport.md.
enum class TransportEffort {
  fast,     ///< 0.4 %; for previews
  standard, ///< 0.1 %; for production
  exact,    ///< 0.02 % and a proof; ten times as long or more, most of it for the proof
};

/// The cost of a matching and a certified lower bound for every matching. All in squared units of
/// the points, as means over the pairs.
struct TransportBound {
  double lowerBound = 0.0; ///< no bijection costs less
  double cost = 0.0;       ///< mean squared distance over the pairs matched
  /// `cost` minus the squared distance of the two means, which every bijection pays.
  double centredCost = 0.0;

  /// The largest part of centredCost that a better matching could save.
  [[nodiscard]] double excess() const {
    return centredCost > 0.0 ? (cost - lowerBound) / centredCost : 0.0;
  }
};

} // namespace lichen
