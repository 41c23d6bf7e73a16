#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace proofreel {

/// Seeded random numbers that are the same with every standard library (splitmix64, Steele et al. 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9U;
    z = (z ^ z >> 27) * 0x94d049bb133111ebU;
    return z ^ z >> 31;
  }
  double between(double low, double high) { return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53); }
  /// 0 .. count - 1.
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>((bits() >> 32) * count >> 32); }
  /// Any finite double, all exponents equally likely.
  double any_double() {
    const double x = std::bit_cast<double>(bits());
    return std::isfinite(x) ? x : any_double();
  }
  /// Either sign, a size from 2^low on and below 2^high.
  double of_size(int low, int high) {
    const int exponent = low + static_cast<int>(below(static_cast<std::uint32_t>(high - low)));
    const double size = std::ldexp(between(1, 2), exponent);
    return (bits() & 1U) != 0 ? -size : size;
  }

 private:
  std::uint64_t state_;
};

}  // namespace proofreel
