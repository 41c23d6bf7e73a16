#pragma once

#include <algorithm>
#include <limits>

#include "engine/vec2.h"

namespace proofreel {

/// An axis-aligned bounding box, closed: touching boxes overlap. A default one is empty and grows by `merged`.
template <typename T>
struct BasicAabb {
  BasicVec2<T> lower{std::numeric_limits<T>::max(), std::numeric_limits<T>::max()};
  BasicVec2<T> upper{std::numeric_limits<T>::lowest(), std::numeric_limits<T>::lowest()};

  BasicAabb() = default;
  constexpr BasicAabb(BasicVec2<T> low, BasicVec2<T> high) : lower(low), upper(high) {}
  template <typename U>
  constexpr explicit BasicAabb(const BasicAabb<U>& other) : lower(other.lower), upper(other.upper) {}
};

template <typename T>
constexpr bool overlaps(const BasicAabb<T>& a, const BasicAabb<T>& b) {
  return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y && b.lower.y <= a.upper.y;
}

template <typename T>
constexpr bool contains(const BasicAabb<T>& outer, const BasicAabb<T>& inner) {
  return outer.lower.x <= inner.lower.x && outer.lower.y <= inner.lower.y && inner.upper.x <= outer.upper.x &&
         inner.upper.y <= outer.upper.y;
}

/// The smallest box around both.
template <typename T>
constexpr BasicAabb<T> merged(const BasicAabb<T>& a, const BasicAabb<T>& b) {
  return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y)},
          {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y)}};
}

template <typename T>
constexpr BasicAabb<T> merged(const BasicAabb<T>& a, BasicVec2<T> p) {
  return merged(a, BasicAabb<T>{p, p});
}

/// Grown by `margin` on all sides.
template <typename T>
constexpr BasicAabb<T> expanded(const BasicAabb<T>& a, T margin) {
  return {{a.lower.x - margin, a.lower.y - margin}, {a.upper.x + margin, a.upper.y + margin}};
}

/// Grown on the side `displacement` points to: covers the box at both ends of the way.
template <typename T>
constexpr BasicAabb<T> swept(const BasicAabb<T>& a, BasicVec2<T> displacement) {
  return merged(a, BasicAabb<T>{a.lower + displacement, a.upper + displacement});
}

/// What the surface-area heuristic weighs in the plane: the perimeter, in metres.
template <typename T>
constexpr T perimeter(const BasicAabb<T>& a) {
  return T(2) * ((a.upper.x - a.lower.x) + (a.upper.y - a.lower.y));
}

template <typename T>
constexpr BasicVec2<T> center(const BasicAabb<T>& a) {
  return T(0.5) * (a.lower + a.upper);
}

using Aabbd = BasicAabb<double>;

}  // namespace proofreel
