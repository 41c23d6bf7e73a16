#include "engine/state_hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace proofreel {

std::uint64_t hash_of(const void* bytes, std::size_t size) { return XXH3_64bits(bytes, size); }

Hash128 hash128_of(const void* bytes, std::size_t size, std::uint64_t seed) {
  const XXH128_hash_t hash = XXH3_128bits_withSeed(bytes, size, seed);
  return {hash.high64, hash.low64};
}

std::uint64_t chained_hash(std::uint64_t chain, std::uint64_t state) {
  const std::uint64_t both[2] = {chain, state};
  return hash_of(both, sizeof both);
}

}  // namespace proofreel
