#include "engine/field.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

Vec2d FieldForces::force_on(const Body& body, const Motion& motion, Vec2d velocity, double time) const {
  Vec2d force;
  for (const ForceField& field : fields_) force += field(Vec2d(body.center + motion.delta), velocity, time);
  return force;
}

void FieldForces::kick_at_begin(const std::vector<Body>& bodies, std::vector<Motion>& motions, double time, real h) {
  forces_.assign(bodies.size(), {});
  for (BodyIndex i = 1; i < bodies.size(); ++i) {
    if (bodies[i].acts_as != BodyType::dynamic) continue;
    forces_[i] = force_on(bodies[i], motions[i], Vec2d(motions[i].velocity), time);
    motions[i].velocity += h * motions[i].inv_mass * Vec2(forces_[i]);
  }
}

double FieldForces::drifted(const std::vector<Motion>& motions, real h) {
  ways_.resize(motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) ways_[i] = Vec2d(h * motions[i].velocity);
  return work();
}

double FieldForces::kick_at_end(const std::vector<Body>& bodies, std::vector<Motion>& motions, double time, real h) {
  for (BodyIndex i = 1; i < bodies.size(); ++i) {
    if (bodies[i].acts_as != BodyType::dynamic) continue;
    const Vec2 foretold = motions[i].velocity + h * motions[i].inv_mass * Vec2(forces_[i]);
    forces_[i] = force_on(bodies[i], motions[i], Vec2d(foretold), time);
    motions[i].velocity += h * motions[i].inv_mass * Vec2(forces_[i]);
  }
  return work();
}

double FieldForces::work() const {
  double sum = 0;
  for (std::size_t i = 0; i < forces_.size(); ++i) sum += dot(forces_[i], ways_[i]);
  return sum;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
