// SPDX-License-Identifier: MIT
// The cumulative distribution of the Gaussian N(1/2, (1/6)^2) per channel: Gaussian value ->
// uniform value, the coordinate in an inverse table.
#ifndef LICHEN_GAUSSIAN_CDF_GLSL
#define LICHEN_GAUSSIAN_CDF_GLSL

vec3 lichenGaussianCdf(vec3 gaussian) {
  // [HN18] eq. 22, as the odd polynomial of degree 9 of least error, 1.9e-4, over 2.885 deviations
  // each way: there it reaches the middle of the outermost of 256 cells.
  const float kReach = 0.48083;
  vec3 x = clamp(gaussian - 0.5, -kReach, kReach);
  vec3 q = x * x;
  return 0.5 + x * (2.3890824 +
                    q * (-13.9188528 + q * (65.2096975 + q * (-182.1468761 + q * 220.6686413))));
}

#endif
