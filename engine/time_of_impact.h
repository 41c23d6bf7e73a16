#pragma once

/// When do two moving, turning shapes first come near each other? Conservative advancement (Mirtich 1996): never move
/// on farther than it is proven that nothing can happen. So a body never passes through another, however fast it flies
/// or spins, and there is no answer without a proven bound.
///
/// The proof. Let n be the direction between the nearest points at one moment (GJK), and s(t) the separation of the
/// shapes along it, n held fixed. s(t) never exceeds the true distance. It is the least over all pairs of corners of a
/// straight motion plus two turning arms, whose second derivative is at most K = reach_a turn_a^2 + reach_b turn_b^2.
/// So between two times at which s is known (one look for the farthest corners each), it is nowhere lower than the
/// chord between the two minus K/2 (t - t1)(t2 - t). What approaches along n, turning included, is in the chord
/// exactly; only the bending of the arms is bounded, and that falls with the square of the window, so the windows
/// shrink to the first crossing fast. Without turning the chord itself is the bound.

#include "engine/gjk.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// A motion during one step: straight and even for the centre of mass, even for the angle (any number of turns).
struct Sweep {
  Pose start;
  Vec2 displacement;
  real turn = 0;  ///< radians
};

/// Where the body is after that fraction of its motion.
Pose pose_at(const Sweep& sweep, real fraction);

enum class ImpactState : std::uint8_t {
  separated,          ///< farther apart than the target all the way: fraction 1
  hit,                ///< nearer than target + tolerance for the first time at `fraction`
  touching_at_start,  ///< nearer than that at the start already: fraction 0
  unfinished          ///< not decided with the work allowed (a grazing spin of many turns): safe up to `fraction`
};

struct TimeOfImpact {
  ImpactState state = ImpactState::separated;
  real fraction = 1;    ///< at no time before it were the shapes nearer than the target
  real separation = 0;  ///< the last one known: at `fraction`, except for `separated`, where it is a lower bound there
  int iterations = 0;   ///< runs of GJK
};

/// `target` is the separation that counts as an impact, metres; negative ones down to minus both radii let rounded
/// shapes sink in. A hit is reported where the separation is between target and target + tolerance. A tolerance below
/// what rounding allows is raised to that.
template <typename Observer = NoObserver>
TimeOfImpact time_of_impact(const Hull& a, const Sweep& sweep_a, const Hull& b, const Sweep& sweep_b, real target,
                            real tolerance, Observer observer = {});

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
