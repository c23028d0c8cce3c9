// SPDX-License-Identifier: MIT
// What a Gaussian value stands for: (Gaussian value, share of its variance that filtering lost) ->
// the mean, over what is lost, of the decoded quantity. Shared by all methods. For slopes, z is
// the variance of a slope lost to filtering. [HN18] section 4.3;
// docs/gltf_extension/README.md, "Decoding".

/// The cumulative distribution of N(1/2, (1/6)^2) per channel: a Gaussian value -> a uniform one,
/// the coordinate in an inverse table.
vec3 lichenGaussianCdf(vec3 gaussian) {
  // [HN18] eq. 22, as the odd polynomial of degree 9 of least error, 1.9e-4, over 2.885 deviations
  // each way: there it reaches the middle of the outermost of 256 cells.
  const float kReach = 0.48083;
  vec3 x = clamp(gaussian - 0.5, -kReach, kReach);
  vec3 q = x * x;
  return 0.5 + x * (2.3890824 +
                    q * (-13.9188528 + q * (65.2096975 + q * (-182.1468761 + q * 220.6686413))));
}

// 1 fetches the nearest mip level of a table alone: cheaper, and colours change in steps with
// distance. A literal, or the host's specialization constant.
#ifndef LICHEN_NEAREST_TABLE_LEVEL
#define LICHEN_NEAREST_TABLE_LEVEL 0
#endif

/// The Gaussian value of a map at a point.
struct LichenGaussian {
  vec3 value;       // mean 1/2; deviation 1/6 where nothing is lost
  vec3 lost;        // the share of each channel's variance that filtering lost
  float depthSlope; // of slopes in a solid: the one along z
};

/// `map` with the encoding that its role implies, except whether values exceed 1. Compilers can
/// then leave out the code of other encodings.
LichenMap lichenMapOf(int role, LichenMap map) {
  // docs/gltf_extension/README.md, "Maps".
  bool isColor = role == LICHEN_BASE_COLOR || role == LICHEN_EMISSIVE;
  bool isAboveOne = LICHEN_USES(LICHEN_FEATURE_VALUES_ABOVE_ONE) &&
                    (isColor || role == LICHEN_HEIGHT) && map.encoding == uint(LICHEN_ENCODING_LOG2);
  if (role == LICHEN_NORMAL)
    map.encoding = uint(LICHEN_ENCODING_SLOPE);
  else if (isColor)
    map.encoding = uint(isAboveOne ? LICHEN_ENCODING_LOG2 : LICHEN_ENCODING_ROOT);
  else
    map.encoding = uint(isAboveOne ? LICHEN_ENCODING_LOG2 : LICHEN_ENCODING_LINEAR);
  return map;
}

/// Occlusion, roughness and metallic, as glTF orders them, of a value of that role. Those that the
/// map does not have are taken from `absent`.
vec3 lichenOrm(vec3 value, vec3 absent, LichenMap map) {
  vec3 orm = absent;
  if ((map.ormChannels & 1u) != 0u) {
    orm.x = value.x;
    value = value.yzz;
  }
  if ((map.ormChannels & 2u) != 0u) {
    orm.y = value.x;
    value.x = value.y;
  }
  if ((map.ormChannels & 4u) != 0u)
    orm.z = value.x;
  return orm;
}

/// Decodes by an inverse table. Each mip level holds averages over the variance that is lost there.
vec4 lichenDecodeTable(LICHEN_IMAGE_3D table, vec3 gaussian, float lost, LichenMap map) {
  // Levels are equidistant in the amplitude that is left: 1, 0.8, ... 0.2. Where all is lost,
  // blended losses are rounded to a little more than 1.
  const float kLevels = 5.0;
  float level = kLevels - kLevels * sqrt(max(1.0 - lost, 0.0));
  if (bool(LICHEN_NEAREST_TABLE_LEVEL))
    level = floor(level + 0.5);
  vec4 value = LICHEN_SAMPLE_3D(table, lichenGaussianCdf(gaussian), level);
  // Roots of light are squared, other values are as stored.
  bool isRoot = map.encoding == uint(LICHEN_ENCODING_ROOT);
  return isRoot ? value * value : value;
}

