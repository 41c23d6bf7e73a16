#pragma once

/// What functions of a script can see of its variables. A run that is resumed from a file does not run the callbacks
/// again, so its variables still hold what they held when the script was loaded; a function is as good as ever when all
/// it can see held that in the saved run, too.

#include <cstdint>
#include <lua.hpp>
#include <map>
#include <optional>
#include <string>

namespace proofreel {

/// By name, a hash of what the variables of that name hold. It tells apart within one process only: what is neither
/// text nor number is told by where it lies.
using SeenVariables = std::map<std::string, std::uint64_t>;

/// The variables the function behind the reference can see: its own locals from outside, the globals if it uses any,
/// what lies in their tables, and what the functions found there can see in turn. Nothing when that is too much to look
/// at (100000 values, or nested deeper than 100). Call inside a turn.
std::optional<SeenVariables> variables_seen_by(lua_State* state, int function);

/// The first name under which the two differ; nothing when they are the same.
std::optional<std::string> difference(const std::optional<SeenVariables>& before,
                                      const std::optional<SeenVariables>& now);

}  // namespace proofreel
