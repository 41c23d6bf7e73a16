#pragma once

#include "engine/elementary.h"
#include "engine/vec2.h"

namespace proofreel {

/// A rotation as a unit complex number c + i s: no angle wraps, composing two costs four multiplications, and only
/// making one from an angle needs trigonometry (our own, so that the bits are the same everywhere).
template <typename T>
struct BasicRot {
  T c{1};  ///< cosine of the angle
  T s{0};  ///< sine of the angle

  constexpr BasicRot() = default;
  constexpr BasicRot(T cosine, T sine) : c(cosine), s(sine) {}
  /// The rotation by `angle` radians, counter-clockwise.
  explicit BasicRot(T angle)
      : c(static_cast<T>(elementary::cos(static_cast<double>(angle)))),
        s(static_cast<T>(elementary::sin(static_cast<double>(angle)))) {}
  template <typename U>
  constexpr explicit BasicRot(const BasicRot<U>& other) : c(static_cast<T>(other.c)), s(static_cast<T>(other.s)) {}

  /// First `b`, then `a`.
  friend constexpr BasicRot operator*(BasicRot a, BasicRot b) { return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s}; }
  friend constexpr bool operator==(BasicRot a, BasicRot b) { return a.c == b.c && a.s == b.s; }
};

template <typename T>
constexpr BasicRot<T> inverse(BasicRot<T> q) {
  return {q.c, -q.s};
}

template <typename T>
constexpr BasicVec2<T> rotate(BasicRot<T> q, BasicVec2<T> v) {
  return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y};
}

template <typename T>
constexpr BasicVec2<T> inverse_rotate(BasicRot<T> q, BasicVec2<T> v) {
  return {q.c * v.x + q.s * v.y, q.c * v.y - q.s * v.x};
}

/// Brings the length back to one after rounding; the length must not be zero.
template <typename T>
BasicRot<T> normalized(BasicRot<T> q) {
  const T l = std::sqrt(q.c * q.c + q.s * q.s);
  return {q.c / l, q.s / l};
}

using Rotd = BasicRot<double>;

}  // namespace proofreel
