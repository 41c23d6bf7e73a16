#pragma once

#include "golden/difference.h"

namespace proofreel {

/// The window of `side_px` squared pixels, cut to the picture, that holds most different ones; of several, the first
/// from the top and then from the left. A count of 0 has an empty window. Sums slide along, so that it takes a few
/// operations per pixel whatever the window.
DensestWindow densest_window(const DifferenceMap& map, int side_px);

}  // namespace proofreel
