#include "golden/judge.h"

#include <algorithm>

#include "golden/words.h"

namespace proofreel {
namespace {

std::string hashes(const std::string& then, const std::string& now) {
  return std::string("trajectory hash ").append(now).append(", golden ").append(then);
}

Finding missing(std::optional<std::int64_t> frame, const char* what) {
  return {frame, Verdict::missing, std::string(what).append("; look at it and run bless."), {}};
}

/// The golden frame that shows the state of this one, when it is another: frames have changed places.
std::string whose_state(const Golden& golden, const ObservedFrame& now) {
  const auto is_its = [&now](const GoldenFrame& frame) { return frame.trajectory_hash == now.trajectory_hash; };
  const auto found = std::find_if(golden.frames.begin(), golden.frames.end(), is_its);
  if (found == golden.frames.end()) return "";
  return words({"its state is that of golden frame ", std::to_string(found->frame), "; "});
}

/// What is said of one frame whose state differs, and of its picture.
Finding physics(const Golden& golden, const GoldenFrame& then, const ObservedFrame& now, const Finding& picture) {
  BodyNames names;
  names.add(now.bodies);
  names.add(then.bodies);
  std::string text = words({whose_state(golden, now), sentence_about(change_between(then, now), names), "."});
  if (picture.comparison.different == 0 && now.image.width_px > 0) text.append(" The picture is the same.");
  return {now.frame, Verdict::physics, std::move(text), picture.comparison};
}

/// Pixels that differ where the state is equal prove that the drawing changed; then it is part of every frame that
/// differs in its pixels.
void blame_drawing_too(std::vector<Finding>& findings) {
  const auto drawn_otherwise = [](const Finding& f) { return f.verdict == Verdict::drawing; };
  if (std::none_of(findings.begin(), findings.end(), drawn_otherwise)) return;
  for (Finding& finding : findings) {
    if (finding.verdict == Verdict::physics && finding.comparison.different > 0) finding.verdict = Verdict::both;
  }
}

std::vector<Finding> orphans_in(const Golden& golden, const Observation& now) {
  std::vector<Finding> findings;
  for (const GoldenFrame& kept : golden.frames) {
    const auto is_it = [&kept](const ObservedFrame& frame) { return frame.frame == kept.frame; };
    if (std::any_of(now.frames.begin(), now.frames.end(), is_it)) continue;
    findings.push_back(
        {kept.frame, Verdict::orphan, "the scenario does not ask for this frame any more; run bless.", {}});
  }
  return findings;
}

Finding judge_end(const Golden& golden, const Observation& now) {
  if (golden.final_trajectory_hash == now.final_trajectory_hash && golden.ticks == now.report.ticks) return {};
  std::string text("the state differs at the end");
  if (golden.ticks != now.report.ticks) {
    text.append(", after ").append(std::to_string(now.report.ticks)).append(" ticks instead of ");
    text.append(std::to_string(golden.ticks));
  }
  text.append(" (").append(hashes(golden.final_trajectory_hash, now.final_trajectory_hash)).append(").");
  return {std::nullopt, Verdict::physics, std::move(text), {}};
}

}  // namespace

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::exact:
      return "exact";
    case Verdict::tolerated:
      return "tolerated";
    case Verdict::physics:
      return "physics";
    case Verdict::drawing:
      return "drawing";
    case Verdict::both:
      return "both";
    case Verdict::missing:
      return "missing";
    case Verdict::size:
      return "size";
    case Verdict::orphan:
      return "orphan";
    case Verdict::nondeterministic:
      return "nondeterministic";
  }
  return "";
}

const GoldenFrame* find_frame(const Golden& golden, std::int64_t frame) {
  for (const GoldenFrame& candidate : golden.frames) {
    if (candidate.frame == frame) return &candidate;
  }
  return nullptr;
}

std::vector<Finding> judge(const std::optional<Golden>& golden, const Observation& now,
                           const JudgePicture& judge_picture) {
  std::vector<Finding> findings;
  if (golden) findings = orphans_in(*golden, now);
  for (const ObservedFrame& frame : now.frames) {
    const GoldenFrame* then = golden ? find_frame(*golden, frame.frame) : nullptr;
    if (then == nullptr) {
      findings.push_back(missing(frame.frame, "there is no reference for this frame"));
      continue;
    }
    Finding finding = judge_picture ? judge_picture(*golden, *then, frame) : Finding{frame.frame, {}, {}, {}};
    const bool same_state = then->trajectory_hash == frame.trajectory_hash;
    const bool comparable = finding.verdict != Verdict::missing && finding.verdict != Verdict::size;
    if (!same_state && comparable) finding = physics(*golden, *then, frame, finding);
    findings.push_back(std::move(finding));
  }
  blame_drawing_too(findings);
  findings.push_back(golden ? judge_end(*golden, now)
                            : missing(std::nullopt, "there is no reference for the final state"));
  return findings;
}

}  // namespace proofreel
