#pragma once

#include <cstdint>
#include <cstdlib>
#include <vector>

/// What this program draws: a gradient of 96 x 64 pixels, and with BREAK_IT set a dent in it.
inline std::vector<std::uint8_t> drawn() {
  std::vector<std::uint8_t> rgba;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 96; ++x) {
      const bool dent = std::getenv("BREAK_IT") != nullptr && x / 8 == 5 && y / 8 == 3;
      for (const int channel : {2 * x, 3 * y, dent ? 255 : 120, 255}) {
        rgba.push_back(static_cast<std::uint8_t>(channel));
      }
    }
  }
  return rgba;
}
