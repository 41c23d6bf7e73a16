#pragma once

/// Narrow phase (thesis chapters 4.2 and 4.3): where and how do two shapes touch?
///
/// Two convex polygons are apart exactly when the normal of one of their edges separates them (the separating axis
/// theorem). So every normal is tried: the other polygon's nearest corner along it says how far the two are apart on
/// that axis. If one axis parts them by more than the margin, that is the end of it. Otherwise the axis of largest
/// separation, which on overlap is the one of least penetration, carries the manifold, and clipping (clip.h) finds the
/// points. Discs and rounded shapes are the same with a radius around them, where corners count as well as faces.

#include "engine/clip.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// The manifold of two shapes, its normal in world axes and its points relative to A's centre of mass. The poses are
/// those of the centres of mass. Points farther apart than `margin` are left out; the corners of both shapes are
/// metres, and so are margin and separation. All is computed in A's frame, so that nothing is lost far from the origin.
/// Of two faces that are almost equally good (to 1e-4 of the thinner shape's thickness) A's is taken, so that a resting
/// contact keeps its features; the depth may be off by as much. Where a corner is so straight that rounding decides
/// which of its faces is taken, that does not show: a manifold that is not proven to be the nearest is left to
/// collide_gjk.
///
/// Tells the observer, in A's frame, of every axis (AxisTested, separations with the radii taken off), of the one
/// chosen (AxisChosen), of the faces (FacesChosen) and of the points (PointClipped).
template <typename Observer = NoObserver>
Manifold collide(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b, real margin,
                 Observer observer = {});

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
