#pragma once

/// Rows of two pictures held side by side, in loops the compiler turns into vector instructions: no branch depends on a
/// pixel. Rows are RGBA8.

#include <array>
#include <cstdint>

namespace proofreel {

/// What one row adds to a comparison.
struct RowSums {
  std::int64_t different = 0;          ///< pixels that are not equal
  std::int64_t beyond = 0;             ///< pixels with a channel that differs by more than was allowed
  int max_channel = 0;                 ///< the largest difference of one channel
  std::array<std::int64_t, 4> bias{};  ///< B - A summed, per channel
};
RowSums sums_of_row(const std::uint8_t* a, const std::uint8_t* b, int width_px, int allowed);

/// What is known of a pixel without the exact formula.
enum RowMark : std::uint8_t { equal_pixel = 0, close_pixel = 1, candidate_pixel = 2 };

/// Marks pixels as equal; as certainly closer than the YIQ distance `least`; or as candidates that may reach it. Single
/// precision finds the few that are worth the exact formula (golden/yiq.h). Translucent pixels that differ are always
/// candidates.
void mark_row(const std::uint8_t* a, const std::uint8_t* b, int width_px, double least, std::uint8_t* marks);

}  // namespace proofreel
