#pragma once

/// What replaces a value of `scenario{}`: `--set KEY=VALUE` from the command line, or a key of `pane{}`. Which keys
/// there are and how values are written.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "scenarios/scenario.h"

namespace proofreel {

using OverrideItem = std::variant<bool, std::int64_t, double, std::string>;

/// One override, its value still to be checked against what the key takes.
struct ParsedOverride {
  std::string path;                 ///< full key: "duration", "method.substeps"
  std::string origin;               ///< for messages: "--set substeps=0", "ball.lua: line 3: pane "slow""
  std::vector<OverrideItem> items;  ///< one, or those of a {list}
  bool is_list = false;
};

/// Numbers, true, false, {lists, of, these} and plain words. `substeps` is short for `method.substeps`. Throws
/// ScenarioError for keys `scenario{}` does not have.
ParsedOverride parse_override(const Override& override);

}  // namespace proofreel
