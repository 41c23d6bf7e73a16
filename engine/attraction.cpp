#include "engine/attraction.h"

#include <cmath>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

Vec2 place_of(const std::vector<Body>& bodies, const std::vector<Motion>& motions, BodyIndex i) {
  return bodies[i].center + motions[i].delta;
}

bool is_pulled(const Body& body) { return body.alive && body.acts_as == BodyType::dynamic; }
/// Sleepers too: nothing pulls them, but they are where they are.
bool has_potential(const Body& body) { return body.alive && body.type == BodyType::dynamic; }

/// The point that pulls, or nothing when its body is gone.
struct Center {
  bool exists = true;
  BodyIndex body = 0;  ///< 0: a point of the world
  Vec2 place;
};

Center center_of(const AttractorDef& attractor, const std::vector<Body>& bodies, const std::vector<Motion>& motions) {
  if (!attractor.body) return {true, 0, Vec2(attractor.at)};
  const auto index = static_cast<BodyIndex>(*attractor.body);
  return {bodies[index].alive, index, place_of(bodies, motions, index)};
}

/// The acceleration towards a point `way` away, for 1 kg.
Vec2 pull(const AttractorDef& attractor, Vec2 way) {
  const auto strength = static_cast<real>(attractor.strength);
  if (attractor.law == AttractionLaw::linear) return strength * way;
  const real squared = length_squared(way);
  return squared > 0 ? strength / (squared * std::sqrt(squared)) * way : Vec2{};
}

/// 1 / r, or 0 at no distance, where nothing pulls.
double inverse_distance(Vec2d way) {
  const double r = length(way);
  return r > 0 ? 1 / r : 0;
}

}  // namespace

Vec2 kick_towards(const AttractorDef& attractor, const std::vector<Body>& bodies, std::vector<Motion>& motions,
                  real h) {
  const Center center = center_of(attractor, bodies, motions);
  if (!center.exists) return {};
  Vec2 handed_over;
  for (BodyIndex i = 1; i < bodies.size(); ++i) {
    if (!is_pulled(bodies[i]) || i == center.body) continue;
    const Vec2 gain = h * pull(attractor, center.place - place_of(bodies, motions, i));
    motions[i].velocity += gain;
    handed_over += bodies[i].mass * gain;
  }
  motions[center.body].velocity -= motions[center.body].inv_mass * handed_over;
  return handed_over;
}

double potential_of(const AttractorDef& attractor, const std::vector<Body>& bodies,
                    const std::vector<Motion>& motions) {
  const Center center = center_of(attractor, bodies, motions);
  if (!center.exists) return 0;
  double sum = 0;
  for (BodyIndex i = 1; i < bodies.size(); ++i) {
    if (!has_potential(bodies[i]) || i == center.body) continue;
    const Vec2d way(center.place - place_of(bodies, motions, i));
    const double strength = static_cast<double>(bodies[i].mass) * attractor.strength;
    sum += attractor.law == AttractionLaw::linear ? 0.5 * strength * length_squared(way)
                                                  : -strength * inverse_distance(way);
  }
  return sum;
}

void kick_towards_each_other(double gravitational_constant, const std::vector<Body>& bodies,
                             std::vector<Motion>& motions, real h) {
  const AttractorDef unit{std::nullopt, {}, gravitational_constant, AttractionLaw::inverse_square};
  for (BodyIndex i = 1; i < bodies.size(); ++i) {
    if (!is_pulled(bodies[i])) continue;
    for (BodyIndex j = i + 1; j < bodies.size(); ++j) {
      if (!is_pulled(bodies[j])) continue;
      const Vec2 gain = h * pull(unit, place_of(bodies, motions, j) - place_of(bodies, motions, i));
      motions[i].velocity += bodies[j].mass * gain;
      motions[j].velocity -= bodies[i].mass * gain;
    }
  }
}

double mutual_potential(double gravitational_constant, const std::vector<Body>& bodies,
                        const std::vector<Motion>& motions) {
  double sum = 0;
  for (BodyIndex i = 1; i < bodies.size(); ++i) {
    if (!has_potential(bodies[i])) continue;
    for (BodyIndex j = i + 1; j < bodies.size(); ++j) {
      if (!has_potential(bodies[j])) continue;
      const Vec2d way(place_of(bodies, motions, j) - place_of(bodies, motions, i));
      sum -= gravitational_constant * static_cast<double>(bodies[i].mass) * static_cast<double>(bodies[j].mass) *
             inverse_distance(way);
    }
  }
  return sum;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
