#include "golden/judge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace proofreel {
namespace {

/// What differs between two states, worst first.
struct Movement {
  std::string worst;  ///< the body that moved most, as users know it
  double distance = 0;
  double turn = 0;
  int moved = 0;     ///< bodies whose pose differs
  int appeared = 0;  ///< bodies only there now
  int gone = 0;      ///< bodies only there then
};

std::string title_of(const BodyPose& body) {
  const std::string number = std::to_string(body.id);
  return body.name.empty() ? std::string("body ").append(number)
                           : std::string("\"").append(body.name).append("\" (body ").append(number).append(")");
}

void note(Movement& movement, const BodyPose& then, const BodyPose& now) {
  const double dx = now.x - then.x, dy = now.y - then.y;
  const double distance = std::sqrt(dx * dx + dy * dy), turn = std::fabs(now.angle - then.angle);
  if (distance == 0 && turn == 0) return;
  ++movement.moved;
  if (!movement.worst.empty() && distance <= movement.distance) return;
  movement.worst = title_of(now);
  movement.distance = distance;
  movement.turn = turn;
}

/// Both lists are in order of id.
Movement movement_between(const std::vector<BodyPose>& then, const std::vector<BodyPose>& now) {
  Movement movement;
  auto a = then.begin(), b = now.begin();
  while (a != then.end() || b != now.end()) {
    if (b == now.end() || (a != then.end() && a->id < b->id)) {
      ++movement.gone, ++a;
    } else if (a == then.end() || b->id < a->id) {
      ++movement.appeared, ++b;
    } else {
      note(movement, *a++, *b++);
    }
  }
  return movement;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string sentence_about(const Movement& movement) {
  std::string text;
  if (movement.moved > 0) {
    text.append("; ").append(movement.worst).append(" is ").append(number(movement.distance));
    text.append(" m and ").append(number(movement.turn)).append(" rad away");
    if (movement.moved > 1) text.append(", the most of ").append(std::to_string(movement.moved)).append(" bodies");
  }
  if (movement.appeared > 0) text.append("; ").append(std::to_string(movement.appeared)).append(" bodies are new");
  if (movement.gone > 0) text.append("; ").append(std::to_string(movement.gone)).append(" bodies are gone");
  if (text.empty()) text = "; no body stands elsewhere, so it is velocities or the way there that differ";
  return text;
}

std::string hashes(const std::string& then, const std::string& now) {
  return std::string("trajectory hash ").append(now).append(", golden ").append(then);
}

Finding missing(std::optional<std::int64_t> frame, const char* what) {
  return {frame, Verdict::missing, std::string(what).append("; look at it and run bless."), {}};
}

/// Joins what the state and what the picture say about one frame whose state differs.
Finding physics(const GoldenFrame& then, const ObservedFrame& now, const Finding& picture,
                std::optional<std::int64_t> last_equal) {
  std::string text("the state differs");
  if (last_equal) text.append(" since frame ").append(std::to_string(*last_equal));
  text.append(" (").append(hashes(then.trajectory_hash, now.trajectory_hash)).append(")");
  text.append(sentence_about(movement_between(then.bodies, now.bodies)));
  if (!picture.message.empty()) text.append("; in the picture ").append(picture.message);
  if (text.back() != '.') text.append(".");
  return {now.frame, Verdict::physics, std::move(text), picture.comparison};
}

const GoldenFrame* find(const Golden& golden, std::int64_t frame) {
  for (const GoldenFrame& candidate : golden.frames) {
    if (candidate.frame == frame) return &candidate;
  }
  return nullptr;
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

std::vector<Finding> judge(const std::optional<Golden>& golden, const Observation& now,
                           const JudgePicture& judge_picture) {
  std::vector<Finding> findings;
  if (golden) findings = orphans_in(*golden, now);
  std::optional<std::int64_t> last_equal;
  for (const ObservedFrame& frame : now.frames) {
    const GoldenFrame* then = golden ? find(*golden, frame.frame) : nullptr;
    if (then == nullptr) {
      findings.push_back(missing(frame.frame, "there is no reference for this frame"));
      continue;
    }
    Finding finding = judge_picture ? judge_picture(*golden, *then, frame) : Finding{frame.frame, {}, {}, {}};
    const bool same_state = then->trajectory_hash == frame.trajectory_hash;
    const bool comparable = finding.verdict != Verdict::missing && finding.verdict != Verdict::size;
    if (same_state) last_equal = frame.frame;
    if (!same_state && comparable) finding = physics(*then, frame, finding, last_equal);
    findings.push_back(std::move(finding));
  }
  blame_drawing_too(findings);
  findings.push_back(golden ? judge_end(*golden, now)
                            : missing(std::nullopt, "there is no reference for the final state"));
  return findings;
}

}  // namespace proofreel
