#pragma once

/// Fingerprints of every tick of a run, so small that they can be kept with the goldens: they tell at which tick
/// another run left it, and which body was the first to leave.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/simulation.h"

namespace proofreel {

/// Per tick a piece of the trajectory hash, which finds the tick: it differs from the first tick on that differs, but
/// for one in 65536. Beside it four sums over the bodies, S_k = sum of h_i i^k modulo 65521, of a fingerprint h_i of
/// body i's motion; they find one or two bodies (as in the decoding of Peterson, 1960, "Encoding and error-correction
/// procedures for the Bose-Chaudhuri codes"). A scene of a single body needs no sums.
struct TickTrace {
  static constexpr std::size_t sums = 4;

  std::vector<std::uint16_t> pieces;     ///< by tick, from 0 on
  std::vector<std::uint16_t> body_sums;  ///< S_0 to S_3 of each tick; empty where there never was more than one body
  friend bool operator==(const TickTrace&, const TickTrace&) = default;
};

/// Collects a trace while a run goes on.
class TickRecorder {
 public:
  /// At tick 0 and after every tick. Bodies have the ids 1 to `bodies`; those that are gone are left out.
  void record(const Simulation& simulation, std::size_t bodies, std::uint64_t trajectory_hash);
  TickTrace trace() const;

 private:
  TickTrace trace_;
  std::size_t most_bodies_ = 0;
};

/// Where two runs part.
struct Divergence {
  std::int64_t tick = 0;
  std::vector<std::uint32_t> bodies;  ///< ids of the first to differ; empty when there were more than two
};

/// Nothing when no tick differs that both have. `bodies`: ids go from 1 to this.
std::optional<Divergence> first_divergence(const TickTrace& then, const TickTrace& now, std::size_t bodies);

/// As the bytes of a file, and back; nothing when they are no trace.
std::vector<std::uint8_t> bytes_of(const TickTrace& trace);
std::optional<TickTrace> tick_trace_from(std::span<const std::uint8_t> bytes);

}  // namespace proofreel
