#pragma once

#include <cstdint>
#include <string>

namespace proofreel {

/// A hash as people and JSON see it: 16 hex digits, because JSON numbers do not hold 64 bits.
std::string hex(std::uint64_t hash);

}  // namespace proofreel
