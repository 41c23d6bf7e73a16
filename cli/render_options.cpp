#include "cli/render_options.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "lab/csv.h"
#include "render/png.h"

namespace proofreel {
namespace {

/// The whole text as a number that is not negative.
std::optional<std::int64_t> parse_number(std::string_view text) {
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || text.empty() || text.front() == '-') return std::nullopt;
  return value;
}

std::string layer_names() {
  std::string names;
  for (int i = 0; i < layer_count; ++i) {
    names.append(i == 0 ? "" : ", ").append(name_of(static_cast<Layer>(i)));
  }
  return names;
}

Layer parse_layer(const std::string& name) {
  if (const std::optional<Layer> layer = layer_named(name)) return *layer;
  throw UsageError("There is no layer \"" + name + "\"; there are " + layer_names() + ".");
}

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

bool is_change(const std::string& word) { return !word.empty() && (word.front() == '+' || word.front() == '-'); }

void apply_change(const std::string& word, std::vector<Layer>& layers) {
  const Layer layer = parse_layer(word.substr(1));
  layers.erase(std::remove(layers.begin(), layers.end(), layer), layers.end());
  if (word.front() == '+') layers.push_back(layer);
}

}  // namespace

Size parse_size(const std::string& text) {
  const std::size_t x = text.find('x');
  const std::optional<std::int64_t> width = parse_number(text.substr(0, x));
  const std::optional<std::int64_t> height = x == std::string::npos ? std::nullopt : parse_number(text.substr(x + 1));
  if (!width || !height)
    throw UsageError("--size takes WIDTHxHEIGHT in pixels, such as 1920x1080, not \"" + text + "\".");
  const auto fits = [](std::int64_t side) { return side >= 1 && side <= max_image_side_px; };
  if (fits(*width) && fits(*height)) return {static_cast<int>(*width), static_cast<int>(*height)};
  throw UsageError("--size goes from 1x1 to " + std::to_string(max_image_side_px) + "x" +
                   std::to_string(max_image_side_px) + ", so not " + text + ".");
}

FrameRange parse_frames(const std::string& text, std::int64_t film_length) {
  const std::size_t colon = text.find(':');
  const std::optional<std::int64_t> first = parse_number(text.substr(0, colon));
  const std::optional<std::int64_t> last = colon == std::string::npos ? first : parse_number(text.substr(colon + 1));
  if (!first || !last)
    throw UsageError("--frames takes FIRST:LAST, both included, such as 0:59, not \"" + text + "\".");
  if (*first > *last) throw UsageError("--frames " + text + " ends before it begins.");
  if (*last < film_length) return {*first, *last};
  throw UsageError("--frames " + text + " is beyond the film, which has frames 0 to " +
                   std::to_string(film_length - 1) + ".");
}

std::vector<Layer> parse_layers(const std::string& text, const std::vector<Layer>& present) {
  const std::vector<std::string> words = split_at_commas(text);
  const bool changes = std::any_of(words.begin(), words.end(), is_change);
  if (changes && !std::all_of(words.begin(), words.end(), is_change)) {
    throw UsageError("--layers takes either a list (bodies,contacts) or changes (+bvh,-labels), not \"" + text + "\".");
  }
  std::vector<Layer> layers;
  if (changes) layers = present;
  for (const std::string& word : words) apply_change(changes ? word : "+" + word, layers);
  return layers;
}

void apply_layers(const std::string& text, Picture& picture) {
  picture.layers = parse_layers(text, picture.layers);
  for (LayerChange& change : picture.layer_changes) change.layers = parse_layers(text, change.layers);
}

Theme parse_theme(const std::string& text) {
  if (const std::optional<Theme> theme = theme_named(text)) return *theme;
  throw UsageError("There is no theme \"" + text + "\"; there are light, dark and print.");
}

double parse_card_seconds(const std::string& text) {
  constexpr double longest = 60;
  const std::optional<double> seconds = number_in(text);
  if (seconds && *seconds > 0 && *seconds <= longest) return *seconds;
  throw UsageError("--title-card takes seconds, more than 0 and up to 60, such as --title-card=2.5, not \"" + text +
                   "\".");
}

std::optional<SheetGrid> parse_sheet_grid(const std::string& text) {
  constexpr std::int64_t most = 100;
  if (text == "auto") return std::nullopt;
  const std::size_t x = text.find('x');
  const std::optional<std::int64_t> columns = parse_number(text.substr(0, x));
  const std::optional<std::int64_t> rows = x == std::string::npos ? std::nullopt : parse_number(text.substr(x + 1));
  const auto fits = [](std::optional<std::int64_t> side) { return side && *side >= 1 && *side <= most; };
  if (fits(columns) && fits(rows)) return SheetGrid{static_cast<int>(*columns), static_cast<int>(*rows)};
  throw UsageError("--contact-sheet takes COLUMNSxROWS, from 1x1 to 100x100, such as --contact-sheet=4x3, not \"" +
                   text + "\".");
}

}  // namespace proofreel
