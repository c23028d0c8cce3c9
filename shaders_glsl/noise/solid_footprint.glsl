// SPDX-License-Identifier: MIT
// A pixel in a solid, and what it averages of a frequency there.

/// The largest third frequency of a wave over the length of the two of the exemplar.
const float kLichenMostDepth = 1.2;

/// The axes of a pixel, less what a texel averages along each [tiles]: (F . a)^2 + (F . b)^2 are
/// the squared cycles of a frequency F.
struct LichenSolidFootprint {
  vec3 a, b;
};

/// The footprint of a pixel with these gradients [tiles / pixel].
LichenSolidFootprint lichenSolidFootprint(vec3 gradientX, vec3 gradientY, LichenNoise noise) {
  // The axes of the pixel in texels are the axes of the matrix of its gradients' products.
  vec3 texels = vec3(noise.tileTexelsX, noise.tileTexelsY, noise.tileTexelsX);
  vec3 texelsX = texels * gradientX, texelsY = texels * gradientY;
  float xx = dot(texelsX, texelsX), yy = dot(texelsY, texelsY), product = dot(texelsX, texelsY);
  float mean = 0.5 * (xx + yy), halfDifference = 0.5 * (xx - yy);
  float apart = sqrt(halfDifference * halfDifference + product * product);
  const float kLeast = 1.0e-20; // of a circle, whose axes are the same
  float longer = sqrt(lichenBeyondTexel(mean + apart) / max(mean + apart, kLeast));
  float shorter = sqrt(lichenBeyondTexel(mean - apart) / max(mean - apart, kLeast));
  // A function of that matrix, by its values at both squared lengths.
  float slope = 0.5 * (longer - shorter) / max(apart, kLeast);
  float middle = 0.5 * (longer + shorter);
  return LichenSolidFootprint(
      (middle + slope * halfDifference) * gradientX + slope * product * gradientY,
      slope * product * gradientX + (middle - slope * halfDifference) * gradientY);
}
