#pragma once

/// Where frames and samples lie on the axis of ticks. Whole numbers only.

#include <cstdint>

#include "scenarios/scenario.h"

namespace proofreel {

/// The longest run, so that ticks and film frames can be counted and listed.
inline constexpr double most_ticks = 1e8;

/// The tick nearest to scene time `seconds` (not negative).
std::int64_t tick_at(double seconds, int rate);

/// Whether measures and plots are sampled at `tick`: at every frame of the film without slow motion, so at
/// round(i * rate / fps), and at the last tick.
bool is_sample_tick(const Scenario& scenario, std::int64_t tick);

}  // namespace proofreel
