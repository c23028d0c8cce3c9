// SPDX-License-Identifier: MIT
// What a map's blended Gaussian value (float3), of this contrast, stands for, where filtering has
// taken the fraction `lostVariance` of its variance: the mean of the decoded quantity over what is
// missing. Of slopes, z is the variance of a slope over what is missing.
// [HN18] section 4.3; the two ways to decode are those of docs/gltf_extension/README.md, step 6.
#ifndef LICHEN_TILING_DECODE_GLSL
#define LICHEN_TILING_DECODE_GLSL

#include "../interface/lichen_interface.h"
#include "gaussian_cdf.glsl"

// 0 where no map has a joint table, or where every map has one. Literals, or the host's
// specialization constants. At least one is 1.
#ifndef LICHEN_JOINT_TABLES
#define LICHEN_JOINT_TABLES 1
#endif
#ifndef LICHEN_GAUSSIAN_ONLY
#define LICHEN_GAUSSIAN_ONLY 1
#endif

// Cells of a three-channel inverse table along each axis.
#define LICHEN_TABLE_CELLS 32.0

/// The level of the table that is prefiltered for this loss. Levels are equidistant in kept
/// amplitude. The last is the mean: nothing is kept. More contrast has more missing than that, but
/// comes there no sooner (lichenWithinTable).
float lichenTableLevel(float lostVariance, float contrast, LichenMap map) {
  float last = float(int(map.tableLevels)) - 1.0;
  float beforeLast = 1.0 / max(last * last, 1.0); // the variance that this level keeps
  float least = min(max(0.0, 1.0 - lostVariance), beforeLast);
  return last * (1.0 - sqrt(max(1.0 - contrast * contrast * lostVariance, least)));
}

/// The Gaussian value to look up, nearer to the mean where more is missing than the table averages
/// over: of a step the average is the same, and with such contrast a table is one.
vec3 lichenWithinTable(vec3 gaussian, float lostVariance, float contrast) {
  return 0.5 + (gaussian - 0.5) * inversesqrt(max(1.0, contrast * contrast * lostVariance));
}

/// One inverse table over all dimensions.
vec4 lichenDecodeJoint(sampler3D table, vec3 gaussian, float level, LichenMap map) {
  // T^-1 as a table over the Gaussian's distribution function, eq. 22.
  vec3 uniformValue = lichenGaussianCdf(gaussian);
  float levels = float(int(map.tableLevels));
  // One and two channels: the third coordinate is the level, and one fetch filters it too. Three: a
  // volume for each level, one behind the other; interpolation stays half a cell inside each.
  bool isVolume = map.dimensions == 3u;
  float slab = floor(level);
  float depth = clamp(LICHEN_TABLE_CELLS * uniformValue.z, 0.5, LICHEN_TABLE_CELLS - 0.5);
  vec3 place =
      vec3(uniformValue.xy, (isVolume ? slab + depth / LICHEN_TABLE_CELLS : level + 0.5) / levels);
  vec4 value = textureLod(table, place, 0.0);
  if (isVolume && level > slab) {
    place.z += 1.0 / levels;
    value = mix(value, textureLod(table, place, 0.0), level - slab);
  }
  return value;
}

/// The affine map of Gaussian decoding.
vec3 lichenDecodeRows(vec3 value, LichenMap map) {
  vec4 homogeneous = vec4(value, 1.0);
  return vec3(dot(map.row0, homogeneous), dot(map.row1, homogeneous), dot(map.row2, homogeneous));
}

/// A stored value -> the quantity, inside the range of its encoding.
vec3 lichenDecodeStored(vec3 stored, LichenMap map) {
  const float kMostLog = 16.0; // a half float's most light is below 2^16 - 1
  if (map.encoding == uint(LICHEN_ENCODING_SLOPE))
    return stored;
  if (map.encoding == uint(LICHEN_ENCODING_LOG2))
    return exp2(clamp(stored, 0.0, kMostLog)) - 1.0;
  vec3 value = clamp(stored, 0.0, 1.0);
  if (map.encoding == uint(LICHEN_ENCODING_LINEAR))
    return value;
  // IEC 61966-2-1.
  return mix(value / 12.92, pow((value + 0.055) / 1.055, vec3(2.4)),
             greaterThan(value, vec3(0.04045)));
}

