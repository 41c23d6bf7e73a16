#pragma once

/// One scenario over two keys of scenario{}: where it stands, and what that costs.

#include <string>
#include <vector>

#include "lab/axis.h"
#include "lab/grid.h"

namespace proofreel {

/// The two axes of a map: those given, and instead of missing ones rate=60,120,240 and substeps=1,2,4,8. Throws
/// UsageError for more than two, and for one key twice.
std::vector<Axis> map_axes(const std::vector<std::string>& given);

/// A column per value of the first axis, a row per value of the second. `set` holds for all runs. Throws ScenarioError
/// for keys and values that scenario{} does not take, and for a scenario that cannot be run as it is.
Grid map_grid(const std::string& file, const std::vector<Axis>& axes, const std::vector<Override>& set);

}  // namespace proofreel
