#include "golden/check.h"

#include <algorithm>
#include <map>

namespace proofreel {
namespace {

bool needs_second_run(const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.verdict == Verdict::physics || finding.verdict == Verdict::drawing ||
           finding.verdict == Verdict::both;
  });
}

std::optional<Golden> load_or_note(const GoldenStore& store, const std::string& id, std::vector<Finding>& findings) {
  try {
    return store.load(id);
  } catch (const GoldenError& error) {
    const std::string advice = " Take it from the repository, or run bless.";
    findings.push_back({std::nullopt, Verdict::missing, error.what() + advice, {}});
    return std::nullopt;
  }
}

void note_orphan_files(const GoldenStore& store, const Golden& golden, std::vector<Finding>& findings) {
  for (const std::filesystem::path& file : store.orphan_files(golden)) {
    findings.push_back(
        {std::nullopt, Verdict::orphan, file.string() + " belongs to no golden frame; run bless --prune.", {}});
  }
}

/// So that people can see what is spoken of.
void add_pictures(const GoldenStore& store, const Golden& golden, const Observation& now, Finding& finding) {
  const auto is_it = [&finding](const auto& frame) { return frame.frame == finding.frame; };
  const auto then = std::find_if(golden.frames.begin(), golden.frames.end(), is_it);
  const auto seen = std::find_if(now.frames.begin(), now.frames.end(), is_it);
  if (seen != now.frames.end() && !passes(finding.verdict)) finding.actual = seen->image;
  if (then != golden.frames.end() && finding.verdict != Verdict::missing) {
    finding.expected = store.folder(golden.scenario) / then->file;
  }
}

/// Judges pictures as they come, and lets go of those that pass, so that a thousand of them take no memory.
class PictureJudge {
 public:
  PictureJudge(const std::optional<Golden>& golden, const JudgePicture& judge) : golden_(golden), judge_(judge) {}

  void look(ObservedFrame& now) {
    const GoldenFrame* then = golden_ ? find_frame(*golden_, now.frame) : nullptr;
    if (then == nullptr || !judge_) return;
    const Finding& finding = findings_[now.frame] = judge_(*golden_, *then, now);
    if (passes(finding.verdict)) now.image.rgba = {};
  }

  JudgePicture judged() const {
    if (!judge_) return {};
    return [this](const Golden&, const GoldenFrame&, const ObservedFrame& now) { return findings_.at(now.frame); };
  }

 private:
  const std::optional<Golden>& golden_;
  const JudgePicture& judge_;
  std::map<std::int64_t, Finding> findings_;
};

}  // namespace

bool CheckResult::passed() const {
  return std::all_of(findings.begin(), findings.end(), [](const Finding& f) { return passes(f.verdict); }) &&
         std::all_of(expectations.begin(), expectations.end(), [](const ExpectationResult& e) { return e.held; });
}

CheckResult check_scenario(const std::string& path, const std::vector<Override>& overrides, const GoldenStore& store,
                           const PictureTools& tools) {
  const std::unique_ptr<Scenario> scenario = load_scenario(path, overrides);
  CheckResult result{scenario->id, {}, {}, {}};
  const std::optional<Golden> golden = load_or_note(store, scenario->id, result.findings);
  const bool unreadable = !result.findings.empty();
  PictureJudge pictures(golden, tools.judge);
  const auto look = [&pictures](const Scenario&, const Frame&, ObservedFrame& now) { pictures.look(now); };
  const Observation now = observe(*scenario, {tools.make, look, nullptr});
  result.warnings = scenario->warnings;
  result.expectations = now.report.expectations;
  if (unreadable || (!golden && !scenario->golden)) return result;
  result.findings = judge(golden, now, pictures.judged());
  if (needs_second_run(result.findings)) {
    const std::unique_ptr<Scenario> again = load_scenario(path, overrides);
    result.findings = findings_of_second_run(*again, store, *golden, tools, now, std::move(result.findings));
  }
  if (tools.judge) {
    for (Finding& finding : result.findings) add_pictures(store, golden.value_or(Golden{}), now, finding);
  }
  if (golden) note_orphan_files(store, *golden, result.findings);
  return result;
}

std::vector<std::string> orphan_ids(const GoldenStore& store, const std::vector<std::string>& scenarios) {
  std::vector<std::string> orphans;
  for (const std::string& id : store.ids()) {
    if (!std::binary_search(scenarios.begin(), scenarios.end(), id)) orphans.push_back(id);
  }
  return orphans;
}

}  // namespace proofreel
