// SPDX-License-Identifier: MIT
// Tiling with fewer fetches than three: a triangle with its weights -> the same, sorted by weight,
// of which some weights are 0 and not fetched. What is left still sums to 1, and the blend divides
// by the root of the sum of squares, so that mean, variance and histogram stay.
// The CPU twin is analysis/tiling/fewer_taps; docs/decisions/023-fewer-taps.md has what it costs.
#ifndef LICHEN_FEWER_TAPS_GLSL
#define LICHEN_FEWER_TAPS_GLSL

#include "tiling.glsl"

// How many tiles are fetched at most, 3 or 2. A literal, or the host's specialization constant.
#ifndef LICHEN_TILING_TAPS
#define LICHEN_TILING_TAPS 3
#endif

// Pixels of this side and larger [tiles] take one tap, which begins at half of it; 0.0 where none
// do. Likewise.
#ifndef LICHEN_ONE_TAP_TILES
#define LICHEN_ONE_TAP_TILES 0.0
#endif

/// Whether some tiles are left out anywhere; known at compile time.
bool lichenHasFewerTaps() { return LICHEN_TILING_TAPS < 3 || LICHEN_ONE_TAP_TILES > 0.0; }

/// Whether a tile is fetched. All are where none are left out.
bool lichenIsFetched(float weight) { return lichenHasFewerTaps() ? weight > 0.0 : true; }

/// The progress from all taps to one of a pixel with these derivatives [tiles], [0, 1].
float lichenOneTapShare(vec2 gradientX, vec2 gradientY) {
  if (LICHEN_ONE_TAP_TILES <= 0.0)
    return 0.0;
  // The side of the square of the pixel's area. Of more slant than this it counts as of this, as it
  // does for the level (lichenFootprintLevel).
  const float kMostSlant = 16.0;
  float squared = max(dot(gradientX, gradientX), dot(gradientY, gradientY));
  float area = abs(gradientX.x * gradientY.y - gradientX.y * gradientY.x);
  float side = sqrt(max(area, squared / kMostSlant));
  return clamp(2.0 * side / LICHEN_ONE_TAP_TILES - 1.0, 0.0, 1.0);
}

/// Exchanges two vertices if the first has less weight.
void lichenOrder(inout float weightA, inout uvec2 vertexA, inout float weightB,
                 inout uvec2 vertexB) {
  bool isSwapped = weightA < weightB;
  float weight = isSwapped ? weightA : weightB;
  uvec2 vertex = isSwapped ? vertexA : vertexB;
  weightA = isSwapped ? weightB : weightA;
  vertexA = isSwapped ? vertexB : vertexA;
  weightB = weight;
  vertexB = vertex;
}

/// Sorts the vertices by weight, the largest first, and subtracts the same amount from all weights,
/// so that as many become 0 as the switches ask. `triangle.weights` sum to 1, before and after.
void lichenReduceTaps(inout LichenTriangle triangle, vec2 gradientX, vec2 gradientY) {
  lichenOrder(triangle.weights.x, triangle.vertex0, triangle.weights.y, triangle.vertex1);
  lichenOrder(triangle.weights.y, triangle.vertex1, triangle.weights.z, triangle.vertex2);
  lichenOrder(triangle.weights.x, triangle.vertex0, triangle.weights.y, triangle.vertex1);
  vec3 weights = triangle.weights;
  // Less the least weight, two are left, and on an edge of the triangle, where the least is 0,
  // nothing is taken. Less the second, one is.
  float taken = LICHEN_TILING_TAPS < 3 ? weights.z : 0.0;
  float share = lichenOneTapShare(gradientX, gradientY);
  taken = share < 1.0 ? mix(taken, weights.y, share) : weights.y;
  weights = max(weights - taken, 0.0);
  float sum = weights.x + weights.y + weights.z;
  // Where the greatest are alike and nothing is left, any of them serves.
  triangle.weights = sum > 0.0 ? weights / sum : vec3(1.0, 0.0, 0.0);
}

#endif
