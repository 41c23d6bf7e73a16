#pragma once

/// Plane vectors (thesis chapter 2.1). Every geometric type exists as a template over its number type: the engine
/// uses the alias without suffix in its own precision (`Vec2`), the outside world the one in double (`Vec2d`).

#include <cmath>

namespace proofreel {

/// A point or direction in the plane, metres unless said otherwise. Default: the zero vector.
template <typename T>
struct BasicVec2 {
  T x{};
  T y{};

  constexpr BasicVec2() = default;
  constexpr BasicVec2(T x_value, T y_value) : x(x_value), y(y_value) {}
  /// Conversion between precisions is spelled out, because it may round.
  template <typename U>
  constexpr explicit BasicVec2(const BasicVec2<U>& other) : x(static_cast<T>(other.x)), y(static_cast<T>(other.y)) {}

  constexpr BasicVec2& operator+=(BasicVec2 b) { return *this = {x + b.x, y + b.y}; }
  constexpr BasicVec2& operator-=(BasicVec2 b) { return *this = {x - b.x, y - b.y}; }
  constexpr BasicVec2& operator*=(T s) { return *this = {x * s, y * s}; }

  friend constexpr BasicVec2 operator+(BasicVec2 a, BasicVec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr BasicVec2 operator-(BasicVec2 a, BasicVec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr BasicVec2 operator-(BasicVec2 a) { return {-a.x, -a.y}; }
  friend constexpr BasicVec2 operator*(T s, BasicVec2 a) { return {s * a.x, s * a.y}; }
  friend constexpr BasicVec2 operator*(BasicVec2 a, T s) { return {s * a.x, s * a.y}; }
  friend constexpr bool operator==(BasicVec2 a, BasicVec2 b) { return a.x == b.x && a.y == b.y; }
};

template <typename T>
constexpr T dot(BasicVec2<T> a, BasicVec2<T> b) {
  return a.x * b.x + a.y * b.y;
}

/// The z component of the three-dimensional cross product: twice the signed area of the triangle (0, a, b),
/// positive when b lies counter-clockwise of a.
template <typename T>
constexpr T cross(BasicVec2<T> a, BasicVec2<T> b) {
  return a.x * b.y - a.y * b.x;
}

/// Cross product of an angular velocity (along z, rad/s) with a lever arm: the velocity it gives to the arm's end.
template <typename T>
constexpr BasicVec2<T> cross(T s, BasicVec2<T> a) {
  return {-s * a.y, s * a.x};
}

/// `a` turned by a quarter turn counter-clockwise.
template <typename T>
constexpr BasicVec2<T> perp(BasicVec2<T> a) {
  return {-a.y, a.x};
}

template <typename T>
constexpr T length_squared(BasicVec2<T> a) {
  return dot(a, a);
}

template <typename T>
T length(BasicVec2<T> a) {
  return std::sqrt(dot(a, a));
}

template <typename T>
T distance(BasicVec2<T> a, BasicVec2<T> b) {
  return length(b - a);
}

/// `a` scaled to unit length; the zero vector stays zero.
template <typename T>
BasicVec2<T> normalized(BasicVec2<T> a) {
  const T l = length(a);
  return l > T(0) ? BasicVec2<T>{a.x / l, a.y / l} : BasicVec2<T>{};
}

/// The point `t` of the way from `a` to `b`.
template <typename T>
constexpr BasicVec2<T> lerp(BasicVec2<T> a, BasicVec2<T> b, T t) {
  return a + t * (b - a);
}

template <typename T>
bool is_finite(BasicVec2<T> a) {
  return std::isfinite(a.x) && std::isfinite(a.y);
}

using Vec2d = BasicVec2<double>;

}  // namespace proofreel