/// The mean of 2^x - 1, x Gaussian and at least 0.
vec3 lichenMeanLog(vec3 stored, vec3 deviation) {
  const float kLn2 = 0.6931471806;
  const float kMostLog = 16.0;  // as in lichenDecodeStored
  const float kHalfMax = 65504.0; // the most light that a half float holds
  vec3 isAbove = lichenNormalCdf(stored / deviation);
  vec3 isAboveTilted = lichenNormalCdf(stored / deviation + kLn2 * deviation);
  vec3 light = exp2(min(stored + 0.5 * kLn2 * deviation * deviation, kMostLog));
  return min(light * isAboveTilted - isAbove, kHalfMax);
}

/// The mean of a stored value, Gaussian about `stored`, decoded.
vec3 lichenMeanDecoded(vec3 stored, vec3 deviation, LichenMap map) {
  const float kLeast = 1.0e-6; // deviations below it change nothing, and are divided by
  deviation = max(deviation, kLeast);
  if (map.encoding == uint(LICHEN_ENCODING_LOG2))
    return lichenMeanLog(stored, deviation);
  // Moments over [0, 1], by parts: M0, M1 = x M0 - s (g(1) - g(0)),
  // M(k) = x M(k - 1) + (k - 1) s^2 M(k - 2) - s g(1).
  vec3 below = lichenNormalCdf(-stored / deviation);
  vec3 above = lichenNormalCdf((stored - 1.0) / deviation);
  vec3 atZero = deviation * lichenNormalDensity(stored / deviation);
  vec3 atOne = deviation * lichenNormalDensity((stored - 1.0) / deviation);
  vec3 moment0 = 1.0 - below - above;
  vec3 moment1 = stored * moment0 + atZero - atOne;
  if (map.encoding == uint(LICHEN_ENCODING_LINEAR))
    return moment1 + above;
  vec3 variance = deviation * deviation;
  vec3 moment2 = stored * moment1 + variance * moment0 - atOne;
  vec3 moment3 = stored * moment2 + 2.0 * variance * moment1 - atOne;
  vec3 moment4 = stored * moment3 + 3.0 * variance * moment2 - atOne;
  // The sRGB curve as a polynomial through 0 and 1, whose own error where nothing is hidden is
  // taken back. Of all such that of the least error, 0.0005, for means from -0.1 to 1.1 and
  // deviations up to 0.4.
  const vec4 kCurve = vec4(0.038181, 0.525763, 0.568864, -0.132808);
  vec3 x = clamp(stored, 0.0, 1.0);
  vec3 curve = x * (kCurve.x + x * (kCurve.y + x * (kCurve.z + x * kCurve.w)));
  return kCurve.x * moment1 + kCurve.y * moment2 + kCurve.z * moment3 + kCurve.w * moment4 +
         above - curve + lichenDecodeStored(stored, map);
}

/// No table: the stored values are Gaussian themselves, each of which lacks its own fraction.
vec4 lichenDecodeGaussian(vec3 gaussian, vec3 lostVariance, LichenMap map) {
  vec3 stored = lichenDecodeRows(gaussian - 0.5, map);
  // A row is six times the root of the covariance, for values of deviation 1/6.
  const float kVariance = 1.0 / 36.0;
  vec3 variance = lostVariance * kVariance *
                  vec3(dot(map.row0.xyz, map.row0.xyz), dot(map.row1.xyz, map.row1.xyz),
                       dot(map.row2.xyz, map.row2.xyz));
  // Slopes decode linearly.
  if (map.encoding == uint(LICHEN_ENCODING_SLOPE))
    return vec4(stored.xy, 0.5 * (variance.x + variance.y), 1.0);
  return vec4(max(lichenMeanDecoded(stored, sqrt(variance), map), 0.0), 1.0);
}

/// The decoded value at a Gaussian value of which the fraction `lostVariance` is missing. `table`
/// is not fetched where the map has none.
vec4 lichenTilingDecode(sampler3D table, vec3 gaussian, float lostVariance, float contrast,
                        LichenMap map) {
  // In a variable: of a specialization constant negated below, glslang 11 makes invalid SPIR-V.
  bool hasJoint = bool(LICHEN_JOINT_TABLES);
  // If there is only one kind, it needs no test.
  bool isGaussian = map.decoding == uint(LICHEN_DECODING_GAUSSIAN) || !hasJoint;
  // Contrast scales what is missing with what is there.
  if (bool(LICHEN_GAUSSIAN_ONLY) && isGaussian)
    return lichenDecodeGaussian(gaussian, vec3(contrast * contrast * lostVariance), map);
  vec3 within = lichenWithinTable(gaussian, lostVariance, contrast);
  float level = lichenTableLevel(lostVariance, contrast, map);
  return lichenDecodeJoint(table, within, level, map);
}

#endif
