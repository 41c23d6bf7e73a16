#pragma once

/// The parts a step is put together from, and the time each of them takes.

#include <array>
#include <cstddef>
#include <cstdint>

namespace proofreel {

/// In the order of a step. Effects without a part of their own (friction, wind, ...) are inside another one.
enum class StepStage : std::uint8_t {
  broad_phase,
  narrow_phase,
  restitution,
  drag,
  rocket,
  gravity,
  attractor,
  nbody,
  buoyancy,
  field,
  springs,
  contact_solver,
  joint_solver,
  sleeping,
  motion  ///< positions from velocities, and what is kept at every tick
};
inline constexpr std::size_t stage_count = 15;

/// CPU time by stage, s, summed over all ticks so far.
struct StageTimes {
  std::array<double, stage_count> seconds{};
  double& of(StepStage stage) { return seconds[static_cast<std::size_t>(stage)]; }
  double of(StepStage stage) const { return seconds[static_cast<std::size_t>(stage)]; }
};

}  // namespace proofreel
