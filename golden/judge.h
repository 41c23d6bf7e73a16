#pragma once

/// Holds what comes out now against what was kept, and says in words what differs.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "golden/compare.h"
#include "golden/observe.h"
#include "golden/store.h"
#include "golden/why.h"

namespace proofreel {

enum class Verdict : std::uint8_t {
  exact,             ///< same state, same pixels
  tolerated,         ///< same state, pixels within the tolerance
  physics,           ///< the state differs
  drawing,           ///< same state, other pixels
  both,              ///< the state differs, and where it does not the pixels do
  missing,           ///< no usable reference
  size,              ///< the picture's size differs
  orphan,            ///< a reference no scenario asks for
  nondeterministic,  ///< two runs of today differ
};
const char* name_of(Verdict verdict);
inline bool passes(Verdict verdict) { return verdict == Verdict::exact || verdict == Verdict::tolerated; }

/// What is said of one frame, or of the final tick.
struct Finding {
  std::optional<std::int64_t> frame;  ///< nothing: the final tick, or a file
  Verdict verdict = Verdict::exact;
  std::string message;                                    ///< a sentence with the figures; empty when exact
  Comparison comparison;                                  ///< filled where pixels were compared
  std::optional<std::int64_t> since_tick = std::nullopt;  ///< the first whose state differs, where that is known
  std::vector<Cause> causes = {};                         ///< of the pixels that differ
  std::filesystem::path expected{};  ///< the reference picture, where there is one that can be used
  Image actual{};                    ///< today's picture, where it did not pass
};

/// How the picture of one frame compares with its reference: exact, tolerated, drawing, size or missing. An empty
/// function: pictures are left out.
using JudgePicture = std::function<Finding(const Golden&, const GoldenFrame&, const ObservedFrame&)>;

/// One finding per golden frame and one for the final tick. Without a golden, all are missing.
std::vector<Finding> judge(const std::optional<Golden>& golden, const Observation& now,
                           const JudgePicture& judge_picture);

/// The reference of a frame, or null.
const GoldenFrame* find_frame(const Golden& golden, std::int64_t frame);

}  // namespace proofreel
