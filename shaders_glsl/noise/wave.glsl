// SPDX-License-Identifier: MIT
// A wave, and what a pixel leaves of it.

/// cos(2 pi turns), within 1.1e-4.
vec4 lichenCosineOfTurns(vec4 turns) {
  vec4 z = 0.25 - abs(turns - roundEven(turns));
  vec4 square = z * z;
  return z * (6.2812805 + square * (-41.0952 + square * 73.5855));
}

/// A squared length [texels^2] -> what is averaged beyond a texel, over which the exemplar has
/// averaged already: 0 up to 1, and soon all of it.
float lichenBeyondTexel(float squared) {
  float own = max(squared, 1.0);
  return own - 1.0 / (own * own * own);
}

/// The squared cycles that a pixel with these gradients [tiles / pixel] averages of a frequency f:
/// x f.x^2 + y f.y^2 + z f.x f.y. It counts what lies beyond a texel along each axis of the
/// footprint's ellipse.
vec3 lichenWaveFootprint(vec2 gradientX, vec2 gradientY, vec2 tileTexels) {
  vec2 columns = vec2(gradientX.x, gradientY.x) * tileTexels.x; // [texels / pixel]
  vec2 rows = vec2(gradientX.y, gradientY.y) * tileTexels.y;
  float xx = dot(columns, columns), yy = dot(rows, rows), product = dot(columns, rows);
  float mean = 0.5 * (xx + yy), halfDifference = 0.5 * (xx - yy);
  float apart =
      sqrt(halfDifference * halfDifference + product * product); // the axes, from the mean
  float longer = lichenBeyondTexel(mean + apart), shorter = lichenBeyondTexel(mean - apart);
  const float kLeast = 1.0e-20; // of a circle, whose axes are the same
  float slope = 0.5 * (longer - shorter) / max(apart, kLeast);
  return vec3(0.5 * (longer + shorter) + slope * vec2(halfDifference, -halfDifference),
              2.0 * slope * product) /
         vec3(tileTexels * tileTexels, tileTexels.x * tileTexels.y);
}

/// The amplitudes that a footprint leaves of cosines, for the squares of the cycles that it spans.
/// The mean of a cosine over x cycles is sinc x, 1 - pi^2 x^2 / 6 near 0, as this is.
vec4 lichenCosineRetained(vec4 squaredCycles) {
  const float kSlope = 0.548311356; // pi^2 / 18
  // Slanted pixels can be so long that the form is below 0 by rounding.
  vec4 left = clamp(1.0 - kSlope * squaredCycles, 0.0, 1.0);
  return left * left * left;
}
