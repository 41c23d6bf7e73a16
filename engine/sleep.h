#pragma once

/// Sleep: an island (islands.h) whose bodies have all come to rest is not stepped any more until something disturbs it.
///
/// When is a body at rest? A small speed says little: a ball at its apex has none, and a pendulum that turns has none.
/// So a body is watched for a while, its rest time, and is at rest when during all of it
///   - no point of it strays farther than a fiftieth of its size from where it was, and
///   - it trembles rather than travels: it comes less than a quarter as far as its greatest speed would have taken it,
///     or not even a ten thousandth of its size. What rolls slowly but steadily is not at rest.
///
/// How long is a while? Half a swing: whatever swings goes from one turning point to the other in it and cannot pass
/// for resting, unless it swings by less than that fiftieth. A pendulum of length l takes pi sqrt(l / g) for it, a mass
/// m on a spring k takes pi sqrt(m / k), and a body that stands rocks about as a pendulum a quarter of its size would:
/// 0.5 s for a square of 1 m on Earth. Nothing in this is measured in metres or seconds of its own, so a scene scaled
/// in length and time falls asleep alike. Only where there is no gravity and no spring nothing tells the time; there it
/// is half a second.
///
/// What hangs on nothing (drifts in space, flies, swims) never sleeps, and neither does what is driven: touched or held
/// by a kinematic body that moves or a surface that does, under a running motor or a burning rocket, pulled by bodies
/// that may move.

#include <vector>

#include "engine/contact.h"
#include "engine/simulation.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// What a body's rest is measured by.
struct RestScale {
  real reach = 1;  ///< m, from its centre of mass to its farthest point
  int ticks = 1;   ///< its rest time
};

/// Half a swing of a pendulum, s.
real half_swing(real length, real gravity);
/// Half a swing of a mass on a spring, s.
real half_swing_on_spring(real mass, real stiffness);
/// The rest time of a body that stands by itself, s.
real standing_rest_time(real reach, real gravity);

/// Watches one body, from the end of one tick to that of the next.
class RestClock {
 public:
  /// Looks at the body at the end of a tick of `dt` seconds. True when it is at rest.
  bool look(const Body& body, const Motion& motion, const RestScale& scale, real dt);
  /// For archives (world_archive.cpp).
  template <typename Archive, typename Self>
  static void exchange(Archive& archive, Self& clock);

 private:
  Vec2 center_;       ///< where it was when the clock was started
  real angle_ = 0;    ///< then
  real fastest_ = 0;  ///< the greatest speed of any of its points since then, m/s
  int ticks_ = 0;     ///< since then; 0 starts it
};

/// By body: whether it is at rest.
using Resting = std::vector<std::uint8_t>;

/// What decides whether an island may fall asleep.
struct IslandState {
  bool rests = true;    ///< all of its bodies do
  bool held = false;    ///< by something that does not move
  bool driven = false;  ///< by something that does, or will
  bool may_sleep() const { return rests && held && !driven; }
};

/// What a world remembers of rest and sleep; all of it empty where the effect is off.
struct Sleep {
  std::vector<RestScale> scales;        ///< by body
  std::vector<RestClock> clocks;        ///< by body
  std::vector<BodyIndex> islands;       ///< by body: the least body of the island it sleeps in; 0: it is awake
  std::vector<Vec2d> forces;            ///< by body: of the force fields when they were last asked, N
  std::vector<Contact> contacts;        ///< of sleepers with sleepers and with what stands still, in order of creation
  std::vector<SleepEvent> events;       ///< of the last tick
  std::vector<SleepEvent> next_events;  ///< since then: of commands that woke somebody
  int sleepers = 0;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
