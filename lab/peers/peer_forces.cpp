#include "lab/peers/peer_forces.h"

#include <algorithm>
#include <cmath>

namespace proofreel {
namespace {

bool is_pulled(const LoadedBody& body) { return body.type == BodyType::dynamic; }

/// For 1 kg, N; `way` leads to what attracts.
Vec2d attraction(const AttractorDef& attractor, Vec2d way) {
  if (attractor.law == AttractionLaw::linear) return attractor.strength * way;
  const double squared = length_squared(way);
  return squared > 0 ? attractor.strength / (squared * std::sqrt(squared)) * way : Vec2d{};
}

/// For 1 kg, J.
double potential_at(const AttractorDef& attractor, Vec2d way) {
  if (attractor.law == AttractionLaw::linear) return 0.5 * attractor.strength * length_squared(way);
  const double r = length(way);
  return r > 0 ? -attractor.strength / r : 0;
}

/// Calls `act(body, way)` for everything the attractor pulls; with the body it belongs to, or null.
template <typename Bodies, typename Act>
void for_each_pulled(const AttractorDef& attractor, Bodies& bodies, const Act& act) {
  auto center = bodies.end();
  if (attractor.body) {
    center = std::find_if(bodies.begin(), bodies.end(), [&](const LoadedBody& b) { return b.id == *attractor.body; });
    if (center == bodies.end()) return;  // it has been removed
  }
  const Vec2d place = attractor.body ? center->state.center : attractor.at;
  for (auto body = bodies.begin(); body != bodies.end(); ++body) {
    if (!is_pulled(*body) || body == center) continue;
    act(*body, center == bodies.end() ? nullptr : &*center, place - body->state.center);
  }
}

/// Calls `act(a, b, way)` for each pair of bodies with mass once, `way` from a to b.
template <typename Bodies, typename Act>
void for_each_pair(Bodies& bodies, const Act& act) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!is_pulled(bodies[i])) continue;
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      if (is_pulled(bodies[j])) act(bodies[i], bodies[j], bodies[j].state.center - bodies[i].state.center);
    }
  }
}

}  // namespace

PeerForces::PeerForces(const Scene& scene)
    : drag_(scene.drag),
      wind_(scene.wind),
      attractors_(scene.attractors),
      gravitational_constant_(scene.gravitational_constant.value_or(0)),
      fields_(scene.fields) {}

bool PeerForces::act() const { return drag_.acts() || need_places(); }

void PeerForces::add_drag(LoadedBody& body) const {
  const DragDef drag = body.drag.value_or(drag_);
  const Vec2d relative = body.state.velocity - wind_;
  body.force -= (drag.linear + drag.quadratic * length(relative)) * relative;
  body.torque -= drag.angular * body.state.spin;
}

void PeerForces::add_to(std::vector<LoadedBody>& bodies, double time) const {
  for (LoadedBody& body : bodies) {
    if (!is_pulled(body)) continue;
    add_drag(body);
    for (const ForceField& field : fields_) body.force += field(body.state.center, body.state.velocity, time);
  }
  for (const AttractorDef& attractor : attractors_) {
    for_each_pulled(attractor, bodies, [&](LoadedBody& body, LoadedBody* center, Vec2d way) {
      const Vec2d force = body.state.mass * attraction(attractor, way);
      body.force += force;
      if (center != nullptr) center->force -= force;
    });
  }
  if (gravitational_constant_ <= 0) return;
  for_each_pair(bodies, [&](LoadedBody& a, LoadedBody& b, Vec2d way) {
    const AttractorDef other{{}, {}, gravitational_constant_ * b.state.mass, AttractionLaw::inverse_square};
    const Vec2d force = a.state.mass * attraction(other, way);
    a.force += force;
    b.force -= force;
  });
}

double PeerForces::potential(const std::vector<LoadedBody>& bodies) const {
  double sum = 0;
  for (const AttractorDef& attractor : attractors_) {
    for_each_pulled(attractor, bodies, [&](const LoadedBody& body, const LoadedBody*, Vec2d way) {
      sum += body.state.mass * potential_at(attractor, way);
    });
  }
  if (gravitational_constant_ <= 0) return sum;
  for_each_pair(bodies, [&](const LoadedBody& a, const LoadedBody& b, Vec2d way) {
    const double r = length(way);
    if (r > 0) sum -= gravitational_constant_ * a.state.mass * b.state.mass / r;
  });
  return sum;
}

}  // namespace proofreel
