#pragma once

#include <optional>
#include <vector>

#include "lab/grid.h"
#include "render/context.h"
#include "render/image.h"

namespace proofreel {

/// The grid as one picture for print: a cell per run with a sign for its standing, its cost, and a fill told apart by
/// lightness too; the cheapest that stands is framed. As large as the grid needs, some 300 dots per inch on A4. Throws
/// EnvironmentError.
Image draw_map(const Grid& grid, const std::vector<RunResult>& results, std::optional<GlBackend> gl);

}  // namespace proofreel
