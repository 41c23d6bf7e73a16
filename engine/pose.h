#pragma once

#include "engine/rot.h"

namespace proofreel {

/// Where a rigid thing is: turned by `rotation`, then moved to `position`. Takes body coordinates to world coordinates.
template <typename T>
struct BasicPose {
  BasicVec2<T> position;
  BasicRot<T> rotation;

  BasicPose() = default;
  constexpr BasicPose(BasicVec2<T> p, BasicRot<T> q) : position(p), rotation(q) {}
  template <typename U>
  constexpr explicit BasicPose(const BasicPose<U>& other) : position(other.position), rotation(other.rotation) {}
};

template <typename T>
constexpr BasicVec2<T> to_world(const BasicPose<T>& pose, BasicVec2<T> local) {
  return pose.position + rotate(pose.rotation, local);
}

template <typename T>
constexpr BasicVec2<T> to_local(const BasicPose<T>& pose, BasicVec2<T> world) {
  return inverse_rotate(pose.rotation, world - pose.position);
}

/// What `pose` is in the frame of `frame`.
template <typename T>
constexpr BasicPose<T> relative_pose(const BasicPose<T>& frame, const BasicPose<T>& pose) {
  return {to_local(frame, pose.position), inverse(frame.rotation) * pose.rotation};
}

using Posed = BasicPose<double>;

}  // namespace proofreel
