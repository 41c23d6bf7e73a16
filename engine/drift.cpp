#include "engine/drift.h"

#include "engine/lanes.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Turns as many bodies as there are lanes by their own spins. What does not turn keeps every bit, so its lane is
/// computed and not used. False, and nothing has changed, where one turns too far for the short series.
bool turn_lanes(Motion* motions, real h) {
  Lanes spin{};
  Lanes angle{};
  Lanes c{};
  Lanes s{};
  for (int lane = 0; lane < lanes; ++lane) {
    spin[lane] = motions[lane].spin;
    angle[lane] = motions[lane].angle;
    c[lane] = motions[lane].rotation.c;
    s[lane] = motions[lane].rotation.s;
  }
  const Lanes way = h * spin;
  for (int lane = 0; lane < lanes; ++lane) {
    if (!(std::abs(way[lane]) < largest_small_turn)) return false;
  }
  const SmallTurn<Lanes> turn = small_turn(way);
  const Lanes turned_c = turn.c * c - turn.s * s;
  const Lanes turned_s = turn.s * c + turn.c * s;
  const Lanes square = turned_c * turned_c + turned_s * turned_s;
  Lanes length{};
  for (int lane = 0; lane < lanes; ++lane) length[lane] = std::sqrt(square[lane]);
  const Lanes new_c = spin != 0 ? turned_c / length : c;
  const Lanes new_s = spin != 0 ? turned_s / length : s;
  const Lanes new_angle = spin != 0 ? angle + way : angle;
  for (int lane = 0; lane < lanes; ++lane) {
    motions[lane].rotation = {new_c[lane], new_s[lane]};
    motions[lane].angle = new_angle[lane];
  }
  return true;
}

}  // namespace

void drift(std::span<Motion> motions, real h) {
  std::size_t i = 0;
  for (; i + lanes <= motions.size(); i += lanes) {
    Motion* some = motions.data() + i;
    for (int lane = 0; lane < lanes; ++lane) some[lane].delta += h * some[lane].velocity;
    real turning = std::abs(some[0].spin);
    for (int lane = 1; lane < lanes; ++lane) turning += std::abs(some[lane].spin);
    if (turning == 0 || turn_lanes(some, h)) continue;
    for (int lane = 0; lane < lanes; ++lane) {
      if (some[lane].spin != 0) turn_on(some[lane], h);
    }
  }
  for (; i < motions.size(); ++i) drift(motions[i], h);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
