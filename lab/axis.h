#pragma once

/// Keys of scenario{} that take several values, as the command line names them: `--vary rate=60,120,240`.

#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace proofreel {

/// The values one key takes.
struct Axis {
  std::string key;
  std::vector<std::string> values;
};

/// `rate=60,120,240`; commas within braces do not divide. Throws UsageError.
Axis parse_axis(const std::string& text);

/// The full key, so that `substeps` and `method.substeps` are one. Throws UsageError for keys scenario{} does not take.
std::string full_key(const Axis& axis);

/// All of `given`. Throws UsageError for one key twice.
std::vector<Axis> parse_axes(const std::vector<std::string>& given);

/// Says what is wrong with a value before anything is run (UsageError); that a value does not go with the scene is a
/// result. `set` holds beside it.
void check_axis(const std::string& file, const Axis& axis, const std::vector<Override>& set);

}  // namespace proofreel
