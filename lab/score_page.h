#pragma once

#include <string>
#include <vector>

#include "lab/grid.h"
#include "lab/scorecard.h"

namespace proofreel {

/// What a page tells of how it came to be.
struct PageFacts {
  std::string command;            ///< that makes it again
  std::string version;            ///< of the program
  std::string machine;            ///< its processor
  std::vector<std::string> maps;  ///< the pictures of the same grid, relative to the page
  std::string table;              ///< the CSV file, relative to the page
};

/// The grid as one HTML page that needs nothing but the stills beside it: scores (none: no such table), the table of
/// all runs, and what did not stand, with the reasons. It can be sorted, read without colours, by ear and by keyboard,
/// and in light and dark.
std::string page_of(const Grid& grid, const std::vector<RunResult>& results, const std::vector<MethodScore>& scores,
                    const PageFacts& facts);

}  // namespace proofreel
