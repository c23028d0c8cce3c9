// SPDX-License-Identifier: MIT
// B-spline interpolation of texton coefficients, seen as a filter.
#pragma once

#include <vector>

namespace lichen::texton {

/// b_j, j = 0 .. order: the B-spline of degree 2 order + 1 at the integers, which is the
/// autocorrelation of the interpolation kernel of that order; b_-j = b_j, and sum over all j is 1.
/// order in [0, 8]. Source: [GLM17] section 4.1; [UAE93].
[[nodiscard]] std::vector<double> kernelAutocorrelation(int order);

/// b^(x), its Fourier series at x cycles a texel, > 0; (2 + cos 2 pi x) / 3 for order 1.
[[nodiscard]] double kernelPower(int order, double cyclesPerTexel);

/// sqrt(b^) at the `size` frequencies of a row of that many texels.
[[nodiscard]] std::vector<float> kernelAmplitudes(int order, int size);

} // namespace lichen::texton
