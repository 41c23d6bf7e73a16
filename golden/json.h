#pragma once

/// The JSON library enters here and nowhere else.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace proofreel {

/// Keeps keys in the order they were written, so that files and outputs read the same every time.
using Json = nlohmann::ordered_json;

/// What is wrong with a text that was to be read, in words for whoever wrote or damaged it: the rest of a sentence that
/// begins with the file's name. `error` is what reading it threw.
inline std::string problem_in_json(const Json::exception& error, std::string_view text) {
  const auto* broken = dynamic_cast<const Json::parse_error*>(&error);
  if (broken == nullptr) return "a key in it is missing or has a value of the wrong kind";
  const std::string_view read = text.substr(0, std::max<std::size_t>(broken->byte, 1) - 1);
  return "line " + std::to_string(1 + std::count(read.begin(), read.end(), '\n')) + " is no JSON";
}

/// Bytes that are not UTF-8, which file names may hold, become replacement characters. `indent` < 0: one line.
inline std::string json_text(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace proofreel
