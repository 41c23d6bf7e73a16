#pragma once

/// What the marks of a picture belong to, as names that mean the same in every run.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace proofreel {

enum class OwnerKind : std::uint8_t {
  nothing,  ///< the background
  grid,
  water,
  body,
  trail,
  bvh,
  aabbs,
  joint,
  contact,
  vector,
  clock,
  caption,
  plot,
  label,
  pane,  ///< of a lecture film
  force,
  mass,
  id,
  energy,
  highlight,
  note  ///< what a layer has to say about itself
};
inline constexpr std::array<const char*, 21> owner_kind_names{
    "nothing", "grid", "water", "body", "trail", "bvh",  "aabbs", "joint",  "contact",   "vector", "clock",
    "caption", "plot", "label", "pane", "force", "mass", "id",    "energy", "highlight", "note"};
inline const char* name_of(OwnerKind kind) { return owner_kind_names[static_cast<std::size_t>(kind)]; }
inline std::optional<OwnerKind> owner_kind_named(std::string_view name) {
  const auto found = std::find(owner_kind_names.begin(), owner_kind_names.end(), name);
  if (found == owner_kind_names.end()) return std::nullopt;
  return static_cast<OwnerKind>(found - owner_kind_names.begin());
}

/// What a mark belongs to. Equal exactly when it is the same thing, in pictures of different runs, too.
struct Owner {
  OwnerKind kind = OwnerKind::nothing;
  std::uint32_t a =
      0;  ///< a body's id: of bodies, trails, vectors, labels, masses and ids; the first of a joint, contact or force
  std::uint32_t b = 0;    ///< the second body of a joint, contact or force
  std::string text = {};  ///< what a caption, label or note says; the title of a plot or pane
  friend bool operator==(const Owner&, const Owner&) = default;
  friend auto operator<=>(const Owner&, const Owner&) = default;
};

/// The owner of every pixel: that of the mark which lies on top there, however faint.
struct OwnerPicture {
  int width_px = 0;
  int height_px = 0;
  std::vector<Owner> owners;           ///< each once, those that are seen; the first is nothing
  std::vector<std::uint32_t> indices;  ///< into `owners`, by pixel, rows from the top

  std::uint32_t index_at(int x, int y) const {
    return indices[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x)];
  }
  const Owner& at(int x, int y) const { return owners[index_at(x, y)]; }
};

}  // namespace proofreel
