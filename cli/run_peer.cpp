#include "cli/run_peer.h"

#include <unistd.h>

#include <csignal>
#include <set>
#include <string_view>

#include "render/usage_error.h"

namespace proofreel {
namespace {

void refuse_settings_of_method(Peer peer, const Scenario& scenario) {
  for (const auto& [key, value] : scenario.settings) {
    if (!key.starts_with("method.")) continue;
    throw UsageError("--set " + key + "=" + value + " says how our own engine steps, and " + name_of(peer) +
                     " has a method of its own: leave out either this or --peer.");
  }
}

/// Debian's Chipmunk is built with its assertions: where one does not hold it says which, and ends the program. That is
/// no better and no worse than a motion that became infinite, and ends with the same status.
void give_up(int) {
  constexpr std::string_view sentence = "The peer cannot step this scene any further, for the reason above.\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, sentence.data(), sentence.size());
  ::_exit(2);
}

Stepper stepper_of(Peer peer, const Scene& scene) {
  const PeerFacts facts = facts_of(peer);
  Json settings{{"steps_per_second", scene.rate},
                {"precision", facts.precision == Precision::float32 ? "single" : "double"}};
  for (const auto& [name, value] : facts.settings) {
    settings[name] = std::visit([](auto number) { return Json(number); }, value);
  }
  return {name_of(peer), facts.version, settings};
}

}  // namespace

Peer peer_meant(const std::string& name) {
  if (const std::optional<Peer> peer = peer_named(name)) return *peer;
  throw UsageError("There is no peer \"" + name + "\": known are \"box2d\" and \"chipmunk\".");
}

std::vector<Peer> peers_meant(const std::vector<std::string>& names) {
  std::set<Peer> peers;
  for (const std::string& name : names) peers.insert(peer_meant(name));
  return {peers.begin(), peers.end()};
}

PeerRun peer_run(const std::string& name, const Scenario& scenario) {
  const Peer peer = peer_meant(name);
  refuse_settings_of_method(peer, scenario);
  std::signal(SIGABRT, give_up);
  try {
    return {stepper_of(peer, scenario.scene), make_peer(peer, scenario.scene)};
  } catch (const UnknownToPeer& problem) {
    throw ScenarioError(scenario.path + ": " + problem.what());
  }
}

}  // namespace proofreel
