#pragma once

/// The JSON library enters here and nowhere else.

#include <nlohmann/json.hpp>

namespace proofreel {

/// Keeps keys in the order they were written, so that files and outputs read the same every time.
using Json = nlohmann::ordered_json;

}  // namespace proofreel
