#pragma once

#include <cmath>
#include <cstdint>

namespace proofreel {

/// Straight (not premultiplied) colour, 0..255 each.
struct Color {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  friend bool operator==(Color, Color) = default;
};

/// The colour `part` (0..1) of the way from `a` to `b`.
inline Color mixed(Color a, Color b, double part) {
  const auto channel = [part](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::floor(from + (to - from) * part + 0.5));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), channel(a.a, b.a)};
}

}  // namespace proofreel
