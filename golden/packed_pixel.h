#pragma once

#include <cstdint>
#include <cstring>

namespace proofreel {

/// The four bytes of a pixel as one number: equal exactly when they are.
inline std::uint32_t packed_pixel(const std::uint8_t* bytes) {
  std::uint32_t value;
  std::memcpy(&value, bytes, 4);
  return value;
}

}  // namespace proofreel
