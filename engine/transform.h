#pragma once

#include "engine/mat2.h"
#include "engine/pose.h"

namespace proofreel {

/// An affine map of the plane, p -> linear * p + translation: a 2x3 matrix (thesis chapter 2.2). Unlike a Pose it may
/// scale and shear. Built from rotation and scale its columns are scale.x * (c, s) and scale.y * (-s, c); the scales
/// belong in all four entries, which equations (2.27) to (2.29) of the thesis leave out off the diagonal.
template <typename T>
struct BasicTransform {
  BasicMat2<T> linear;
  BasicVec2<T> translation;

  friend constexpr BasicVec2<T> operator*(const BasicTransform& t, BasicVec2<T> p) {
    return t.linear * p + t.translation;
  }
  /// First `b`, then `a`.
  friend constexpr BasicTransform operator*(const BasicTransform& a, const BasicTransform& b) {
    return {a.linear * b.linear, a * b.translation};
  }
};

/// Scale first, then turn, then move.
template <typename T>
constexpr BasicTransform<T> make_transform(BasicVec2<T> translation, BasicRot<T> rotation, BasicVec2<T> scale) {
  return {{{rotation.c * scale.x, rotation.s * scale.x}, {-rotation.s * scale.y, rotation.c * scale.y}}, translation};
}

template <typename T>
constexpr BasicTransform<T> make_transform(const BasicPose<T>& pose) {
  return make_transform(pose.position, pose.rotation, BasicVec2<T>{T(1), T(1)});
}

using Transformd = BasicTransform<double>;

}  // namespace proofreel
