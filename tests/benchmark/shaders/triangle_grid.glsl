// SPDX-License-Identifier: MIT
// The triangle grid and the hash that the peers share: Deliot and Heitz, "Procedural Stochastic
// Textures by Tiling and Blending", GPU Zen 2, 2019. Mikkelsen's method has the same two.

const float kGridScale = 3.46410162; // 2 sqrt 3 vertices a tile
const float kSkewX = 0.57735027; // 1 / sqrt 3
const float kSkewY = 1.15470054; // 2 / sqrt 3

/// The triangle that contains a point: its vertices, in grid coordinates, and their weights.
struct Triangle {
  vec2 vertex1, vertex2, vertex3;
  vec3 weights; // sum to 1
};

Triangle triangleAt(vec2 point) {
  vec2 scaled = kGridScale * point;
  vec2 skewed = vec2(scaled.x - kSkewX * scaled.y, kSkewY * scaled.y);
  vec2 cell = floor(skewed);
  vec2 within = skewed - cell;
  float rest = 1.0 - within.x - within.y;
  float upper = step(rest, 0.0); // 1 in the triangle at (1, 1), 0 in that at (0, 0)
  float side = 1.0 - 2.0 * upper;
  Triangle triangle;
  triangle.vertex1 = cell + upper;
  triangle.vertex2 = cell + vec2(upper, 1.0 - upper);
  triangle.vertex3 = cell + vec2(1.0 - upper, upper);
  triangle.weights = vec3(side * rest, upper + side * within.yx);
  return triangle;
}

/// The random offset of a vertex, in [0, 1).
vec2 hashOf(vec2 vertex) {
  const mat2 kFrequencies = mat2(127.1, 269.5, 311.7, 183.3);
  const float kAmplitude = 43758.5453;
  return fract(kAmplitude * sin(kFrequencies * vertex));
}
