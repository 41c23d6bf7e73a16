#include "scenarios/overrides.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "scenarios/suggest.h"

namespace proofreel {
namespace {

const std::vector<std::string>& known_paths() {
  static const std::vector<std::string> paths{"title",
                                              "description",
                                              "duration",
                                              "rate",
                                              "fps",
                                              "seed",
                                              "gravity",
                                              "view.center",
                                              "view.height",
                                              "size",
                                              "theme",
                                              "effects",
                                              "layers",
                                              "force_scale",
                                              "method.integrator",
                                              "method.contact_solver",
                                              "method.joint_solver",
                                              "method.substeps",
                                              "method.iterations",
                                              "method.contact_hz",
                                              "method.precision",
                                              "golden.frames",
                                              "golden.size"};
  return paths;
}

bool is_known(const std::string& path) {
  return std::find(known_paths().begin(), known_paths().end(), path) != known_paths().end();
}

std::string full_path(const Override& override) {
  if (is_known(override.key)) return override.key;
  if (is_known("method." + override.key)) return "method." + override.key;
  std::vector<std::string> candidates = known_paths();
  for (const std::string& path : known_paths()) {
    if (path.starts_with("method.")) candidates.push_back(path.substr(std::string_view("method.").size()));
  }
  throw ScenarioError("--set " + override.key + "=" + override.value + ": unknown key " + quote(override.key) + ", " +
                      did_you_mean(override.key, candidates));
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

template <typename Number>
std::optional<Number> whole_text_as(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

OverrideItem parse_item(std::string_view text) {
  if (text == "true") return true;
  if (text == "false") return false;
  if (const auto integer = whole_text_as<std::int64_t>(text)) return *integer;
  if (const auto number = whole_text_as<double>(text)) return *number;
  const bool in_quotes = text.size() >= 2 && text.front() == text.back() && (text.front() == '"' || text[0] == '\'');
  return std::string(in_quotes ? text.substr(1, text.size() - 2) : text);
}

std::vector<OverrideItem> parse_list(std::string_view text) {
  std::vector<OverrideItem> items;
  while (!trimmed(text).empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    items.push_back(parse_item(trimmed(text.substr(0, comma))));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return items;
}

}  // namespace

ParsedOverride parse_override(const Override& override) {
  ParsedOverride parsed{full_path(override), "--set " + override.key + "=" + override.value, {}, false};
  const std::string_view text = trimmed(override.value);
  parsed.is_list = text.size() >= 2 && text.front() == '{' && text.back() == '}';
  if (parsed.is_list) {
    parsed.items = parse_list(text.substr(1, text.size() - 2));
  } else {
    parsed.items = {parse_item(text)};
  }
  return parsed;
}

}  // namespace proofreel
