#pragma once

/// Words and numbers that a grid's page, its map and the summary on the terminal have in common.

#include <optional>
#include <string>

#include "lab/grid.h"

namespace proofreel {

/// "0.042", "0.42", "3.1", "250": two digits, or all that are before the point; no more than three behind it. Empty for
/// nothing.
std::string cost_text(std::optional<double> cost_ms);

/// "soft_step, own, double"; parts that are empty are left out.
std::string name_of(const Heading& heading);

/// What a row or a column of the grid is called where it stands alone: "rate = 60", "hard/stack".
std::string label_of(const Grid& grid, const Heading& heading);

/// All that is known of a run, in sentences: for who points at its cell.
std::string details_of(const RunRequest& request, const RunResult& result);

}  // namespace proofreel
