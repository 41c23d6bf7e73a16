#pragma once

/// `run --peer`: another engine in place of ours.

#include <memory>
#include <string>
#include <vector>

#include "cli/run_output.h"
#include "lab/peers/peers.h"

namespace proofreel {

/// "box2d" or "chipmunk". Throws UsageError for other names.
Peer peer_meant(const std::string& name);
/// Each once, in the order of their names.
std::vector<Peer> peers_meant(const std::vector<std::string>& names);

/// What steps a run, and what its report has to say of that.
struct PeerRun {
  Stepper stepper;
  std::unique_ptr<Simulation> simulation;
};

/// The scenario's scene in a peer. Throws UsageError for other names and where `--set` speaks of our engine's method,
/// of which a peer has nothing, and ScenarioError where the peer cannot step the scene.
PeerRun peer_run(const std::string& name, const Scenario& scenario);

}  // namespace proofreel
