#include "render/pixel_hash.h"

#include <array>
#include <cstdio>

#include "engine/state_hash.h"

namespace proofreel {
namespace {

std::string hex_hash(std::span<const std::uint8_t> bytes, std::uint64_t seed) {
  const Hash128 hash = hash128_of(bytes.data(), bytes.size(), seed);
  std::array<char, 33> text{};
  std::snprintf(text.data(), text.size(), "%016llx%016llx", static_cast<unsigned long long>(hash.high),
                static_cast<unsigned long long>(hash.low));
  return text.data();
}

}  // namespace

std::string pixel_hash(const Image& image) {
  const auto width = static_cast<std::uint64_t>(image.width_px);
  return hex_hash(image.rgba, width << 32U | static_cast<std::uint64_t>(image.height_px));
}

std::string bytes_hash(std::span<const std::uint8_t> bytes) { return hex_hash(bytes, 0); }

}  // namespace proofreel
