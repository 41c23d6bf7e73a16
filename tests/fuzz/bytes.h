#pragma once

/// Makes numbers out of the bytes a fuzzer offers. Bytes that are used up read as zero.

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/vec2.h"

namespace proofreel::fuzz {

class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool empty() const { return at_ >= bytes_.size(); }

  std::uint8_t byte() { return empty() ? std::uint8_t{0} : bytes_[at_++]; }

  std::uint64_t word() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
    return bits;
  }

  /// 0 .. count - 1.
  int below(int count) { return byte() % count; }

  /// Sizes of everyday things on a coarse grid, where points coincide and lines run parallel; fine ones; and now and
  /// then any bit pattern at all.
  double number() {
    const int kind = byte();
    if (kind == 255) return std::bit_cast<double>(word());
    if (kind == 254) return std::ldexp(1.0 + byte() / 256.0, byte() % 64 - 32);
    if (kind >= 128) return static_cast<double>(byte()) / 16 - 8;
    return static_cast<double>(word() >> 11) * 0x1p-50 - 4;
  }

  Vec2d vector() {
    const double x = number();
    return {x, number()};
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

}  // namespace proofreel::fuzz
