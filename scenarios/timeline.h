#pragma once

/// Where frames and samples lie on the axis of ticks. Whole numbers only.

#include <cstdint>
#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace proofreel {

/// The longest run, so that ticks and film frames can be counted and listed.
inline constexpr double most_ticks = 1e8;

/// The tick nearest to scene time `seconds` (not negative).
std::int64_t tick_at(double seconds, int rate);

/// The file, and the pane where there are several, as sentences begin: "ball.lua: pane "slow": ".
std::string in_file(const Scenario& scenario);

/// Whether measures and plots are sampled at `tick`: at every frame of the film without slow motion, so at
/// round(i * rate / fps), and at the last tick.
bool is_sample_tick(const Scenario& scenario, std::int64_t tick);

/// The tick each film frame shows: every rate / fps ticks, more densely under slow motion. Throws ScenarioError, naming
/// the nearest rates that work, when that is not a whole number.
std::vector<std::int64_t> film_timeline(const Scenario& scenario);

/// The tick one more frame after the last would show: from the last frame's tick to it lies what that frame stands for.
std::int64_t film_end(const Scenario& scenario);

/// A section as frames of the film, the last one included.
struct FilmSection {
  std::string name;
  std::int64_t first = 0;
  std::int64_t last = 0;
};

/// The sections of the scenario, or, where it has none, the headings of what it demonstrates. `timeline` is that of
/// film_timeline. Sections without a frame are left out.
std::vector<FilmSection> film_sections(const Scenario& scenario, const std::vector<std::int64_t>& timeline);

}  // namespace proofreel
