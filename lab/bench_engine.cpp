#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include "lab/bench.h"
#include "lab/bench_engine_scenes.h"
#include "lab/bench_process.h"
#include "lab/measures.h"
#include "lab/peers/peers.h"

namespace proofreel {
namespace {

/// CPU seconds that one side may take for one simulated second, and all sides together for a scene.
constexpr double most_per_second = 15;
constexpr double most_per_scene = 60;

/// One engine with its copy of the scene.
struct Side {
  std::string name;
  std::unique_ptr<Simulation> simulation;
  Snapshot start;
  Snapshot now;
  std::vector<double> cpu_ms;  ///< of each simulated second
  int looks = 0;               ///< at the ends of seconds, which the following are of
  Penetration fit;             ///< what is largest of all of them, and the mean of their means
  JointGaps gaps;
  bool gave_up = false;
  double spent_s = 0;
};

Side side_of(const std::string& name, std::unique_ptr<Simulation> simulation) {
  Side side;
  side.name = name;
  side.simulation = std::move(simulation);
  side.simulation->observe(side.start);
  return side;
}

/// Takes one more number into a mean of `count` others.
double with_one_more(double mean, double number, int count) { return mean + (number - mean) / (count + 1); }

void look(Side& side, const std::vector<FilterDef>& filters) {
  side.simulation->observe(side.now);
  const Penetration found = penetration_of(side.now, filters);
  side.fit.pairs = found.pairs;
  side.fit.largest = std::max(found.largest, side.fit.largest);
  side.fit.of_smaller = std::max(found.of_smaller, side.fit.of_smaller);
  side.fit.mean = with_one_more(side.fit.mean, found.mean, side.looks);
  side.fit.mean_air = with_one_more(side.fit.mean_air, found.mean_air, side.looks);
  const JointGaps gaps = joint_gaps(side.now);
  side.gaps.largest = std::max(side.gaps.largest, gaps.largest);
  side.gaps.mean = with_one_more(side.gaps.mean, gaps.mean, side.looks);
  ++side.looks;
}

/// Only the steps are timed.
void simulate_second(Side& side, const BenchScene& bench) {
  double cpu_s = 0;
  for (int i = 0; i < bench.scene.rate && !side.gave_up; ++i) {
    if (bench.commands) {
      for (const Command& command : bench.commands(side.simulation->tick())) side.simulation->apply(command);
    }
    const Stopwatch watch;
    side.simulation->step();
    cpu_s += watch.elapsed().cpu_s;
    side.gave_up = cpu_s > most_per_second || side.simulation->failure().has_value();
  }
  side.spent_s += cpu_s;
  if (side.gave_up) return;
  side.cpu_ms.push_back(1e3 * cpu_s);
  look(side, bench.filters);
}

void print_quality(const Side& side, const BenchScene& bench) {
  const Penetration& p = side.fit;
  if (p.pairs > 0) {
    std::printf("      overlap: largest %.2f mm (%.2f %% of the thinner body), mean %.3f mm over %d pairs",
                1e3 * p.largest, 100 * p.of_smaller, 1e3 * p.mean, p.pairs);
    std::printf("; air between bodies that carry each other: mean %.2f mm\n", 1e3 * p.mean_air);
  }
  if (!side.now.joints.empty()) {
    std::printf("      joint gap: largest %.3g mm, mean %.3g mm\n", 1e3 * side.gaps.largest, 1e3 * side.gaps.mean);
  }
  std::printf("      drift: %s\n", bench.drift(side.start, side.now).c_str());
}

std::string end_of(const Side& side, const BenchScene& bench) {
  if (!side.gave_up) return "";
  const std::int64_t ticks = side.simulation->tick();
  char text[160];
  if (side.simulation->failure()) {
    std::snprintf(text, sizeof text, "; its numbers were infinite after %lld ticks", static_cast<long long>(ticks));
  } else {
    std::snprintf(text, sizeof text, "; stopped after %lld ticks of %d in %.0f s, all seconds would take some %.0f s",
                  static_cast<long long>(ticks), bench.scene.rate * bench.seconds, side.spent_s,
                  side.spent_s / static_cast<double>(ticks) * bench.scene.rate * bench.seconds);
  }
  return text;
}

void print_side(const Side& side, const Side& box2d, const BenchScene& bench) {
  std::printf("    %-12s", side.name.c_str());
  if (side.cpu_ms.empty()) {
    std::printf(" did not finish a second%s\n", end_of(side, bench).c_str());
    return;
  }
  const double cpu_ms = median(side.cpu_ms);
  std::printf("%8.1f ms", cpu_ms);
  if (!box2d.cpu_ms.empty()) std::printf(", %5.2f times Box2D", cpu_ms / median(box2d.cpu_ms));
  std::printf("%s\n", end_of(side, bench).c_str());
  print_quality(side, bench);
}

void bench_scene(const BenchScene& bench) {
  std::vector<Side> sides;
  sides.push_back(side_of("proofreel", make_simulation(bench.scene)));
  sides.push_back(side_of("Box2D 2.4", make_peer(Peer::box2d, bench.scene)));
  sides.push_back(side_of("Chipmunk 7", make_peer(Peer::chipmunk, bench.scene)));
  double spent_s = 0;
  for (int second = 0; second < bench.seconds && spent_s < most_per_scene; ++second) {
    spent_s = 0;
    for (Side& side : sides) {
      if (!side.gave_up) simulate_second(side, bench);
      spent_s += side.spent_s;
    }
  }
  std::printf("  %s\n", bench.name.c_str());
  for (const Side& side : sides) print_side(side, sides[1], bench);
}

}  // namespace

void bench_engine() {
  std::printf(
      "  CPU per simulated second, in turns, one thread, nothing sleeps, medians of the seconds; all at 60 Hz: "
      "proofreel\n"
      "  in single precision with 4 substeps, Box2D (single) with 8/3 iterations, Chipmunk (double) with 10 and 5 mm "
      "slop.\n"
      "  Overlaps and gaps are measured by proofreel's narrow phase after every second; means are over all of them\n");
  for (const BenchScene& bench : {pyramid(100), joint_grid(10), joint_grid(20), joint_grid(100), tumbler(45),
                                  ragdoll_rain(60), free_bodies(5000)}) {
    bench_scene(bench);
  }
}

}  // namespace proofreel
