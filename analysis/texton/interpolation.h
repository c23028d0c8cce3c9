// SPDX-License-Identifier: MIT
// B-spline interpolation of texton coefficients, treated as a filter.
#pragma once

#include <vector>

namespace lichen::texton {

/// Returns b_j, j = 0 .. order: the B-spline of degree 2 order + 1 at the integers, which is the
/// autocorrelation of the interpolation kernel of that order. b_-j = b_j, and the sum over all j is
/// 1. order in [0, 8]. Source: [GLM17] section 4.1; [UAE93].
[[nodiscard]] std::vector<double> kernelAutocorrelation(int order);

/// Returns b^(x), the Fourier series of b at x cycles per texel, > 0. For order 1 it is (2 + cos 2
/// pi x) / 3.
[[nodiscard]] double kernelPower(int order, double cyclesPerTexel);

/// Returns sqrt(b^) at the `size` frequencies of a row of `size` texels.
[[nodiscard]] std::vector<float> kernelAmplitudes(int order, int size);

} // namespace lichen::texton
