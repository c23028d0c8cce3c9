// SPDX-License-Identifier: MIT
// How often a decision about pictures is wrong, and what that says about all pictures of their
// kind.
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace lichen::test {

/// The highest rate at which as few errors or fewer among this many pictures still have a
/// probability of 5 %: the rate's upper bound at a confidence of 95 %, one-sided. The bound is that
/// of C. Clopper and E. Pearson, "The use of confidence or fiducial limits", 1934.
[[nodiscard]] inline double upperErrorBound(int errors, int pictures) {
  constexpr double kDoubt = 0.05;
  if (errors >= pictures)
    return 1.0;
  const auto probabilityAt = [&](double rate) {
    double one = std::pow(1.0 - rate, pictures), sum = one; // the probability of exactly k errors
    for (int k = 0; k < errors; ++k)
      sum += one *= rate / (1.0 - rate) * double(pictures - k) / double(k + 1);
    return sum;
  };
  double low = 0.0, high = 1.0; // the probability falls as the rate rises
  constexpr int kHalvings = 50;
  for (int step = 0; step < kHalvings; ++step) {
    const double middle = 0.5 * (low + high);
    (probabilityAt(middle) > kDoubt ? low : high) = middle;
  }
  return high;
}

/// The pictures about which a decision was wrong.
struct ErrorRate {
  int pictures = 0;
  std::vector<std::string> wrong; ///< their names

  [[nodiscard]] double upperBound() const { return upperErrorBound(int(wrong.size()), pictures); }
};

} // namespace lichen::test
