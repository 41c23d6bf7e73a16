#pragma once

/// Scenes that are heavy for a physics engine, each for its own reason, and what should stay true in them.

#include <functional>
#include <string>
#include <vector>

#include "engine/simulation.h"

namespace proofreel {

struct BenchScene {
  std::string name;
  Scene scene;  ///< 60 ticks per second, 4 substeps, single precision
  int seconds = 5;
  /// What is asked of the simulation before each tick; most scenes ask nothing.
  std::function<std::vector<Command>(std::int64_t tick)> commands;
  std::vector<FilterDef> filters;  ///< of all bodies that there will be
  /// How far the scene has come from what it should be, in words.
  std::function<std::string(const Snapshot& start, const Snapshot& now)> drift;
};

/// Boxes of 0.8 m in rows, each row one box shorter than the one below.
BenchScene pyramid(int rows);
/// A square net of discs, each pinned to its upper and its left neighbour, held by seven discs of its upper edge. There
/// are more equations than ways to move, so it should hang as stiff as a board.
BenchScene joint_grid(int side);
/// Boxes of 0.25 m in a hollow square that turns at 25 degrees per second; `side` boxes in each row and column.
BenchScene tumbler(int side);
/// Figures of eleven bodies and ten limited pins each, which fall into a basin row by row until there are `count`.
BenchScene ragdoll_rain(int count);
/// Bodies that meet nobody, under gravity and linear drag.
BenchScene free_bodies(int count);

}  // namespace proofreel
