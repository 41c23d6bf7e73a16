#pragma once

#include "engine/vec2.h"

namespace proofreel {

/// A 2x2 matrix held by columns, as the thesis has it (chapter 2.3): `ex` is where the x axis goes, `ey` the y axis.
template <typename T>
struct BasicMat2 {
  BasicVec2<T> ex{T(1), T(0)};
  BasicVec2<T> ey{T(0), T(1)};

  friend constexpr BasicVec2<T> operator*(const BasicMat2& m, BasicVec2<T> v) { return v.x * m.ex + v.y * m.ey; }
  friend constexpr BasicMat2 operator*(const BasicMat2& a, const BasicMat2& b) { return {a * b.ex, a * b.ey}; }
  friend constexpr BasicMat2 operator+(const BasicMat2& a, const BasicMat2& b) { return {a.ex + b.ex, a.ey + b.ey}; }
};

template <typename T>
constexpr T determinant(const BasicMat2<T>& m) {
  return cross(m.ex, m.ey);
}

/// Solves m x = b by Cramer's rule; a singular matrix gives the zero vector.
template <typename T>
constexpr BasicVec2<T> solve(const BasicMat2<T>& m, BasicVec2<T> b) {
  const T d = determinant(m);
  if (d == T(0)) return {};
  return {cross(b, m.ey) / d, cross(m.ex, b) / d};
}

using Mat2d = BasicMat2<double>;

}  // namespace proofreel
