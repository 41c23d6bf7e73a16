#include "scenarios/timeline.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "scenarios/formatted.h"
#include "scenarios/runner.h"
#include "scenarios/suggest.h"

namespace proofreel {
namespace {

std::string shown(double number) { return formatted("%.6g", number); }

/// `fps` is that of the whole film.
[[noreturn]] void refuse_rate(const Scenario& scenario, int fps) {
  const int rate = scenario.scene.rate;
  const int below = rate / fps * fps;
  const std::string works =
      below > 0 ? std::to_string(below) + " or " + std::to_string(below + fps) : std::to_string(fps);
  throw ScenarioError(in_file(scenario) + "a film needs a whole number of ticks per frame: rate " +
                      std::to_string(rate) + " at " + std::to_string(fps) +
                      " fps does not give one; the nearest rates that work are " + works);
}

bool is_whole_frame(double ticks) {
  return ticks > 0.5 && std::abs(ticks - std::round(ticks)) < 1e-9 * std::round(ticks);
}

/// The next higher rate at which this slow motion has whole frames, as a hint; empty when it is far away.
std::string rate_hint(std::int64_t ticks, double factor, int fps) {
  constexpr std::int64_t far = 1000;
  for (std::int64_t more = ticks + 1; more < ticks + far; ++more) {
    if (is_whole_frame(static_cast<double>(more) * factor)) return ", or rate = " + std::to_string(more * fps);
  }
  return {};
}

/// Ticks per frame during `slow`, where a frame otherwise takes `ticks` of them.
std::int64_t slowed(const Scenario& scenario, std::int64_t ticks, const SlowMotion& slow) {
  const int fps = scenario.picture.fps;
  const auto usual = static_cast<double>(ticks);
  const double wanted = usual * slow.factor;
  if (is_whole_frame(wanted)) return std::llround(wanted);
  const double lower = std::max(1.0, std::floor(wanted));
  const double upper = std::min(usual, lower + 1);
  const std::string factors = lower < upper ? shown(lower / usual) + " or " + shown(upper / usual) : shown(1);
  throw ScenarioError(in_file(scenario) + "slow{factor=" + shown(slow.factor) + "} would show a frame every " +
                      shown(wanted) + " ticks, which must be a whole number; what works: factor = " + factors +
                      rate_hint(ticks, slow.factor, fps));
}

struct SlowStretch {
  std::int64_t from;
  std::int64_t to;
  std::int64_t ticks_per_frame;
};

std::vector<SlowStretch> slow_stretches(const Scenario& scenario, std::int64_t ticks_per_frame) {
  const int rate = scenario.scene.rate;
  std::vector<SlowStretch> stretches;
  for (const SlowMotion& slow : scenario.picture.slow) {
    stretches.push_back({tick_at(slow.from, rate), tick_at(slow.to, rate), slowed(scenario, ticks_per_frame, slow)});
  }
  return stretches;
}

std::int64_t ticks_to_next(std::int64_t tick, std::int64_t usual, const std::vector<SlowStretch>& stretches) {
  for (const SlowStretch& slow : stretches) {
    if (slow.from <= tick && tick < slow.to) return slow.ticks_per_frame;
  }
  return usual;
}

/// How often the frame at `tick` is shown once more, when the one before showed `before`.
std::int64_t held(const Scenario& scenario, std::int64_t before, std::int64_t tick) {
  std::int64_t frames = 0;
  for (const Freeze& freeze : scenario.picture.freezes) {
    const std::int64_t at = tick_at(freeze.at, scenario.scene.rate);
    if (before < at && at <= tick) frames += std::llround(freeze.seconds * scenario.picture.fps);
  }
  return frames;
}

struct Timeline {
  std::vector<std::int64_t> frames;  ///< their ticks
  std::int64_t end = 0;              ///< the tick the next frame would show
};

Timeline timeline_of(const Scenario& scenario) {
  const int rate = scenario.scene.rate;
  const int fps = scenario.picture.fps;
  if (rate % fps != 0) refuse_rate(scenario, fps);
  for (const auto& pane : scenario.other_panes) {
    if (pane->scene.rate % fps != 0) refuse_rate(*pane, fps);
  }
  const std::int64_t usual = rate / fps;
  const std::vector<SlowStretch> stretches = slow_stretches(scenario, usual);
  Timeline timeline;
  for (std::int64_t before = -1; timeline.end < scenario.ticks();) {
    const std::int64_t tick = timeline.end;
    timeline.frames.insert(timeline.frames.end(), static_cast<std::size_t>(1 + held(scenario, before, tick)), tick);
    before = tick;
    timeline.end += ticks_to_next(tick, usual, stretches);
  }
  return timeline;
}

/// What is demonstrated begins a section whenever its heading changes.
std::vector<Section> headings_of(const std::vector<Story>& stories) {
  std::vector<Section> sections;
  double time = 0;
  for (const Story& story : stories) {
    for (const Step& step : story.steps) {
      if (sections.empty() || sections.back().name != step.heading) sections.push_back({time, step.heading});
      time += step.seconds;
    }
  }
  return sections;
}

}  // namespace

std::string in_file(const Scenario& scenario) {
  const std::string pane = scenario.pane_title.empty() ? "" : "pane " + quote(scenario.pane_title) + ": ";
  return scenario.path + ": " + pane;
}

std::int64_t tick_at(double seconds, int rate) {
  // Far beyond every run all times are alike; the bound keeps the conversion defined.
  return std::llround(std::min(seconds * rate, 1e15));
}

std::int64_t Scenario::ticks() const { return tick_at(duration, scene.rate); }

bool is_sample_tick(const Scenario& scenario, std::int64_t tick) {
  if (tick == scenario.ticks()) return true;
  const std::int64_t rate = scenario.scene.rate;
  const std::int64_t fps = scenario.picture.fps;
  const std::int64_t frame = (2 * tick * fps + rate) / (2 * rate);
  for (std::int64_t i = std::max<std::int64_t>(0, frame - 1); i <= frame + 1; ++i) {
    if ((2 * i * rate + fps) / (2 * fps) == tick) return true;
  }
  return false;
}

const std::vector<Layer>& layers_at(const Picture& picture, std::int64_t tick, int rate) {
  const std::vector<Layer>* layers = &picture.layers;
  for (const LayerChange& change : picture.layer_changes) {
    if (tick_at(change.at, rate) <= tick) layers = &change.layers;
  }
  return *layers;
}

bool ever_shows(const Picture& picture, Layer layer) {
  const auto holds = [layer](const std::vector<Layer>& layers) {
    return std::find(layers.begin(), layers.end(), layer) != layers.end();
  };
  return holds(picture.layers) || std::any_of(picture.layer_changes.begin(), picture.layer_changes.end(),
                                              [&](const LayerChange& change) { return holds(change.layers); });
}

std::vector<std::int64_t> film_timeline(const Scenario& scenario) { return timeline_of(scenario).frames; }

std::int64_t film_end(const Scenario& scenario) { return timeline_of(scenario).end; }

std::vector<FilmSection> film_sections(const Scenario& scenario, const std::vector<std::int64_t>& timeline) {
  const bool named = !scenario.picture.sections.empty();
  std::vector<FilmSection> sections;
  for (const Section& section : named ? scenario.picture.sections : headings_of(scenario.stories)) {
    const std::int64_t tick = tick_at(section.at, scenario.scene.rate);
    const auto first = std::lower_bound(timeline.begin(), timeline.end(), tick) - timeline.begin();
    if (first == static_cast<std::ptrdiff_t>(timeline.size())) continue;
    if (!sections.empty() && sections.back().first == first) sections.pop_back();
    if (!sections.empty()) sections.back().last = first - 1;
    sections.push_back({section.name, first, static_cast<std::int64_t>(timeline.size()) - 1});
  }
  return sections;
}

}  // namespace proofreel
