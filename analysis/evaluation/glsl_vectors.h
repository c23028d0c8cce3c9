// SPDX-License-Identifier: MIT
// The vectors of GLSL over any scalar. Included by glsl.h after its scalars, whose functions it
// calls.
#pragma once

#include <concepts>
#include <type_traits>

namespace lichen::glsl {
namespace { // as the scalars are

// Members and not an array: GCC keeps arrays that loops index in memory.
template <class T, int N>
struct Components;
template <class T>
struct Components<T, 2> {
  union {
    T x, r;
  };
  union {
    T y, g;
  };
};
template <class T>
struct Components<T, 3> : Components<T, 2> {
  union {
    T z, b;
  };
};
template <class T>
struct Components<T, 4> : Components<T, 3> {
  union {
    T w, a;
  };
};

template <class T, int N>
struct Vec;
/// How many components an argument of a constructor has.
template <class A>
inline constexpr int kSize = 1;
template <class T, int N>
inline constexpr int kSize<Vec<T, N>> = N;

template <class T, int N>
struct Vec : Components<T, N> {
  Vec() = default;
  /// All components alike.
  template <class A>
  requires(kSize<A> == 1) explicit constexpr Vec(A scalar)
      : Vec(each([&](int) { return T(scalar); })) {}
  /// From another type, or from the first components of a longer vector.
  template <class S, int M>
  requires(M >= N && !std::is_same_v<Vec<S, M>, Vec>) explicit constexpr Vec(const Vec<S, M>& v)
      : Vec(each([&](int k) { return T(v[k]); })) {}
  /// From scalars and vectors that have N components together.
  template <class A, class B, class... Rest>
  requires(kSize<A> + kSize<B> + (0 + ... + kSize<Rest>) ==
           N) constexpr Vec(const A& first, const B& second, const Rest&... rest) {
    put<0>(first, second, rest...);
  }

  constexpr T& operator[](int k) {
    if constexpr (N > 3)
      if (k == 3)
        return this->w;
    if constexpr (N > 2)
      if (k == 2)
        return this->z;
    return k == 0 ? this->x : this->y;
  }
  constexpr const T& operator[](int k) const { return const_cast<Vec&>(*this)[k]; }

