// SPDX-License-Identifier: MIT
// The spectrum that a window gives to a cosine, summed over rectangles of frequencies, and its
// autocorrelation.
#pragma once

#include <vector>

namespace lichen::local_random_phase {

/// The power spectral density of a cosine of frequency 0 and variance 1 under the windows of a
/// lattice, on average over the lattice, as a summed-area table over frequencies in cycles per
/// edge.
class WindowSpectrum {
public:
  /// Throws std::bad_alloc. About 10 ms.
  WindowSpectrum();

  /// The integral of the density over all frequencies below (x, y) along both axes: rises from 0 to
  /// 1.
  [[nodiscard]] double below(double x, double y) const;

  /// The autocovariance of that cosine at the lag (x, y) in edges: 1 at (0, 0), 0 where windows do
  /// not meet.
  [[nodiscard]] double correlation(double x, double y) const;

private:
  std::vector<double> sums_;
  std::vector<float> correlation_;
};

} // namespace lichen::local_random_phase
