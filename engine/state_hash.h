#pragma once

/// Fingerprints: equal exactly when all bits are (xxHash enters the project here and nowhere else).

#include <cstddef>
#include <cstdint>

namespace proofreel {

/// XXH3, 64 bits.
std::uint64_t hash_of(const void* bytes, std::size_t size);

/// XXH3, 128 bits, for what is kept for years (pictures); the seed is hashed too.
struct Hash128 {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
};
Hash128 hash128_of(const void* bytes, std::size_t size, std::uint64_t seed);

/// A chain of state hashes: equal exactly when all ticks are. Start from 0 with the hash of the initial state.
std::uint64_t chained_hash(std::uint64_t chain, std::uint64_t state);

}  // namespace proofreel
