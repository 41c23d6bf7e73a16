#pragma once

#include <string>
#include <vector>

#include "golden/report.h"

namespace proofreel {

/// One line for every entry that did not pass, as GitHub Actions reads it from what a step prints: it then stands
/// beside the entry's file. Only one each, because GitHub shows ten per step. Files are named from `root`, the folder
/// that was checked out.
std::vector<std::string> annotations_of(const Report& report, const std::string& root);

}  // namespace proofreel
