#include "cli/saved_files.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "golden/file_text.h"
#include "lab/csv.h"
#include "render/output_file.h"
#include "render/usage_error.h"
#include "scenarios/timeline.h"

namespace proofreel {
namespace {

SaveTarget target_of(const std::string& option, const Scenario& scenario) {
  const std::size_t colon = std::min(option.find(':'), option.size());
  const std::optional<double> seconds = number_in(option.substr(0, colon));
  const std::string file = option.substr(std::min(colon + 1, option.size()));
  if (!seconds || !std::isfinite(*seconds) || *seconds < 0 || file.empty())
    throw UsageError("--save takes T:FILE, such as 2.5:pyramid.run with seconds of scene time, not \"" + option +
                     "\".");
  const SaveTarget target{tick_at(*seconds, scenario.scene.rate), file};
  if (target.tick <= scenario.ticks()) return target;
  throw UsageError("--save " + option + ": the run ends before that; give a time within it, or a longer duration.");
}

}  // namespace

std::vector<SaveTarget> save_targets(const std::vector<std::string>& options, const Scenario& scenario) {
  std::vector<SaveTarget> targets;
  for (const std::string& option : options) {
    targets.push_back(target_of(option, scenario));
    const SaveTarget& last = targets.back();
    const auto same_file = [&](const SaveTarget& target) { return target.file == last.file; };
    if (std::count_if(targets.begin(), targets.end(), same_file) > 1)
      throw UsageError("--save names the file " + last.file + " twice; give every time a file of its own.");
    OutputFile probe(last.file);  // so that a long run does not end in vain
  }
  return targets;
}

void write_saved(const std::vector<SaveTarget>& targets, const Runner& runner) {
  for (const SaveTarget& target : targets) {
    const std::vector<std::byte> bytes = bytes_of(runner.saved(target.tick));
    write_file(target.file, {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  }
}

SavedRun read_saved(const std::string& file) {
  const std::optional<std::string> text = file_text(file);
  if (!text) throw ScenarioError(file + " cannot be resumed: there is no such file, or it cannot be read");
  return saved_run_in(std::as_bytes(std::span(*text)), file);
}

}  // namespace proofreel
