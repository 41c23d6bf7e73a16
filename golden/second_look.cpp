#include "golden/second_look.h"

#include <algorithm>

#include "golden/words.h"

namespace proofreel {
namespace {

bool has_other_state(const Finding& finding) {
  return finding.verdict == Verdict::physics || finding.verdict == Verdict::both;
}

bool has_equal_state(const Finding& finding) { return passes(finding.verdict) || finding.verdict == Verdict::drawing; }

Finding unsteady(std::optional<std::int64_t> frame, const char* what) {
  std::string text("two runs just now differ in their ");
  return {frame, Verdict::nondeterministic, text.append(what).append(", so no reference can hold."), {}};
}

/// What differs between two runs of the same scenario.
std::vector<Finding> differences(const Observation& a, const Observation& b) {
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < std::min(a.frames.size(), b.frames.size()); ++i) {
    const ObservedFrame &first = a.frames[i], &second = b.frames[i];
    if (first.trajectory_hash != second.trajectory_hash)
      findings.push_back(unsteady(first.frame, "state"));
    else if (first.pixel_hash != second.pixel_hash)
      findings.push_back(unsteady(first.frame, "pixels"));
  }
  if (a.final_trajectory_hash != b.final_trajectory_hash) findings.push_back(unsteady(std::nullopt, "final state"));
  return findings;
}

/// Since when the states differ.
class Since {
 public:
  Since(const std::optional<TickTrace>& then, const TickTrace& now, const BodyNames& names) {
    const auto divergence = then ? first_divergence(*then, now, names.largest_id()) : std::nullopt;
    if (!divergence) return;
    tick_ = divergence->tick;
    for (const std::uint32_t body : divergence->bodies) {
      first_.append(first_.empty() ? " (first " : " and ").append(names.of(body));
    }
    if (!first_.empty()) first_.append(")");
  }

  std::optional<std::int64_t> tick() const { return tick_; }
  /// `last_equal`: the golden frame before, which is what is known without fingerprints of the ticks.
  std::string opening(std::optional<std::int64_t> last_equal) const {
    if (tick_) return words({"since tick ", std::to_string(*tick_), first_, ". "});
    return last_equal ? words({"since after frame ", std::to_string(*last_equal), ". "}) : "";
  }

 private:
  std::optional<std::int64_t> tick_;
  std::string first_;
};

std::string closing(const Finding& finding) {
  if (finding.comparison.different == 0) return "";
  if (!finding.causes.empty()) return words({" ", share_explained(finding.causes)});
  return words({" ", count_text(finding.comparison.different), " pixels differ."});
}

/// Frames of the same state whose pixels differ are what proves that the drawing changed.
std::string proof_of_drawing(const std::vector<Finding>& findings) {
  const auto proof =
      std::find_if(findings.begin(), findings.end(), [](const Finding& f) { return f.verdict == Verdict::drawing; });
  if (proof == findings.end() || !proof->frame) return "";
  return words({" The drawing changed as well: frame ", std::to_string(*proof->frame), " shows it in an equal state."});
}

class Completion {
 public:
  Completion(std::vector<Finding>& findings, const Since& since) : findings_(findings), since_(since) {}

  void complete(std::map<std::int64_t, PictureWhy> whys) {
    for (Finding& finding : findings_) {
      const auto why = finding.frame ? whys.find(*finding.frame) : whys.end();
      if (why != whys.end()) finding.causes = std::move(why->second.causes);
      if (has_other_state(finding))
        complete_physics(finding);
      else if (finding.verdict == Verdict::drawing && why != whys.end())
        complete_drawing(finding, why->second.likeness);
      if (finding.frame && has_equal_state(finding)) last_equal_ = finding.frame;
    }
  }

 private:
  void complete_physics(Finding& finding) const {
    finding.since_tick = since_.tick();
    finding.message = words({since_.opening(last_equal_), finding.message, closing(finding)});
    if (finding.verdict == Verdict::both) finding.message += proof_of_drawing(findings_);
  }

  static void complete_drawing(Finding& finding, const std::string& likeness) {
    if (!likeness.empty()) finding.message.append(" ").append(likeness);
    const std::string places = whereabouts(finding.causes);
    if (!places.empty()) finding.message.append(" ").append(places);
  }

  std::vector<Finding>& findings_;
  const Since& since_;
  std::optional<std::int64_t> last_equal_;
};

bool wants_reason(const std::vector<Finding>& findings, std::int64_t frame) {
  return std::any_of(findings.begin(), findings.end(), [frame](const Finding& finding) {
    return finding.frame == frame && !passes(finding.verdict) && finding.comparison.different > 0;
  });
}

/// Of all bodies there ever were in a run, and in the golden frames.
BodyNames names_in(const Scenario& scenario, const Golden& golden) {
  BodyNames names;
  for (std::size_t i = 0; i < scenario.body_names.size(); ++i) {
    names.add({{static_cast<std::uint32_t>(i + 1), scenario.body_names[i], 0, 0, 0}});
  }
  for (const GoldenFrame& frame : golden.frames) names.add(frame.bodies);
  return names;
}

}  // namespace

std::vector<Finding> findings_of_second_run(Scenario& again, const GoldenStore& store, const Golden& golden,
                                            const PictureTools& tools, const Observation& first,
                                            std::vector<Finding> findings) {
  TickRecorder ticks;
  std::map<std::int64_t, PictureWhy> whys;
  const auto explain = [&](const Scenario& scenario, const Frame& frame, ObservedFrame& now) {
    const GoldenFrame* then = find_frame(golden, now.frame);
    if (then != nullptr && tools.explain && wants_reason(findings, now.frame))
      whys[now.frame] = tools.explain(golden, *then, scenario, frame, now);
    now.image.rgba = {};
  };
  const Observation second = observe(again, {tools.make, explain, &ticks});
  std::vector<Finding> unsteady_findings = differences(first, second);
  if (!unsteady_findings.empty()) return unsteady_findings;
  const Since since(store.load_ticks(golden), ticks.trace(), names_in(again, golden));
  Completion(findings, since).complete(std::move(whys));
  return findings;
}

}  // namespace proofreel
