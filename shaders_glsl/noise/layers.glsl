// SPDX-License-Identifier: MIT
// A layered noise: Gaussian values of index maps -> weights of the layers; their values -> a blend
// that preserves the variance. [MKN12] section 5; docs/decisions/010-multiple-kernels.md.

/// The share of a node that lies above its threshold. `index` is the value of its index map: the
/// Gaussian value, and in w what filtering lost of its variance. Its mean over all points is the
/// same whatever is lost.
float lichenIndexWeight(vec4 index, float threshold, float softness) {
  // The mean of a Gaussian transition over a Gaussian footprint is a wider one. Where the
  // polynomial is constant, beyond 2.885 deviations, it is within this of 0 or 1, which layers
  // without a share need.
  const float kLeast = 0.0022;
  float z = 6.0 * (index.x - 0.5);
  float deviation = sqrt(softness * softness + max(index.w, 0.0));
  float below = lichenGaussianCdf(vec3(0.5 + (z - threshold) / (6.0 * deviation))).x;
  return clamp((below - kLeast) / (1.0 - 2.0 * kLeast), 0.0, 1.0);
}

/// The factor of a node in the weight of a layer that lies on this side of it.
float lichenSideWeight(uint sides, int node, float above) {
  uint side = (sides >> uint(2 * node)) & 3u;
  return side == 1u ? 1.0 - above : (side == 2u ? above : 1.0);
}

/// The weights of all layers, from the shares above of all nodes; they add up to 1.
vec4 lichenLayerWeights(vec3 above, LichenLayers layers) {
  vec4 weights = vec4(0.0);
  for (int layer = 0; layer < LICHEN_MAX_LAYERS; ++layer) {
    if (uint(layer) >= max(layers.count, 1u))
      break;
    float weight = 1.0;
    for (int node = 0; node < LICHEN_MAX_LAYER_NODES; ++node)
      weight *= lichenSideWeight(layers.sides[layer], node, above[node]);
    weights[layer] = weight;
  }
  return weights;
}

/// The sum of layers about their means.
struct LichenLayerSum {
  vec4 means, rest;
  float squares; // of the weights
};

LichenLayerSum lichenNoLayers() { return LichenLayerSum(vec4(0.0), vec4(0.0), 0.0); }

/// Adds a layer's value. `mean` is the mean of its map, 0 for slopes.
void lichenAddLayer(LICHEN_INOUT(LichenLayerSum) sum, float weight, vec4 value, vec4 mean) {
  sum.means += weight * mean;
  sum.rest += weight * (value - mean);
  sum.squares += weight * weight;
}

/// The blend. `linear` is 1 in the components that are averaged: a variance of slopes.
vec4 lichenLayered(LichenLayerSum sum, vec4 linear) {
  // [HN18] eq. 8, about the blended means: layers are independent.
  return sum.means + mix(vec4(inversesqrt(sum.squares)), vec4(1.0), linear) * sum.rest;
}
