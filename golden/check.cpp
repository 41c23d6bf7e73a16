#include "golden/check.h"

#include <algorithm>

namespace proofreel {
namespace {

bool needs_second_run(const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.verdict == Verdict::physics || finding.verdict == Verdict::drawing ||
           finding.verdict == Verdict::both;
  });
}

Finding unsteady(std::optional<std::int64_t> frame, const char* what) {
  std::string text("two runs just now differ in their ");
  return {frame, Verdict::nondeterministic, text.append(what).append(", so no reference can hold."), {}};
}

/// What differs between two runs of the same scenario.
std::vector<Finding> differences(const Observation& a, const Observation& b) {
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < a.frames.size(); ++i) {
    const ObservedFrame &first = a.frames[i], &second = b.frames[i];
    if (first.trajectory_hash != second.trajectory_hash)
      findings.push_back(unsteady(first.frame, "state"));
    else if (first.image.rgba != second.image.rgba)
      findings.push_back(unsteady(first.frame, "pixels"));
  }
  if (a.final_trajectory_hash != b.final_trajectory_hash) findings.push_back(unsteady(std::nullopt, "final state"));
  return findings;
}

std::optional<Golden> load_or_note(const GoldenStore& store, const std::string& id, std::vector<Finding>& findings) {
  try {
    return store.load(id);
  } catch (const GoldenError& error) {
    findings.push_back({std::nullopt, Verdict::missing, error.what(), {}});
    return std::nullopt;
  }
}

void note_orphan_files(const GoldenStore& store, const Golden& golden, std::vector<Finding>& findings) {
  for (const std::filesystem::path& file : store.orphan_files(golden)) {
    findings.push_back(
        {std::nullopt, Verdict::orphan, file.string() + " belongs to no golden frame; run bless --prune.", {}});
  }
}

std::vector<Finding> findings_on(const GoldenStore& store, const Scenario& scenario, const Observation& now,
                                 const JudgePicture& judge_picture) {
  std::vector<Finding> findings;
  const std::optional<Golden> golden = load_or_note(store, scenario.id, findings);
  if (!findings.empty()) return findings;  // an unreadable golden.json says it all
  if (!golden && !scenario.golden) return findings;
  findings = judge(golden, now, judge_picture);
  if (golden) note_orphan_files(store, *golden, findings);
  return findings;
}

}  // namespace

bool CheckResult::passed() const {
  return std::all_of(findings.begin(), findings.end(), [](const Finding& f) { return passes(f.verdict); }) &&
         std::all_of(expectations.begin(), expectations.end(), [](const ExpectationResult& e) { return e.held; });
}

CheckResult check_scenario(const std::string& path, const std::vector<Override>& overrides, const GoldenStore& store,
                           const MakePicture& make_picture, const JudgePicture& judge_picture) {
  const std::unique_ptr<Scenario> scenario = load_scenario(path, overrides);
  const Observation now = observe(*scenario, make_picture);
  CheckResult result{scenario->id, scenario->warnings, findings_on(store, *scenario, now, judge_picture),
                     now.report.expectations};
  if (!needs_second_run(result.findings)) return result;
  const std::unique_ptr<Scenario> again = load_scenario(path, overrides);
  std::vector<Finding> unsteady_findings = differences(now, observe(*again, make_picture));
  if (!unsteady_findings.empty()) result.findings = std::move(unsteady_findings);
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
