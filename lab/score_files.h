#pragma once

#include <string>
#include <vector>

#include "lab/grid_work.h"
#include "lab/score_page.h"

namespace proofreel {

/// Writes NAME.html and NAME.png beside the grid's table, or NAME-1.png, NAME-2.png ... where it has too many rows for
/// a sheet of paper. The pictures are drawn in processes of their own. Throws
/// EnvironmentError.
void write_score_files(const Grid& grid, const std::vector<RunResult>& results, const std::vector<MethodScore>& scores,
                       const GridWork& work, const std::string& command, const std::string& version);

}  // namespace proofreel