  /// The vector whose component k is f(k).
  template <class F>
  static constexpr Vec each(F f) {
    Vec r;
    r.x = f(0);
    r.y = f(1);
    if constexpr (N > 2)
      r.z = f(2);
    if constexpr (N > 3)
      r.w = f(3);
    return r;
  }
  template <int... I>
  constexpr auto swizzled() const {
    return Vec<T, int(sizeof...(I))>((*this)[I]...);
  }
  constexpr auto xy() const { return swizzled<0, 1>(); }
  constexpr auto yx() const { return swizzled<1, 0>(); }
  constexpr auto xz() const { return swizzled<0, 2>(); }
  constexpr auto yw() const { return swizzled<1, 3>(); }
  constexpr auto zw() const { return swizzled<2, 3>(); }
  constexpr auto xyz() const { return swizzled<0, 1, 2>(); }
  constexpr auto yzz() const { return swizzled<1, 2, 2>(); }
  constexpr auto rg() const { return swizzled<0, 1>(); }
  constexpr auto rgb() const { return swizzled<0, 1, 2>(); }

#define LICHEN_VECTOR_OPERATOR(op, Operand)                                                        \
  friend constexpr Vec operator op(const Vec& u, const Vec& v) {                                   \
    return each([&](int k) { return T(Operand(u[k]) op Operand(v[k])); });                         \
  }                                                                                                \
  friend constexpr Vec operator op(const Vec& u, T v) { return u op Vec(v); }                      \
  friend constexpr Vec operator op(T u, const Vec& v) { return Vec(u) op v; }                      \
  friend constexpr Vec& operator op##=(Vec& u, const Vec& v) { return u = u op v; }                \
  friend constexpr Vec& operator op##=(Vec& u, T v) { return u = u op v; }
  LICHEN_VECTOR_OPERATOR(+, Wrapping<T>)
  LICHEN_VECTOR_OPERATOR(-, Wrapping<T>)
  LICHEN_VECTOR_OPERATOR(*, Wrapping<T>)
  LICHEN_VECTOR_OPERATOR(/, T)
  LICHEN_VECTOR_OPERATOR(%, T)
  LICHEN_VECTOR_OPERATOR(&, T)
  LICHEN_VECTOR_OPERATOR(|, T)
  LICHEN_VECTOR_OPERATOR(^, T)
  LICHEN_VECTOR_OPERATOR(<<, T)
  LICHEN_VECTOR_OPERATOR(>>, T)
#undef LICHEN_VECTOR_OPERATOR
  constexpr Vec operator-() const {
    return each([&](int k) { return -(*this)[k]; });
  }
  friend constexpr bool operator==(const Vec& u, const Vec& v) {
    bool same = all(u.x == v.x) && all(u.y == v.y);
    if constexpr (N > 2)
      same = same && all(u.z == v.z);
    if constexpr (N > 3)
      same = same && all(u.w == v.w);
    return same;
  }

#define LICHEN_COMPONENTWISE_1(f)                                                                  \
  friend Vec f(const Vec& u) {                                                                     \
    return each([&](int k) { return glsl::f(u[k]); });                                             \
  }
  LICHEN_COMPONENTWISE_1(abs)
  LICHEN_COMPONENTWISE_1(floor)
  LICHEN_COMPONENTWISE_1(ceil)
  LICHEN_COMPONENTWISE_1(fract)
  LICHEN_COMPONENTWISE_1(roundEven)
  LICHEN_COMPONENTWISE_1(sqrt)
  LICHEN_COMPONENTWISE_1(inversesqrt)
  LICHEN_COMPONENTWISE_1(exp2)
#undef LICHEN_COMPONENTWISE_1
#define LICHEN_COMPONENTWISE_2(f)                                                                  \
  friend Vec f(const Vec& u, const Vec& v) {                                                       \
    return each([&](int k) { return glsl::f(u[k], v[k]); });                                       \
  }                                                                                                \
  friend Vec f(const Vec& u, T v) { return f(u, Vec(v)); }
  LICHEN_COMPONENTWISE_2(min)
  LICHEN_COMPONENTWISE_2(max)
  LICHEN_COMPONENTWISE_2(pow)
#undef LICHEN_COMPONENTWISE_2
  friend Vec clamp(const Vec& u, const Vec& low, const Vec& high) { return min(max(u, low), high); }
  friend Vec clamp(const Vec& u, T low, T high) { return clamp(u, Vec(low), Vec(high)); }
  friend Vec mix(const Vec& u, const Vec& v, const Vec& t) { return u + t * (v - u); }
  friend Vec mix(const Vec& u, const Vec& v, T t) { return mix(u, v, Vec(t)); }
  friend constexpr T dot(const Vec& u, const Vec& v) {
    T sum = u.x * v.x + u.y * v.y;
    if constexpr (N > 2)
      sum += u.z * v.z;
    if constexpr (N > 3)
      sum += u.w * v.w;
    return sum;
  }
  friend T length(const Vec& u) { return sqrt(dot(u, u)); }
  friend Vec normalize(const Vec& u) { return u * inversesqrt(dot(u, u)); }

private:
  template <int K, class A, class... Rest>
  constexpr void put(const A& first, const Rest&... rest) {
    if constexpr (kSize<A> == 1) {
      (*this)[K] = T(first);
    } else {
      (*this)[K] = T(first.x);
      (*this)[K + 1] = T(first.y);
      if constexpr (kSize < A >> 2)
        (*this)[K + 2] = T(first.z);
    }
    if constexpr (sizeof...(Rest) > 0)
      put<K + kSize<A>>(rest...);
  }
};

template <class T>
Vec<T, 3> cross(const Vec<T, 3>& a, const Vec<T, 3>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T, int N>
auto floatBitsToUint(const Vec<T, N>& v) {
  return Vec<decltype(floatBitsToUint(v.x)), N>::each([&](int k) { return floatBitsToUint(v[k]); });
}
template <class T, int N>
auto uintBitsToFloat(const Vec<T, N>& v) {
  return Vec<decltype(uintBitsToFloat(v.x)), N>::each([&](int k) { return uintBitsToFloat(v[k]); });
}
template <class T, int N>
auto lessThan(const Vec<T, N>& a, const Vec<T, N>& b) {
  return Vec<decltype(a.x < b.x), N>::each([&](int k) { return a[k] < b[k]; });
}
template <class T, int N>
auto equal(const Vec<T, N>& a, const Vec<T, N>& b) {
  return Vec<decltype(a.x == b.x), N>::each([&](int k) { return a[k] == b[k]; });
}
template <int N>
bool all(const Vec<Truth, N>& v) {
  return v == Vec<Truth, N>(true);
}
/// Exact, unlike the mix by a number.
template <class T, int N, class Truth>
Vec<T, N> mix(const Vec<T, N>& a, const Vec<T, N>& b,
              const Vec<Truth, N>& isB) requires(!std::is_same_v<T, Truth>) {
  return Vec<T, N>::each([&](int k) { return chosen(isB[k], b[k], a[k]); });
}

} // namespace
} // namespace lichen::glsl
