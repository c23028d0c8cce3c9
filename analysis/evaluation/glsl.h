// SPDX-License-Identifier: MIT
// GLSL in C++: the scalars, vectors, matrices and built-in functions that the shader library uses,
// so that shaders_glsl/ compiles as C++ and computes what a device computes, up to rounding.
// Literals without f, constructors and conversions are as in GLSL. Swizzles are functions that
// return copies; shader_library.h makes names of them. [GLSL] The OpenGL Shading Language 4.60,
// chapters 5 and 8.
#pragma once

#include "glsl_scalars.h"

namespace lichen::glsl {
namespace { // as the scalars are

#define LICHEN_ORDERED(T)                                                                          \
  inline T min(T a, T b) { return chosen(b < a, b, a); }                                           \
  inline T max(T a, T b) { return chosen(a < b, b, a); }                                           \
  inline T clamp(T x, T low, T high) { return min(max(x, low), high); }
LICHEN_ORDERED(Float)
LICHEN_ORDERED(Int)
LICHEN_ORDERED(uint)
#undef LICHEN_ORDERED
inline Int abs(Int x) { return chosen(x < 0, -x, x); }
inline uint floatBitsToUint(Float x) { return std::bit_cast<uint>(x); }
inline Float uintBitsToFloat(uint x) { return std::bit_cast<Float>(x); }
/// By conversion: without SSE 4.1 std::floor is a call. Floats from 2^23 on are whole.
inline Float floor(Float x) {
  constexpr float kWhole = 8388608.0f;
  const Truth isSmall = abs(x) < kWhole;
  const auto whole = Float(Int(chosen(isSmall, x, Float(0.0f))));
  return chosen(isSmall, chosen(whole > x, whole - 1.0f, whole), x);
}
inline Float ceil(Float x) { return -floor(-x); }
inline Float fract(Float x) { return x - floor(x); }
/// For |x| < 2^22, in the default rounding mode; larger floats lose their last bits.
inline Float roundEven(Float x) {
  constexpr float kWhole = 12582912.0f; // 1.5 2^23
  return (x + kWhole) - kWhole;
}
inline Float sqrt(Float x) {
  return eachLane([&](int k) { return std::sqrt(lane(x, k)); });
}
inline Float inversesqrt(Float x) { return 1.0f / sqrt(x); }
/// f of each number; called once where all are alike, as in one footprint.
template <class F>
Float byLane(F f, Float x) {
  const float first = lane(x, 0);
  if (kLanes == 1 || all(x == Float(first)))
    return f(first);
  return eachLane([&](int k) { return f(lane(x, k)); });
}
inline Float exp2(Float x) {
  return byLane([](float number) { return std::exp2(number); }, x);
}
inline Float log2(Float x) {
  return byLane([](float number) { return std::log2(number); }, x);
}
inline Float pow(Float x, Float y) {
  return eachLane([&](int k) { return std::pow(lane(x, k), lane(y, k)); });
}
inline Float mix(Float a, Float b, Float t) { return a + t * (b - a); }

} // namespace
} // namespace lichen::glsl

#include "glsl_vectors.h"

namespace lichen::glsl {
namespace {

using vec2 = Vec<Float, 2>;
using vec3 = Vec<Float, 3>;
using vec4 = Vec<Float, 4>;
using ivec2 = Vec<Int, 2>;
using ivec3 = Vec<Int, 3>;
using ivec4 = Vec<Int, 4>;
using uvec2 = Vec<uint, 2>;
using uvec3 = Vec<uint, 3>;
using uvec4 = Vec<uint, 4>;
using bvec2 = Vec<Truth, 2>;

/// C columns of R rows.
template <int C, int R>
struct Mat {
  Vec<Float, R> columns[std::size_t(C)];
  Mat() = default;
  explicit Mat(Float diagonal) {
    for (int k = 0; k < C; ++k)
      columns[k] = Vec<Float, R>::each([&](int row) { return row == k ? diagonal : Float(0.0f); });
  }
  template <class... V>
  requires(sizeof...(V) == C && C > 1) Mat(const V&... v) : columns{Vec<Float, R>(v)...} {}
  Vec<Float, R>& operator[](int k) { return columns[k]; }
  const Vec<Float, R>& operator[](int k) const { return columns[k]; }
  friend Vec<Float, R> operator*(const Mat& m, const Vec<Float, C>& v) {
    Vec<Float, R> sum = m[0] * v[0];
    for (int k = 1; k < C; ++k)
      sum += m[k] * v[k];
    return sum;
  }
  friend Vec<Float, C> operator*(const Vec<Float, R>& v, const Mat& m) {
    return Vec<Float, C>::each([&](int k) { return dot(v, m[k]); });
  }
  friend Mat operator*(const Mat& a, const Mat<C, C>& b) {
    Mat r;
    for (int k = 0; k < C; ++k)
      r[k] = a * b[k];
    return r;
  }
  friend Mat& operator*=(Mat& m, Float s) {
    for (Vec<Float, R>& column : m.columns)
      column *= s;
    return m;
  }
};
using mat2 = Mat<2, 2>;
using mat3 = Mat<3, 3>;
using mat3x2 = Mat<3, 2>;
inline Float determinant(const mat2& m) { return m[0].x * m[1].y - m[1].x * m[0].y; }
inline mat2 inverse(const mat2& m) {
  const Float d = 1.0f / determinant(m);
  return mat2(vec2(m[1].y, -m[0].y) * d, vec2(-m[1].x, m[0].x) * d);
}
inline mat3 inverse(const mat3& m) {
  const vec3 a = cross(m[1], m[2]), b = cross(m[2], m[0]), c = cross(m[0], m[1]);
  const Float d = 1.0f / dot(m[0], a);
  return mat3(vec3(a.x, b.x, c.x) * d, vec3(a.y, b.y, c.y) * d, vec3(a.z, b.z, c.z) * d);
}

/// The texels that fetch(k) gives at point k. Points that took another's branch may be anywhere.
template <class Fetch>
vec4 gathered(Fetch fetch) {
  if (haveDiverged())
    return vec4(0.0f);
  std::array<StoredTexel, std::size_t(kLanes)> texels;
  for (int k = 0; k < kLanes; ++k)
    texels[std::size_t(k)] = std::bit_cast<StoredTexel>(Texel(fetch(k)));
  const std::array<Float, 4> channels = transposed(texels);
  return {channels[0], channels[1], channels[2], channels[3]};
}
inline vec4 sampled(const RepeatingImage& image, const vec2& uv, Float level) {
  return gathered([&](int k) { return image.at(lane(uv.x, k), lane(uv.y, k), lane(level, k)); });
}
inline vec4 sampled(const ClampedVolume& table, const vec3& uvw, Float level) {
  return gathered([&](int k) {
    return table.at({lane(uvw.x, k), lane(uvw.y, k), lane(uvw.z, k)}, lane(level, k));
  });
}
inline vec4 fetched(const RepeatingImage& image, const ivec2& texel) {
  return gathered([&](int k) { return image.texel(lane(texel.x, k), lane(texel.y, k)); });
}

} // namespace
} // namespace lichen::glsl
