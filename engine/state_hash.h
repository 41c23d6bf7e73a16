#pragma once

/// Fingerprints of motion: equal exactly when all bits are.

#include <cstddef>
#include <cstdint>

namespace proofreel {

/// XXH3, 64 bits.
std::uint64_t hash_of(const void* bytes, std::size_t size);

/// A chain of state hashes: equal exactly when all ticks are. Start from 0 with the hash of the initial state.
std::uint64_t chained_hash(std::uint64_t chain, std::uint64_t state);

}  // namespace proofreel
