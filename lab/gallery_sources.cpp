// Which files of the engine a scenario shows at work, and Lua as HTML.

#include <algorithm>
#include <array>
#include <string_view>

#include "engine/effects.h"
#include "engine/simulation.h"
#include "golden/html.h"
#include "lab/gallery.h"

namespace proofreel {
namespace {

struct EffectFile {
  Effect effect;
  const char* file;
};

/// Effects whose files teach something of their own.
constexpr EffectFile effect_files[] = {{Effect::drag, "drag.h"},
                                       {Effect::wind, "drag.h"},
                                       {Effect::attractor, "attraction.h"},
                                       {Effect::nbody, "attraction.h"},
                                       {Effect::buoyancy, "buoyancy.h"},
                                       {Effect::field, "field.h"},
                                       {Effect::rocket, "rocket.h"},
                                       {Effect::contacts, "contact_solver.h"},
                                       {Effect::rolling_resistance, "rolling.h"},
                                       {Effect::restitution, "impact.h"},
                                       {Effect::ccd, "time_of_impact.h"},
                                       {Effect::joints, "joint_solver.h"},
                                       {Effect::sleeping, "sleep.h"}};

/// By JointKind.
constexpr std::array<const char*, 11> joint_files{"joints/revolute.cpp", "joints/distance.cpp",  "joints/spring.cpp",
                                                  "joints/rope.cpp",     "joints/prismatic.cpp", "joints/weld.cpp",
                                                  "joints/wheel.cpp",    "joints/gear.cpp",      "joints/pulley.cpp",
                                                  "joints/drag_to.cpp",  "joints/motor.cpp"};

std::vector<const char*> files_of(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::gift_wrapping:
    case Algorithm::diagonal_test:
    case Algorithm::edge_walk:
    case Algorithm::centroid:
      return {"polygon.h", "predicates.h"};
    case Algorithm::separating_axes:
    case Algorithm::circle_contact:
      return {"collide.h", "clip.h"};
    case Algorithm::gjk_epa:
      return {"gjk.h", "epa.h", "clip.h"};
    case Algorithm::tree_insertion:
    case Algorithm::tree_pairs:
      return {"dynamic_tree.h", "broad_phase.h"};
    case Algorithm::bounding_volumes:
      return {"aabb.h", "polygon.h"};
    case Algorithm::dot_product:
      return {"vec2.h"};
    case Algorithm::cross_product:
      return {"vec2.h", "predicates.h"};
    case Algorithm::transforms:
    case Algorithm::transform_order:
      return {"transform.h"};
    case Algorithm::gjk_line:
      return {"gjk.h"};
    case Algorithm::center_of_mass:
    case Algorithm::moment_of_inertia:
      return {"mass.h"};
    case Algorithm::friction_cone:
    case Algorithm::sequential_impulses:
      return {"contact_solver.h"};
  }
  return {};
}

constexpr std::string_view keywords[] = {"and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                         "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                         "repeat",   "return", "then", "true", "until",  "while"};
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Where the long bracket [[ or [==[ that begins at `at` ends; nothing when none begins there.
std::optional<std::size_t> end_of_long_bracket(std::string_view text, std::size_t at) {
  if (at >= text.size() || text[at] != '[') return std::nullopt;
  std::size_t level = 0;
  while (at + 1 + level < text.size() && text[at + 1 + level] == '=') ++level;
  if (at + 1 + level >= text.size() || text[at + 1 + level] != '[') return std::nullopt;
  const std::string close = std::string("]").append(level, '=').append("]");
  const std::size_t end = text.find(close, at + level + 2);
  return end == std::string_view::npos ? text.size() : end + close.size();
}

std::size_t end_of_comment(std::string_view text, std::size_t at) {
  if (const auto end = end_of_long_bracket(text, at + 2)) return *end;
  return std::min(text.find('\n', at), text.size());
}

std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  for (++at; at < text.size() && text[at] != quote && text[at] != '\n'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return std::min(at + 1, text.size());
}

template <typename IsPart>
std::size_t end_of(std::string_view text, std::size_t at, IsPart is_part) {
  while (at < text.size() && is_part(text[at])) ++at;
  return at;
}

/// A piece of the text and what it is; an empty kind for what has no colour.
struct Piece {
  std::size_t end = 0;
  const char* kind = "";
};

/// Words of the scenario language, and functions: names that are called and are no methods.
Piece name_at(std::string_view text, std::size_t at) {
  const std::size_t end = end_of(text, at, [](char c) { return is_letter(c) || is_digit(c); });
  if (std::find(std::begin(keywords), std::end(keywords), text.substr(at, end - at)) != std::end(keywords))
    return {end, "k"};
  const bool member = at > 0 && (text[at - 1] == '.' || text[at - 1] == ':');
  const std::size_t after = end_of(text, end, [](char c) { return c == ' '; });
  const bool called = after < text.size() && (text[after] == '{' || text[after] == '(');
  return {end, called && !member ? "w" : ""};
}

Piece piece_at(std::string_view text, std::size_t at) {
  const char c = text[at];
  if (text.substr(at, 2) == "--") return {end_of_comment(text, at), "c"};
  if (c == '"' || c == '\'') return {end_of_string(text, at), "s"};
  if (const auto end = end_of_long_bracket(text, at)) return {*end, "s"};
  if (is_digit(c)) return {end_of(text, at, [](char d) { return is_digit(d) || d == '.' || is_letter(d); }), "n"};
  if (is_letter(c)) return name_at(text, at);
  return {at + 1, ""};
}

}  // namespace

std::vector<std::string> engine_files_of(const Scenario& scenario) {
  std::vector<std::string> files;
  const auto add = [&files](const char* name) {
    const std::string file = std::string("engine/") + name;
    if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
  };
  for (const Story& story : scenario.stories) {
    for (const char* file : files_of(story.algorithm)) add(file);
  }
  for (const JointDef& joint : scenario.scene.joints) add(joint_files[static_cast<std::size_t>(joint.kind)]);
  const EffectSet effects = effects_of(scenario.scene);
  for (const EffectFile& one : effect_files) {
    if (effects.has(one.effect)) add(one.file);
  }
  return files;
}

std::string highlighted_lua(const std::string& text) {
  std::string html;
  for (std::size_t at = 0; at < text.size();) {
    const Piece piece = piece_at(text, at);
    const std::string escaped = html_escaped(text.substr(at, piece.end - at));
    html += *piece.kind == '\0' ? escaped : tag("span", escaped, attribute("class", piece.kind));
    at = piece.end;
  }
  return html;
}

}  // namespace proofreel
