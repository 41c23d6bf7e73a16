#pragma once

/// Other engines behind our own interface, so that a scene can be stepped by them, drawn by our renderer and measured
/// by the same measures. Each runs at its declared defaults, scaled to metres where it thinks in pixels:
///
/// | peer       | step                             | known limits                                                 |
/// |------------|----------------------------------|--------------------------------------------------------------|
/// | Box2D 2.4  | single precision; 8 velocity and | 8 corners (larger polygons are cut), no capsules (box and 2  |
/// |            | 3 position iterations            | discs), polygons wear a skin of 1 cm, which keeps them up to |
/// |            |                                  | 1.5 cm apart, no more than 2 m per step, nothing slower than |
/// |            |                                  | 1 m/s bounces                                                |
/// | Chipmunk 7 | double precision; 10 iterations, | nothing continuous: what is fast passes through what is      |
/// |            | collision slop 5 mm              | thin; Debian builds it with its assertions                   |
///
/// A tick is one step of the peer: 60 per second is what both are made for, so give the scene a `rate` of 60. Of the
/// scene's method nothing counts. Nothing sleeps, since in our engine nothing does. Coefficients mix by our rules:
/// friction sqrt(a b), restitution max(a, b). Drag, wind, attractors, gravitation among bodies and force fields, which
/// the peers do not know, act as forces at the velocities and places before each step, as their users would do it.
/// Snapshots have bodies, shapes, contacts and joints, but no tree. `Energy::booked_work` knows what commands do at
/// once; what forces, kinematic bodies and motors do during a step no peer tells.
///
/// The same scene gives the same bits in every run of one program on one machine; that is all peers promise.

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/simulation.h"

namespace proofreel {

enum class Peer : std::uint8_t { box2d, chipmunk };

/// How hard a peer tries. `accurate` is our declared choice, the same for every scene: Box2D with 64 velocity and 24
/// position iterations, Chipmunk with 100 iterations; all else as in `standard`, which is what the table says.
enum class PeerPreset : std::uint8_t { standard, accurate };

/// "Box2D", "Chipmunk".
const char* name_of(Peer peer);
/// By the names of the command line, "box2d" and "chipmunk".
std::optional<Peer> peer_named(std::string_view name);

/// What a report has to say of who stepped, so that nobody takes it for our engine.
struct PeerFacts {
  std::string version;  ///< of the library, as it says itself: "7.0.3"
  Precision precision = Precision::float64;
  std::vector<std::pair<std::string, std::variant<int, double>>> settings;  ///< its method, in SI units
};
PeerFacts facts_of(Peer peer, PeerPreset preset = PeerPreset::standard);

/// Why a peer cannot step the scene, as a sentence that names the body or joint; nothing when it can.
std::optional<std::string> problem_for_peer(Peer peer, const Scene& scene);

/// A command asks a peer for what it does not offer; the message is a sentence.
struct UnknownToPeer : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The peer with the scene in it. Throws UnknownToPeer where `problem_for_peer` finds something; so does `apply`.
std::unique_ptr<Simulation> make_peer(Peer peer, const Scene& scene, PeerPreset preset = PeerPreset::standard);

}  // namespace proofreel
