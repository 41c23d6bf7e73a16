#include "golden/observe.h"

#include <algorithm>

#include "golden/hex.h"
#include "scenarios/timeline.h"

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

/// The first of several panes has no number added to its bodies' ids, the next pane_stride, and so on.
void add_poses(const Scenario& pane, const Snapshot& snapshot, std::uint32_t added, std::vector<BodyPose>& poses) {
  const std::string prefix = pane.pane_title.empty() ? "" : pane.pane_title + ": ";
  for (const BodyView& body : snapshot.bodies) {
    const auto id = static_cast<std::uint32_t>(body.id);
    const bool named = id >= 1 && id <= pane.body_names.size();
    poses.push_back({id + added, named ? prefix + pane.body_names[id - 1] : std::string(), body.state.position.x,
                     body.state.position.y, body.state.angle});
  }
}

std::vector<BodyPose> poses_of(const Scenario& scenario, const Frame& frame) {
  std::vector<BodyPose> poses;
  add_poses(scenario, frame.snapshot, 0, poses);
  for (std::size_t i = 0; i < frame.other_panes.size(); ++i) {
    add_poses(*scenario.other_panes[i], frame.other_panes[i].snapshot, static_cast<std::uint32_t>(i + 1) * pane_stride,
              poses);
  }
  return poses;
}

bool touches(const ContactView& contact) {
  return std::any_of(contact.points, contact.points + contact.point_count,
                     [](const ContactPoint& point) { return point.touching(); });
}

void add_touching(const Snapshot& snapshot, std::uint32_t added, std::vector<Touch>& touching) {
  for (const ContactView& contact : snapshot.contacts) {
    const auto a = static_cast<std::uint32_t>(contact.a), b = static_cast<std::uint32_t>(contact.b);
    if (touches(contact)) touching.push_back({std::min(a, b) + added, std::max(a, b) + added});
  }
}

std::vector<Touch> touching_in(const Frame& frame) {
  std::vector<Touch> touching;
  add_touching(frame.snapshot, 0, touching);
  for (std::size_t i = 0; i < frame.other_panes.size(); ++i)
    add_touching(frame.other_panes[i].snapshot, static_cast<std::uint32_t>(i + 1) * pane_stride, touching);
  std::sort(touching.begin(), touching.end());
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  return touching;
}

/// A run that is watched.
class Watched {
 public:
  Watched(Scenario& scenario, const Watch& watch) : scenario_(scenario), watch_(watch), runner_(scenario) { look(); }

  void step_to(std::int64_t tick) {
    while (runner_.tick() < tick) {
      runner_.step();
      look();
    }
  }

  ObservedFrame frame(std::int64_t index) const {
    const Frame frame = runner_.frame(index);
    DrawnPicture picture = watch_.make_picture ? watch_.make_picture(scenario_, frame) : DrawnPicture{};
    ObservedFrame observed{index,
                           hex(runner_.trajectory_hash()),
                           std::move(picture.image),
                           poses_of(scenario_, frame),
                           std::move(picture.hash),
                           touching_in(frame)};
    if (watch_.at_frame) watch_.at_frame(scenario_, frame, observed);
    return observed;
  }

  RunReport finish() {
    return runner_.finish([this] { look(); });
  }

 private:
  void look() {
    if (watch_.ticks == nullptr) return;
    watch_.ticks->record(runner_.simulation(), scenario_.body_names.size(), runner_.trajectory_hash());
  }

  Scenario& scenario_;
  const Watch& watch_;
  Runner runner_;
};

}  // namespace

Observation observe(Scenario& scenario, const Watch& watch) {
  Observation observation;
  const std::vector<std::int64_t> frames = wanted_frames(scenario);
  std::vector<std::int64_t> timeline;
  if (!frames.empty()) timeline = film_timeline(scenario);
  check_frames(scenario, frames, timeline.size());
  Watched run(scenario, watch);
  for (const std::int64_t index : frames) {
    run.step_to(timeline[static_cast<std::size_t>(index)]);
    observation.frames.push_back(run.frame(index));
  }
  observation.report = run.finish();
  observation.final_trajectory_hash = hex(observation.report.trajectory_hash);
  return observation;
}

}  // namespace proofreel
