#include <array>

#include "scenarios/scenario.h"

namespace proofreel {
namespace {

constexpr std::array<const char*, layer_count> layer_names{
    "bodies", "parts", "bvh",   "contacts", "joints",  "aabbs", "trails", "vectors",
    "labels", "grid",  "clock", "forces",   "islands", "ids",   "mass",   "energy"};

}  // namespace

const char* name_of(Layer layer) { return layer_names[static_cast<std::size_t>(layer)]; }

std::optional<Layer> layer_named(std::string_view name) {
  for (std::size_t i = 0; i < layer_names.size(); ++i) {
    if (name == layer_names[i]) return static_cast<Layer>(i);
  }
  return std::nullopt;
}

std::optional<Theme> theme_named(std::string_view name) {
  if (name == "light") return Theme::light;
  if (name == "dark") return Theme::dark;
  if (name == "print") return Theme::print;
  return std::nullopt;
}

}  // namespace proofreel
