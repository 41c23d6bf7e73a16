#pragma once

/// Motion blur: what a film sees while its shutter is open.

#include <cstdint>
#include <vector>

#include "render/image.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// How many ticks the shutter stays open at each frame of `timeline` (film_timeline), from the frame's own tick on: for
/// `degrees` / 360 of the way to the next frame's tick. Where the film stands still there is no way, and it is 1.
/// Throws UsageError, naming a rate that works, where it would be open for fewer than four ticks: so few pictures do
/// not run together but stand beside each other.
std::vector<std::int64_t> exposures(const Scenario& scenario, const std::vector<std::int64_t>& timeline,
                                    double degrees);

/// The mean of pictures as light, not as numbers in a file: two half exposures add up to what one whole would show.
/// Sums are integers, so that the mean is the same on every machine and in any order of the pictures.
class Exposure {
 public:
  /// Pictures of one size, at most 65536 of them; alpha is not looked at.
  void add(const Image& image);
  /// The mean, opaque; and begins anew. One picture, or several alike, come out as they went in.
  void develop(Image& image);

 private:
  std::vector<std::uint32_t> sums_;  ///< red, green, blue, of all pixels
  std::uint32_t pictures_ = 0;
};

}  // namespace proofreel
