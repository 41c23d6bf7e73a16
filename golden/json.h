#pragma once

/// The JSON library enters here and nowhere else.

#include <nlohmann/json.hpp>
#include <string>

namespace proofreel {

/// Keeps keys in the order they were written, so that files and outputs read the same every time.
using Json = nlohmann::ordered_json;

/// Bytes that are not UTF-8, which file names may hold, become replacement characters. `indent` < 0: one line.
inline std::string json_text(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace proofreel
