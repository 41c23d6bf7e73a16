#include "lab/peers/peers.h"

#include "lab/peers/box2d_world.h"
#include "lab/peers/chipmunk_world.h"
#include "lab/peers/peer_problems.h"
#include "lab/peers/peer_simulation.h"

namespace proofreel {
namespace {

const char* name_of(JointKind kind) {
  switch (kind) {
    case JointKind::revolute:
      return "revolute";
    case JointKind::distance:
      return "distance";
    case JointKind::spring:
      return "spring";
    case JointKind::rope:
      return "rope";
    case JointKind::prismatic:
      return "prismatic";
    case JointKind::weld:
      return "weld";
    case JointKind::wheel:
      return "wheel";
    case JointKind::gear:
      return "gear";
    case JointKind::pulley:
      return "pulley";
    case JointKind::drag_to:
      return "drag_to";
    case JointKind::motor:
      return "motor";
  }
  return "";
}

std::string does_not_know(Peer peer) { return std::string(", which ") + name_of(peer) + " does not know"; }

/// Peers have no switches for effects: a list must hold all that the scene calls for.
Problem problem_with_effects(Peer peer, const Scene& scene) {
  if (!scene.effects) return {};
  Scene inferring = scene;
  inferring.effects.reset();
  const EffectSet called_for = effects_of(inferring);
  for (int i = 0; i < effect_count; ++i) {
    const auto effect = static_cast<Effect>(i);
    if (effect == Effect::ccd || !called_for.has(effect) || scene.effects->has(effect)) continue;
    return std::string("The list of effects leaves out ") + name_of(effect) + ", which the scene calls for and " +
           name_of(peer) + " cannot leave out: add it or take effects=\"auto\"";
  }
  return {};
}

Problem problem_with_forces(Peer peer, const Scene& scene) {
  if (scene.water) return std::string("The scene has water") + does_not_know(peer);
  if (!scene.rockets.empty()) return std::string("The scene has a rocket") + does_not_know(peer);
  if (effects_of(scene).has(Effect::sleeping))
    return std::string("The scene lets bodies sleep, which ") + name_of(peer) + " is not let do here";
  return {};
}

}  // namespace

const char* name_of(Peer peer) { return peer == Peer::box2d ? "Box2D" : "Chipmunk"; }

std::optional<Peer> peer_named(std::string_view name) {
  if (name == "box2d") return Peer::box2d;
  if (name == "chipmunk") return Peer::chipmunk;
  return std::nullopt;
}

PeerFacts facts_of(Peer peer, PeerPreset preset) {
  return peer == Peer::box2d ? box2d_facts(preset) : chipmunk_facts(preset);
}

std::string sentence(Peer peer, const BodyDef& body, std::size_t number, const std::string& clause) {
  const std::string called = body.name.empty() ? std::to_string(number) : '"' + body.name + '"';
  return std::string(name_of(peer)) + " cannot step body " + called + ": " + clause;
}

std::string sentence(Peer peer, const JointDef& joint, std::size_t number, const std::string& clause) {
  return std::string(name_of(peer)) + " cannot step joint " + std::to_string(number) + " (" + name_of(joint.kind) +
         "): " + clause;
}

Problem problem_with(Peer peer, const BodyDef& body) {
  for (const ShapeDef& shape : body.shapes) {
    if (shape.rolling_resistance > 0) return "it has rolling resistance" + does_not_know(peer);
    if (shape.friction.at_rest != shape.friction.sliding) {
      return "its friction at rest and in sliding differ" + does_not_know(peer) + "; give it one coefficient";
    }
  }
  return peer == Peer::box2d ? problem_for_box2d(body) : problem_for_chipmunk(body);
}

Problem problem_with(Peer peer, const JointDef& joint) {
  if (joint.kind == JointKind::drag_to || joint.kind == JointKind::motor) {
    return "it is a " + std::string(name_of(joint.kind)) + does_not_know(peer);
  }
  return peer == Peer::box2d ? problem_for_box2d(joint) : problem_for_chipmunk(joint);
}

std::optional<std::string> problem_for_peer(Peer peer, const Scene& scene) {
  if (const Problem problem = problem_with_effects(peer, scene)) return problem;
  if (const Problem problem = problem_with_forces(peer, scene)) return problem;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Problem problem = problem_with(peer, scene.bodies[i]);
    if (problem) return sentence(peer, scene.bodies[i], i + 1, *problem);
  }
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const Problem problem = problem_with(peer, scene.joints[i]);
    if (problem) return sentence(peer, scene.joints[i], i, *problem);
  }
  return {};
}

std::unique_ptr<Simulation> make_peer(Peer peer, const Scene& scene, PeerPreset preset) {
  if (const Problem problem = problem_for_peer(peer, scene)) throw UnknownToPeer(*problem);
  return std::make_unique<PeerSimulation>(
      peer, scene,
      peer == Peer::box2d ? make_box2d_world(scene.gravity, preset) : make_chipmunk_world(scene.gravity, preset));
}

}  // namespace proofreel
