#include "engine/pair_set.h"

#include <bit>

namespace proofreel {
namespace {

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) { return static_cast<std::uint64_t>(a) << 32 | b; }

}  // namespace

/// Fibonacci hashing (Knuth, volume 3, 6.4): the top bits of the key times the golden ratio.
std::size_t PairSet::home_of(std::uint64_t key) const {
  const int bits = std::countr_zero(slots_.size());
  return static_cast<std::size_t>((key ^ key >> 32) * 0x9e3779b97f4a7c15U >> (64 - bits));
}

/// Where the key lies, or the empty slot where it would have to.
std::size_t PairSet::slot_of(std::uint64_t key) const {
  const std::size_t last = slots_.size() - 1;
  std::size_t slot = home_of(key);
  while (slots_[slot] != key && slots_[slot] != empty) slot = (slot + 1) & last;
  return slot;
}

bool PairSet::contains(std::uint32_t a, std::uint32_t b) const { return slots_[slot_of(key_of(a, b))] != empty; }

bool PairSet::insert(std::uint32_t a, std::uint32_t b) {
  const std::uint64_t key = key_of(a, b);
  const std::size_t slot = slot_of(key);
  if (slots_[slot] != empty) return false;
  slots_[slot] = key;
  if (2 * ++size_ > slots_.size()) grow();
  return true;
}

/// Leaves no gap that would hide a pair further on: whoever may lie nearer to its home moves up.
void PairSet::erase(std::uint32_t a, std::uint32_t b) {
  const std::size_t last = slots_.size() - 1;
  std::size_t gap = slot_of(key_of(a, b));
  if (slots_[gap] == empty) return;
  --size_;
  for (std::size_t slot = (gap + 1) & last; slots_[slot] != empty; slot = (slot + 1) & last) {
    const std::size_t way_from_home = (slot - home_of(slots_[slot])) & last;
    if (way_from_home < ((slot - gap) & last)) continue;
    slots_[gap] = slots_[slot];
    gap = slot;
  }
  slots_[gap] = empty;
}

void PairSet::grow() {
  std::vector<std::uint64_t> old(2 * slots_.size(), empty);
  old.swap(slots_);
  for (const std::uint64_t key : old) {
    if (key != empty) slots_[slot_of(key)] = key;
  }
}

}  // namespace proofreel
