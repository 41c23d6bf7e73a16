#include "render/pixel_hash.h"

#include <xxhash.h>

#include <array>
#include <cstdio>

namespace proofreel {
namespace {

std::string hash_of(std::span<const std::uint8_t> bytes, std::uint64_t seed) {
  const XXH128_hash_t hash = XXH3_128bits_withSeed(bytes.data(), bytes.size(), seed);
  std::array<char, 33> text{};
  std::snprintf(text.data(), text.size(), "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return text.data();
}

}  // namespace

std::string pixel_hash(const Image& image) {
  const auto width = static_cast<std::uint64_t>(image.width_px);
  return hash_of(image.rgba, width << 32U | static_cast<std::uint64_t>(image.height_px));
}

std::string bytes_hash(std::span<const std::uint8_t> bytes) { return hash_of(bytes, 0); }

}  // namespace proofreel
