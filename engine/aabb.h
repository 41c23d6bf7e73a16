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

/// All four comparisons are made, joined without a branch: in a tree the outcome of each is hardly foreseeable, and a
/// wrong guess of the processor costs more than all of them.
template <typename T>
constexpr bool overlaps(const BasicAabb<T>& a, const BasicAabb<T>& b) {
  return (a.lower.x <= b.upper.x) & (b.lower.x <= a.upper.x) & (a.lower.y <= b.upper.y) & (b.lower.y <= a.upper.y);
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

/// From `p` to the nearest point of the box; 0 inside. Grows, rounding included, when the box shrinks.
template <typename T>
T distance(const BasicAabb<T>& a, BasicVec2<T> p) {
  return length(BasicVec2<T>{std::max({a.lower.x - p.x, p.x - a.upper.x, T(0)}),
                             std::max({a.lower.y - p.y, p.y - a.upper.y, T(0)})});
}

/// The points origin + t * translation, ready to be tested against many boxes.
template <typename T>
class BasicRay {
 public:
  BasicRay(BasicVec2<T> origin, BasicVec2<T> translation)
      : origin_(origin), inverse_{inverse(translation.x), inverse(translation.y)} {}

  /// The least t in 0 .. max_fraction (finite) for which the point lies in the box, 0 when the origin does; infinity
  /// when there is none. Up to four roundings early, so that a ray along an edge meets the box. Where it meets a box it
  /// meets every box around that, and no later.
  T entry_into(const BasicAabb<T>& box, T max_fraction) const {
    T entry = 0;
    T exit = max_fraction;
    const bool hit = clip(origin_.x, inverse_.x, box.lower.x, box.upper.x, entry, exit) &&
                     clip(origin_.y, inverse_.y, box.lower.y, box.upper.y, entry, exit);
    return hit && entry <= exit ? entry : std::numeric_limits<T>::infinity();
  }

 private:
  /// 0 stands for a direction in which nothing moves.
  static T inverse(T way) { return std::abs(way) >= std::numeric_limits<T>::min() ? T(1) / way : T(0); }

  /// Cuts the part between two parallel lines out of entry .. exit (the slab method, Kay and Kajiya 1986).
  static bool clip(T origin, T inverse_way, T lower, T upper, T& entry, T& exit) {
    if (inverse_way == T(0)) return lower <= origin && origin <= upper;
    const T at_lower = (lower - origin) * inverse_way;
    const T at_upper = (upper - origin) * inverse_way;
    const T early = T(1) - T(4) * std::numeric_limits<T>::epsilon();
    entry = std::max(entry, early * std::min(at_lower, at_upper));
    exit = std::min(exit, std::max(at_lower, at_upper));
    return true;
  }

  BasicVec2<T> origin_;
  BasicVec2<T> inverse_;
};

using Aabbd = BasicAabb<double>;

}  // namespace proofreel
