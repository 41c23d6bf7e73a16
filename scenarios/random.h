#pragma once

/// The random numbers of a scene: the same sequence from the same seed on every machine.

#include <array>
#include <cstdint>

namespace proofreel {

/// xoshiro256** (Blackman, Vigna 2018), its state filled from the seed by splitmix64.
class Random {
 public:
  explicit Random(std::uint64_t seed);
  std::uint64_t next();
  /// In [0, 1), a multiple of 2^-53.
  double uniform();
  /// A whole number in [low, high], each equally likely; low <= high.
  std::int64_t between(std::int64_t low, std::int64_t high);

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace proofreel
