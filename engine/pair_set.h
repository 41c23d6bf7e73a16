#pragma once

/// The set of pairs a broad phase has reported. It is asked for every pair of boxes found overlapping, most of which
/// are in it, so it is one flat table with open addressing: one look into memory instead of the several of
/// std::unordered_set. It cannot be iterated, so its order matters to nothing.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace proofreel {

class PairSet {
 public:
  /// Puts the pair (a, b), a < b, into the set. Returns false when it was there already.
  bool insert(std::uint32_t a, std::uint32_t b);
  void erase(std::uint32_t a, std::uint32_t b);
  bool contains(std::uint32_t a, std::uint32_t b) const;
  std::size_t size() const { return size_; }
  /// For archives (archive.h): the pairs, in whatever order they lie.
  template <typename Archive, typename Self>
  static void exchange(Archive& archive, Self& set) {
    std::vector<std::uint64_t> keys;
    for (const std::uint64_t key : set.slots_) {
      if (key != empty) keys.push_back(key);
    }
    archive(keys);
    if constexpr (Archive::reads) {
      set = PairSet();
      for (const std::uint64_t key : keys) {
        if (key == empty) archive.spoil();
        if (key != empty) set.insert(static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key));
      }
    }
  }

 private:
  std::size_t home_of(std::uint64_t key) const;
  std::size_t slot_of(std::uint64_t key) const;
  void grow();

  static constexpr std::uint64_t empty = 0;  ///< no pair: a < b makes every key at least 1
  std::vector<std::uint64_t> slots_ = std::vector<std::uint64_t>(16, empty);  ///< a power of two, at most half full
  std::size_t size_ = 0;
};

}  // namespace proofreel
