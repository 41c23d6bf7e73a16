#pragma once

/// Watches for energy that comes from nowhere: a sign that the time step is too long, or that something is wrong.

#include <cstdint>
#include <optional>
#include <string>

#include "engine/simulation.h"

namespace proofreel {

/// Energy beyond what the scene began with and the work that was done on it.
struct EnergyGrowth {
  std::int64_t tick = 0;  ///< at which it was first seen
  double joules = 0;      ///< the most there was at any time
};

/// Growth is energy - booked work - initial energy, if that is more than a thousandth of what moves in the scene: the
/// weight of its bodies times the height of its picture, the largest kinetic energy so far (which is a fair scale where
/// there is no gravity) and the booked work. What bodies that start inside each other and joints that start open
/// release belongs to the start: nothing counts until they have come apart and closed.
class EnergyWatch {
 public:
  /// `height` of the picture, m.
  EnergyWatch(Vec2d gravity, double height) : gravity_(gravity), height_(height) {}
  void start_from(double initial_energy) { initial_ = initial_energy; }
  /// To be called now and then with what simulation.energy() says.
  void look(const Simulation& simulation, const Energy& now);
  const std::optional<EnergyGrowth>& growth() const { return growth_; }

 private:
  double weight_of_bodies(const Simulation& simulation) const;

  Vec2d gravity_;
  double height_;
  double initial_ = 0;
  double released_ = 0;  ///< at the start, J
  double largest_kinetic_ = 0;
  bool settled_ = false;
  std::optional<EnergyGrowth> growth_;
};

/// "energy grew by 3.2 J beyond the work done on the scene, first seen at tick 12 (0.05 s)".
std::string sentence(const EnergyGrowth& growth, int rate);

}  // namespace proofreel
