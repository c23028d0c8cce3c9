// SPDX-License-Identifier: MIT
// GLSL in C++: the scalars, vectors, matrices and built-in functions that the shader library uses,
// so that shaders_glsl/ compiles as C++ and computes what a device computes, up to rounding.
// Literals without f, constructors and conversions are as in GLSL. Swizzles are functions that
// return copies; shader_library.h makes names of them. [GLSL] The OpenGL Shading Language 4.60,
// chapters 5 and 8.
#pragma once

#include "sampling/texels.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace lichen::glsl {

using uint = std::uint32_t;

/// A float whose arithmetic with literals such as 0.5 stays in single precision.
struct Float {
  float v;
  Float() = default;
  template <class T>
  requires std::is_arithmetic_v<T>
  constexpr Float(T number) : v(float(number)) {}
  template <class T>
  requires std::is_arithmetic_v<T>
  explicit constexpr operator T() const { return T(v); }
  constexpr Float operator-() const { return -v; }
  constexpr Float& operator+=(Float b) { return v += b.v, *this; }
  constexpr Float& operator-=(Float b) { return v -= b.v, *this; }
  constexpr Float& operator*=(Float b) { return v *= b.v, *this; }
  constexpr Float& operator/=(Float b) { return v /= b.v, *this; }
  friend constexpr Float operator+(Float a, Float b) { return a.v + b.v; }
  friend constexpr Float operator-(Float a, Float b) { return a.v - b.v; }
  friend constexpr Float operator*(Float a, Float b) { return a.v * b.v; }
  friend constexpr Float operator/(Float a, Float b) { return a.v / b.v; }
  friend constexpr bool operator==(Float a, Float b) { return a.v == b.v; }
  friend constexpr bool operator<(Float a, Float b) { return a.v < b.v; }
  friend constexpr bool operator>(Float a, Float b) { return a.v > b.v; }
  friend constexpr bool operator<=(Float a, Float b) { return a.v <= b.v; }
  friend constexpr bool operator>=(Float a, Float b) { return a.v >= b.v; }
};

inline Float abs(Float x) { return std::fabs(x.v); }
/// By conversion: without SSE 4.1 std::floor is a call. Floats from 2^23 on are whole.
inline Float floor(Float x) {
  constexpr float kWhole = 8388608.0f;
  if (!(std::fabs(x.v) < kWhole))
    return x;
  const auto whole = float(int(x.v));
  return whole > x.v ? whole - 1.0f : whole;
}
inline Float ceil(Float x) { return -floor(-x); }
inline Float fract(Float x) { return x - floor(x); }
/// For |x| < 2^22, in the default rounding mode; larger floats lose their last bits.
inline Float roundEven(Float x) {
  constexpr float kWhole = 12582912.0f; // 1.5 2^23
  return (x.v + kWhole) - kWhole;
}
inline Float sqrt(Float x) { return std::sqrt(x.v); }
inline Float inversesqrt(Float x) { return 1.0f / std::sqrt(x.v); }
inline Float exp2(Float x) { return std::exp2(x.v); }
inline Float log2(Float x) { return std::log2(x.v); }
inline Float pow(Float x, Float y) { return std::pow(x.v, y.v); }
inline Float min(Float a, Float b) { return b.v < a.v ? b.v : a.v; }
inline Float max(Float a, Float b) { return a.v < b.v ? b.v : a.v; }
inline Float step(Float edge, Float x) { return x.v < edge.v ? 0.0f : 1.0f; }
inline Float clamp(Float x, Float low, Float high) { return min(max(x, low), high); }
inline Float mix(Float a, Float b, Float t) { return a + t * (b - a); }
inline uint floatBitsToUint(Float x) { return std::bit_cast<uint>(x.v); }
inline Float uintBitsToFloat(uint x) { return std::bit_cast<float>(x); }

inline int abs(int x) { return x < 0 ? -x : x; }
inline int min(int a, int b) { return b < a ? b : a; }
inline int max(int a, int b) { return a < b ? b : a; }
inline int clamp(int x, int low, int high) { return min(max(x, low), high); }
inline uint min(uint a, uint b) { return b < a ? b : a; }
inline uint max(uint a, uint b) { return a < b ? b : a; }
inline bool all(bool x) { return x; }
template <class T>
T chosen(bool isFirst, T first, T second) {
  return isFirst ? first : second;
}

} // namespace lichen::glsl

#include "glsl_vectors.h"

namespace lichen::glsl {

using vec2 = Vec<Float, 2>;
using vec3 = Vec<Float, 3>;
using vec4 = Vec<Float, 4>;
using ivec2 = Vec<int, 2>;
using ivec3 = Vec<int, 3>;
using ivec4 = Vec<int, 4>;
using uvec2 = Vec<uint, 2>;
using uvec3 = Vec<uint, 3>;
using uvec4 = Vec<uint, 4>;
using bvec2 = Vec<bool, 2>;

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
  /// From two halves of each column.
  template <class... V>
  requires(sizeof...(V) == 2 * C && R == 4) Mat(const V&... v) {
    const vec2 halves[] = {v...};
    const vec2* half = halves;
    for (Vec<Float, R>& column : columns) {
      column = vec4(half[0], half[1]);
      half += 2;
    }
  }
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
using mat4 = Mat<4, 4>;
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

inline vec4 asVec(const Texel& texel) { return {texel[0], texel[1], texel[2], texel[3]}; }
inline vec4 sampled(const RepeatingImage& image, const vec2& uv, Float level) {
  return asVec(image.at(uv.x.v, uv.y.v, level.v));
}
inline vec4 sampled(const ClampedVolume& table, const vec3& uvw, Float level) {
  return asVec(table.at({uvw.x.v, uvw.y.v, uvw.z.v}, level.v));
}
inline vec4 fetched(const RepeatingImage& image, const ivec2& texel) {
  return asVec(image.texel(texel.x, texel.y));
}

} // namespace lichen::glsl
