#include "scenarios/saved_run.h"

#include "engine/scene_archive.h"
#include "scenarios/formatted.h"
#include "scenarios/suggest.h"

namespace proofreel {

template <typename Archive, Exchanged<LoggedCommand> T>
void exchange(Archive& archive, T& logged) {
  auto& [tick, heard, command] = logged;
  archive(tick, heard, command);
}

template <typename Archive, Exchanged<SavedExpectation> T>
void exchange(Archive& archive, T& expectation) {
  auto& [held, looked_at, tick, changed_variable] = expectation;
  archive(held, looked_at, tick, changed_variable);
}

template <typename Archive, Exchanged<Override> T>
void exchange(Archive& archive, T& setting) {
  auto& [key, value] = setting;
  archive(key, value);
}

template <typename Archive, Exchanged<SavedRun> T>
void exchange(Archive& archive, T& run) {
  auto& [scenario, source_hash, settings, tick, logged_until, last_trajectory_hash, state, trajectory_hash,
         initial_energy, expectations, changed_variables, made, log] = run;
  std::vector<Override> setting_list;
  for (const auto& [key, value] : settings) setting_list.push_back({key, value});
  archive(scenario, source_hash, setting_list, tick, logged_until, last_trajectory_hash, state, trajectory_hash,
          initial_energy, expectations, changed_variables, made, log);
  if constexpr (Archive::reads) {
    settings.clear();
    for (const Override& setting : setting_list) settings[setting.key] = setting.value;
  }
}

template <>
struct LastOf<std::byte> {
  static constexpr std::byte value{255};
};

namespace {

constexpr Mark mark{'p', 'r', 'o', 'o', 'f', 'r', 'u', 'n'};
/// Changes with every change of what is stored.
constexpr std::uint32_t version = 1;

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw ScenarioError(file + " cannot be resumed: " + why);
}

std::string seconds(std::int64_t tick, int rate) { return formatted("%.6g s", static_cast<double>(tick) / rate); }

/// The duration may be another one: it changes nothing but where the run ends.
std::string in_words(std::map<std::string, std::string> settings) {
  settings.erase("duration");
  std::string words;
  for (const auto& [key, value] : settings) words.append(" --set ").append(key).append("=").append(value);
  return words.empty() ? " no --set" : words;
}

}  // namespace

std::vector<std::byte> bytes_of(const SavedRun& run) {
  ArchiveWriter archive;
  archive(run);
  return sealed(mark, version, archive.bytes());
}

SavedRun saved_run_in(std::span<const std::byte> bytes, const std::string& file) {
  const auto content = unsealed(mark, version, bytes);
  if (const auto* problem = std::get_if<std::string>(&content)) refuse(file, "it " + *problem);
  ArchiveReader archive(std::get<std::span<const std::byte>>(content));
  SavedRun run;
  archive(run);
  if (!archive.ended_well()) refuse(file, "it contradicts itself");
  return run;
}

void check_resumable(const SavedRun& run, const Scenario& scenario, const std::string& file) {
  const int rate = scenario.scene.rate;
  if (run.source_hash != scenario.source_hash) {
    refuse(file, "it was saved from scenario " + quote(run.scenario) +
                     ", whose text is another one than that of this scenario now, or of a file it includes");
  }
  if (in_words(run.settings) != in_words(scenario.settings)) {
    refuse(file, "it was saved with" + in_words(run.settings) + ", and now there is" + in_words(scenario.settings));
  }
  if (run.tick > scenario.ticks()) {
    refuse(file, "it goes on from t=" + seconds(run.tick, rate) +
                     ", after the end of this run at t=" + seconds(scenario.ticks(), rate));
  }
  if (run.logged_until < scenario.ticks() && scenario.script->has_callbacks()) {
    refuse(file, "callbacks were not logged beyond t=" + seconds(run.logged_until, rate) + ", and this run ends at t=" +
                     seconds(scenario.ticks(), rate) + "; save it again from a run that goes as far");
  }
  const bool fits = run.expectations.size() == scenario.expectations.size() &&
                    run.changed_variables.size() == scenario.measures.size() && run.tick >= 0;
  if (!fits) refuse(file, "it contradicts itself");
}

}  // namespace proofreel