/// Decodes without a table. Stored values are Gaussian; channel c has lost the share lost[c] of its
/// variance.
vec4 lichenDecodeGaussian(vec3 gaussian, vec3 lost, LichenMap map) {
#if LICHEN_LAYERS > 1
  if (map.encoding == uint(LICHEN_ENCODING_INDEX))
    return vec4(gaussian, lost.x);
#endif
  vec3 centred = gaussian - 0.5;
  vec3 stored =
      vec3(map.row0.w, map.row1.w, map.row2.w) +
      vec3(map.row0.x * centred.x, dot(map.row1.xy, centred.xy), dot(map.row2.xyz, centred));
  // A row is six times the root of the covariance, for Gaussian values of deviation 1/6.
  vec3 variance =
      lost / 36.0 *
      vec3(map.row0.x * map.row0.x, dot(map.row1.xy, map.row1.xy), dot(map.row2.xyz, map.row2.xyz));
  if (map.encoding == uint(LICHEN_ENCODING_SLOPE))
    return vec4(stored.xy, 0.5 * (variance.x + variance.y), 1.0);
  if (map.encoding == uint(LICHEN_ENCODING_LINEAR))
    return vec4(clamp(stored, 0.0, 1.0), 1.0);
  if (map.encoding == uint(LICHEN_ENCODING_LOG2)) {
    // The mean of 2^x for Gaussian x is 2^(mean + ln 2 / 2 variance).
    const float kHalfLn2 = 0.34657359;
    const float kMostLog = 16.0; // a half float holds no more light than 2^16
    return vec4(max(exp2(min(stored + kHalfLn2 * variance, kMostLog)) - 1.0, 0.0), 1.0);
  }
  // The mean of x^2 for Gaussian x. Not clamped: that would move the mean.
  return vec4(stored * stored + variance, 1.0);
}

/// The value that a Gaussian value stands for: light for colours, the decoded quantity for others.
/// `contrast` is the factor on the Gaussian value about its mean. It scales the lost part too.
vec4 lichenDecode(LICHEN_IMAGE_3D table, LichenGaussian gaussian, float contrast, LichenMap map) {
#if (LICHEN_METHODS & 16) != 0
  if (LICHEN_METHODS == 16 || map.decoding == uint(LICHEN_DECODING_NONE)) {
    vec3 here = map.mean.xyz + gaussian.value - 0.5;
    if (map.encoding == uint(LICHEN_ENCODING_SLOPE))
      return vec4(here.xy, max(here.z, 0.0), 1.0);
    return vec4(clamp(here, 0.0, map.encoding == uint(LICHEN_ENCODING_LOG2) ? 3.0e38 : 1.0), 1.0);
  }
#endif
  // In variables: of a specialization constant negated here, glslang 11 makes invalid SPIR-V.
  bool hasTables = LICHEN_USES(LICHEN_FEATURE_TABLES);
  bool hasGaussian = LICHEN_USES(LICHEN_FEATURE_GAUSSIAN_ONLY);
  bool isGaussian = !hasTables || map.decoding == uint(LICHEN_DECODING_GAUSSIAN);
#if LICHEN_LAYERS > 1
  bool isIndex = map.encoding == uint(LICHEN_ENCODING_INDEX);
  hasGaussian = hasGaussian || isIndex;
  isGaussian = isGaussian || isIndex;
#endif
  if (hasGaussian && isGaussian)
    return lichenDecodeGaussian(gaussian.value, contrast * contrast * gaussian.lost, map);
  // A table averages over no more than all of it.
  float within = min(contrast, 1.0);
  vec4 value = lichenDecodeTable(table, gaussian.value, within * within * gaussian.lost.x, map);
  // The variance of c g clamped to the table, over the variance of g, is 2 c - 1 within 3 % up to
  // c = 2 and within a quarter up to 4, for near-Gaussian slopes. Slopes in clusters have less.
  if (map.encoding == uint(LICHEN_ENCODING_SLOPE))
    value.z *= max(1.0, 2.0 * contrast - 1.0);
  return value;
}
