#include "scenarios/recorder.h"

#include <algorithm>

#include "scenarios/timeline.h"

namespace proofreel {
namespace {

constexpr std::int64_t most_trail_points = 2048;  // finer would not show
constexpr std::size_t most_ghosts = 1000;         // of one body; more would be a smear

/// What leaves the trail: the centre of mass, or a point of the body.
Vec2d traced(const TrailMark& mark, const BodyState& state) {
  return mark.point ? to_world(Posed(state.position, Rotd(state.angle)), *mark.point) : state.center;
}

}  // namespace

void Recorder::record(const Simulation& simulation) {
  const Picture& picture = scenario_.picture;
  trails_.resize(picture.trails.size());
  for (std::size_t i = 0; i < trails_.size(); ++i) record_trail(i, simulation);
  ghosts_.resize(picture.ghosts.size());
  for (std::size_t i = 0; i < ghosts_.size(); ++i) record_ghost(i, simulation);
  followed_.resize(picture.camera.size());
  for (std::size_t i = 0; i < followed_.size(); ++i) {
    const auto& body = picture.camera[i].follow;
    if (body && simulation.exists(*body)) followed_[i] = simulation.body(*body).center;
  }
}

void Recorder::record_trail(std::size_t index, const Simulation& simulation) {
  const TrailMark& mark = scenario_.picture.trails[index];
  Trail& trail = trails_[index];
  const std::int64_t tick = simulation.tick();
  const std::int64_t window = tick_at(mark.seconds, scenario_.scene.rate);
  trail.stride = std::max<std::int64_t>(1, window / most_trail_points);
  if (tick % trail.stride == 0 && simulation.exists(mark.body)) {
    trail.points.emplace_back(tick, traced(mark, simulation.body(mark.body)));
  }
  while (!trail.points.empty() && trail.points.front().first < tick - window) trail.points.pop_front();
}

void Recorder::record_ghost(std::size_t index, const Simulation& simulation) {
  const GhostMark& mark = scenario_.picture.ghosts[index];
  const int rate = scenario_.scene.rate;
  const auto number = static_cast<std::int64_t>(static_cast<double>(simulation.tick()) / (mark.every * rate) + 0.5);
  const bool is_due = tick_at(static_cast<double>(number) * mark.every, rate) == simulation.tick();
  if (!is_due || ghosts_[index].size() >= most_ghosts || !simulation.exists(mark.body)) return;
  const BodyState state = simulation.body(mark.body);
  ghosts_[index].push_back({state.position, Rotd(state.angle)});
}

void Recorder::sample_plots(std::int64_t tick) {
  const std::vector<PlotMark>& marks = scenario_.picture.plots;
  plots_.resize(marks.size());
  const double time = static_cast<double>(tick) / scenario_.scene.rate;
  for (std::size_t p = 0; p < marks.size(); ++p) {
    const std::size_t curves = marks[p].curves.size();
    PlotSample sample{time, {}};
    for (std::size_t c = 0; c < curves + (marks[p].x_name.empty() ? 0 : 1); ++c) {
      sample.values.push_back(scenario_.script->plot_value(static_cast<int>(p), static_cast<int>(c)));
      (c < curves ? plots_[p].y : plots_[p].x).add(sample.values.back());
    }
    std::deque<PlotSample>& samples = plots_[p].samples;
    samples.push_back(std::move(sample));
    while (samples.front().time < time - marks[p].seconds) samples.pop_front();
  }
}

void Recorder::note_energy(const Energy& energy) {
  if (!energy_) energy_ = {energy.total(), energy.total(), energy.total()};
  for (const double joules : {energy.kinetic, energy.potential, energy.total()}) {
    energy_->lowest = std::min(energy_->lowest, joules);
    energy_->highest = std::max(energy_->highest, joules);
  }
}

std::vector<TrailView> Recorder::trails(const Snapshot& snapshot) const {
  std::vector<TrailView> views;
  for (std::size_t i = 0; i < trails_.size(); ++i) {
    TrailView view{scenario_.picture.trails[i].body, {}};
    for (const auto& [tick, point] : trails_[i].points) view.points.push_back(point);
    const BodyView* body = find_body(snapshot, view.body);
    if (body != nullptr) {
      const Vec2d now = traced(scenario_.picture.trails[i], body->state);
      if (view.points.empty() || !(view.points.back() == now)) view.points.push_back(now);
    }
    views.push_back(std::move(view));
  }
  return views;
}

std::vector<PlotView> Recorder::plots() const {
  std::vector<PlotView> views;
  for (std::size_t p = 0; p < plots_.size(); ++p) {
    const PlotMark& mark = scenario_.picture.plots[p];
    PlotView view{mark.title, mark.curves, mark.seconds, mark.at, {},          {},
                  mark.unit,  mark.x_name, mark.x_unit,  {},      plots_[p].x, plots_[p].y};
    view.values.resize(mark.curves.size());
    for (const PlotSample& sample : plots_[p].samples) {
      view.times.push_back(sample.time);
      for (std::size_t c = 0; c < mark.curves.size(); ++c) view.values[c].push_back(sample.values[c]);
      if (view.is_portrait()) view.xs.push_back(sample.values.back());
    }
    views.push_back(std::move(view));
  }
  return views;
}

std::vector<GhostView> Recorder::ghosts() const {
  std::vector<GhostView> views;
  for (std::size_t i = 0; i < ghosts_.size(); ++i) views.push_back({scenario_.picture.ghosts[i].body, ghosts_[i]});
  return views;
}

std::optional<Vec2d> Recorder::followed(std::size_t move) const {
  return move < followed_.size() ? followed_[move] : std::nullopt;
}

}  // namespace proofreel
