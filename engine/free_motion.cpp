#include "engine/free_motion.h"

#include "engine/drag.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// What a body's loop needs, and no more.
struct Flight {
  Vec2 gain;  ///< of speed, by one kick
  DragDef drag;
  Vec2 wind;
  int substeps;
  real h;
  real share;  ///< of a substep's forces in one kick: half for verlet
};

inline void slow_down(const Flight& flight, Motion& m) {
  if (flight.drag.acts()) apply_drag(m, flight.drag, flight.wind, flight.share * flight.h);
}

/// Out of the loop over the bodies, so that its registers are for those that do not turn.
template <bool verlet, bool gravity, bool drag>
[[gnu::noinline]] void fly_one(const Flight& flight, Motion& m) {
  for (int i = 0; i < flight.substeps; ++i) {
    if constexpr (verlet && drag) slow_down(flight, m);
    if constexpr (gravity) m.velocity += flight.gain;
    drift(m, flight.h);
    if constexpr (verlet && gravity) m.velocity += flight.gain;
    if constexpr (drag) slow_down(flight, m);
  }
}

/// The same of a body that does not turn: four numbers, which stay in registers.
template <bool verlet, bool gravity>
[[gnu::always_inline]] inline void glide_one(Vec2 gain, int substeps, real h, Vec2& velocity, Vec2& center) {
  Vec2 v = velocity;
  Vec2 way;
  for (int i = 0; i < substeps; ++i) {
    if constexpr (gravity) v += gain;
    way += h * v;
    if constexpr (verlet && gravity) v += gain;
  }
  velocity = v;
  center += way;
}

template <bool verlet, bool gravity, bool drag>
void fly_all(const FreeForces& forces, int substeps, real h, std::vector<Body>& bodies, std::vector<Motion>& motions) {
  const real share = verlet ? real(0.5) : real(1);
  const real kick = share * h;
  const Vec2* acceleration = forces.accelerations.data();
  Body* body = bodies.data();
  Motion* const end = motions.data() + motions.size();
  for (Motion* m = motions.data(); m != end; ++m, ++body) {
    Vec2 gain;
    if constexpr (gravity) gain = kick * *acceleration++;
    if (!drag && m->spin == 0) {
      glide_one<verlet, gravity>(gain, substeps, h, m->velocity, body->center);
    } else {
      Flight flight{gain, {}, forces.wind, substeps, h, share};
      if constexpr (drag) flight.drag = forces.drags[static_cast<std::size_t>(m - motions.data())];
      fly_one<verlet, gravity, drag>(flight, *m);
      body->center += m->delta;
      m->delta = {};
    }
  }
}

template <bool verlet, bool gravity>
auto loop_for(bool drag) {
  return drag ? fly_all<verlet, gravity, true> : fly_all<verlet, gravity, false>;
}

template <bool verlet>
auto loop_for(bool gravity, bool drag) {
  return gravity ? loop_for<verlet, true>(drag) : loop_for<verlet, false>(drag);
}

}  // namespace

void fly(const FreeForces& forces, Integrator integrator, int substeps, real h, std::vector<Body>& bodies,
         std::vector<Motion>& motions) {
  const bool gravity = !forces.accelerations.empty();
  const bool drag = !forces.drags.empty();
  const auto loop = integrator == Integrator::verlet ? loop_for<true>(gravity, drag) : loop_for<false>(gravity, drag);
  loop(forces, substeps, h, bodies, motions);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
