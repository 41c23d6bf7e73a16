#include "golden/observe.h"

#include <algorithm>

#include "golden/hex.h"

namespace proofreel {
namespace {

std::vector<std::int64_t> wanted_frames(const Scenario& scenario) {
  if (!scenario.golden) return {};
  std::vector<std::int64_t> frames = scenario.golden->frames;
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

void check_frames(const Scenario& scenario, const std::vector<std::int64_t>& frames, std::size_t film_length) {
  for (const std::int64_t frame : frames) {
    if (frame >= 0 && frame < static_cast<std::int64_t>(film_length)) continue;
    throw ScenarioError(scenario.path + ": golden frame " + std::to_string(frame) +
                        " is not in the film, which has frames 0 to " + std::to_string(film_length - 1) + ".");
  }
}

std::vector<BodyPose> poses_of(const Scenario& scenario, const Snapshot& snapshot) {
  std::vector<BodyPose> poses;
  for (const BodyView& body : snapshot.bodies) {
    const auto id = static_cast<std::uint32_t>(body.id);
    const bool named = id >= 1 && id <= scenario.scene.bodies.size();
    poses.push_back({id, named ? scenario.scene.bodies[id - 1].name : std::string(), body.state.position.x,
                     body.state.position.y, body.state.angle});
  }
  return poses;
}

ObservedFrame look_at(const Scenario& scenario, const Runner& runner, std::int64_t index,
                      const MakePicture& make_picture) {
  const Frame frame = runner.frame(index);
  Image image = make_picture ? make_picture(scenario, frame) : Image{};
  return {index, hex(runner.trajectory_hash()), std::move(image), poses_of(scenario, frame.snapshot)};
}

}  // namespace

Observation observe(Scenario& scenario, const MakePicture& make_picture) {
  Observation observation;
  const std::vector<std::int64_t> frames = wanted_frames(scenario);
  std::vector<std::int64_t> timeline;
  if (!frames.empty()) timeline = film_timeline(scenario);
  check_frames(scenario, frames, timeline.size());
  Runner runner(scenario);
  for (const std::int64_t index : frames) {
    while (runner.tick() < timeline[static_cast<std::size_t>(index)]) runner.step();
    observation.frames.push_back(look_at(scenario, runner, index, make_picture));
  }
  observation.report = runner.finish();
  observation.final_trajectory_hash = hex(observation.report.trajectory_hash);
  return observation;
}

}  // namespace proofreel
