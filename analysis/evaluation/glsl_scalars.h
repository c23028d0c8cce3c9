// SPDX-License-Identifier: MIT
// The scalars of GLSL. With LICHEN_WIDE defined, each holds the numbers of four points, in vectors
// of the processor's baseline (SSE2, NEON); points must then take the same branches, and
// haveDiverged() tells.
#pragma once

#include "sampling/texels.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace lichen::glsl {
namespace { // each kind of scalars is a file's own

#ifdef LICHEN_WIDE
inline constexpr int kLanes = 4; // points
using FloatLanes [[gnu::vector_size(16)]] = float;
using IntLanes [[gnu::vector_size(16)]] = std::int32_t;
using UintLanes [[gnu::vector_size(16)]] = std::uint32_t;
using Halves [[gnu::vector_size(16)]] = std::uint64_t;
template <class T>
using LanesOf =
    std::conditional_t<std::is_same_v<T, float>, FloatLanes,
                       std::conditional_t<std::is_same_v<T, std::int32_t>, IntLanes, UintLanes>>;

/// Set where points should have taken different branches: all took the first's.
thread_local bool tookOneBranch = false;
inline bool haveDiverged() { return tookOneBranch; }

struct Truth {
  IntLanes v; ///< 0 or -1
  Truth() = default;
  Truth(IntLanes lanes) : v(lanes) {}
  Truth(bool everywhere) : v(IntLanes{} - int(everywhere)) {}
  /// In a branch.
  operator bool() const {
    const auto halves = Halves(v);
    if (halves[0] != halves[1] || halves[0] + 1 > 1)
      tookOneBranch = true;
    return v[0] != 0;
  }
};
inline bool all(Truth x) {
  const auto halves = Halves(x.v);
  return (halves[0] & halves[1]) == ~std::uint64_t(0);
}
#else
inline constexpr int kLanes = 1;
template <class T>
using LanesOf = T;
using Truth = bool;
inline bool haveDiverged() { return false; }
inline bool all(bool x) { return x; }
#endif

/// Numbers whose arithmetic with literals such as 0.5 stays in single precision.
template <class T>
struct Number {
  using Lanes = LanesOf<T>;
  Lanes v;
  Number() = default;
  template <class S>
  requires std::is_arithmetic_v<S>
  constexpr Number(S number) : v(T(number) - Lanes{}) {}
#ifdef LICHEN_WIDE
  Number(Lanes lanes) : v(lanes) {}
  template <class S>
  explicit(std::is_same_v<T, float> || std::is_same_v<S, float>) Number(Number<S> other)
      : v(__builtin_convertvector(other.v, Lanes)) {}
  explicit Number(Truth truth) : v(__builtin_convertvector(-truth.v, Lanes)) {}
#else
  template <class S>
  requires std::is_arithmetic_v<S>
  explicit constexpr operator S() const { return S(v); }
#endif
  constexpr Number operator-() const { return -v; }
  Number& operator++() { return v += 1, *this; }
#define LICHEN_NUMBER_OPERATOR(op)                                                                 \
  friend constexpr Number operator op(Number a, Number b) { return a.v op b.v; }                   \
  constexpr Number& operator op##=(Number b) { return v = v op b.v, *this; }
  LICHEN_NUMBER_OPERATOR(+)
  LICHEN_NUMBER_OPERATOR(-)
  LICHEN_NUMBER_OPERATOR(*)
  LICHEN_NUMBER_OPERATOR(/)
  LICHEN_NUMBER_OPERATOR(%)
  LICHEN_NUMBER_OPERATOR(&)
  LICHEN_NUMBER_OPERATOR(|)
  LICHEN_NUMBER_OPERATOR(^)
  LICHEN_NUMBER_OPERATOR(<<)
  LICHEN_NUMBER_OPERATOR(>>)
#undef LICHEN_NUMBER_OPERATOR
#define LICHEN_NUMBER_COMPARISON(op)                                                               \
  friend constexpr Truth operator op(Number a, Number b) { return a.v op b.v; }
  LICHEN_NUMBER_COMPARISON(==)
  LICHEN_NUMBER_COMPARISON(!=)
  LICHEN_NUMBER_COMPARISON(<)
  LICHEN_NUMBER_COMPARISON(>)
  LICHEN_NUMBER_COMPARISON(<=)
  LICHEN_NUMBER_COMPARISON(>=)
#undef LICHEN_NUMBER_COMPARISON
};
using Float = Number<float>;

#ifdef LICHEN_WIDE
using Int = Number<std::int32_t>;
using uint = Number<std::uint32_t>;
template <class T>
T lane(Number<T> x, int k) {
  return x.v[k];
}
/// The number that is f(k) at point k.
template <class F>
Float eachLane(F f) {
  return FloatLanes{f(0), f(1), f(2), f(3)};
}
using StoredTexel = FloatLanes;
/// The points' texels -> channels.
inline std::array<Float, 4> transposed(const std::array<FloatLanes, 4>& t) {
  const FloatLanes xy0 = __builtin_shufflevector(t[0], t[1], 0, 4, 1, 5);
  const FloatLanes xy1 = __builtin_shufflevector(t[2], t[3], 0, 4, 1, 5);
  const FloatLanes zw0 = __builtin_shufflevector(t[0], t[1], 2, 6, 3, 7);
  const FloatLanes zw1 = __builtin_shufflevector(t[2], t[3], 2, 6, 3, 7);
  return {
      __builtin_shufflevector(xy0, xy1, 0, 1, 4, 5), __builtin_shufflevector(xy0, xy1, 2, 3, 6, 7),
      __builtin_shufflevector(zw0, zw1, 0, 1, 4, 5), __builtin_shufflevector(zw0, zw1, 2, 3, 6, 7)};
}
template <class T>
Number<T> chosen(Truth isFirst, Number<T> first, Number<T> second) {
  return isFirst.v ? first.v : second.v;
}
inline Float abs(Float x) { return FloatLanes(IntLanes(x.v) & 0x7FFFFFFF); }
#else
using Int = int;
using uint = std::uint32_t;
inline float lane(Float x, int) { return x.v; }
inline int lane(int x, int) { return x; }
template <class F>
Float eachLane(F f) {
  return f(0);
}
using StoredTexel = Texel;
inline std::array<Float, 4> transposed(const std::array<Texel, 1>& t) {
  return {t[0][0], t[0][1], t[0][2], t[0][3]};
}
template <class T>
T chosen(bool isFirst, T first, T second) {
  return isFirst ? first : second;
}
inline Float abs(Float x) { return std::fabs(x.v); }
#endif

/// The type in which T wraps around without undefined behaviour.
template <class T>
using Wrapping = std::conditional_t<std::is_same_v<T, Int>, uint, T>;

} // namespace
} // namespace lichen::glsl
