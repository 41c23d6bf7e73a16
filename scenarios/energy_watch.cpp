#include "scenarios/energy_watch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/snapshot.h"

namespace proofreel {
namespace {

constexpr double suspicious_part = 1e-3;

}  // namespace

/// N, by the scene's gravity.
double EnergyWatch::weight_of_bodies(const Simulation& simulation) const {
  Snapshot snapshot;
  simulation.observe(snapshot);
  double mass = 0;
  for (const BodyView& body : snapshot.bodies) {
    if (body.type == BodyType::dynamic) mass += body.state.mass;
  }
  return mass * length(gravity_);
}

void EnergyWatch::look(const Simulation& simulation, const Energy& now) {
  if (!simulation.books_work() || !std::isfinite(now.total())) return;
  largest_kinetic_ = std::max(largest_kinetic_, now.kinetic);
  const double grown = now.total() - now.booked_work - initial_;
  if (!settled_) {
    released_ = std::max(released_, grown);
    settled_ = simulation.tick() > 0 && !simulation.is_settling();
    return;
  }
  const double gained = grown - released_;
  if (growth_) growth_->joules = std::max(growth_->joules, gained);
  const double moved = largest_kinetic_ + std::abs(now.booked_work);
  if (growth_ || gained <= suspicious_part * moved) return;
  if (gained > suspicious_part * (moved + weight_of_bodies(simulation) * height_))
    growth_ = EnergyGrowth{simulation.tick(), gained};
}

std::string sentence(const EnergyGrowth& growth, int rate) {
  char text[160];
  std::snprintf(text, sizeof text,
                "energy grew by %.4g J beyond the work done on the scene, first seen at tick %lld (%.6g s); "
                "try a higher rate or more substeps",
                growth.joules, static_cast<long long>(growth.tick), static_cast<double>(growth.tick) / rate);
  return text;
}

}  // namespace proofreel
