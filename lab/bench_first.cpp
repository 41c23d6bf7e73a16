#include <cstdio>
#include <memory>

#include "lab/bench.h"
#include "lab/bench_process.h"
#include "render/canvas.h"
#include "render/draw.h"
#include "render/png.h"
#include "scenarios/runner.h"

namespace proofreel {
namespace {

constexpr int runs = 7;
constexpr double target_s = 0.4;

/// Says how long it took since the last call.
class Laps {
 public:
  void lap(const char* what) {
    std::printf("    %-34s %5.0f ms\n", what, 1e3 * watch_.elapsed().wall_s);
    watch_ = Stopwatch();
  }

 private:
  Stopwatch watch_;
};

/// The same picture once more in this process, step by step. What is missing from the whole is the process itself.
void print_split(const std::string& out) {
  Laps laps;
  const std::unique_ptr<Scenario> scenario = load_scenario(PROOFREEL_SCENARIOS "/pyramid.lua", {});
  const Runner runner(*scenario);
  const Frame frame = runner.frame(0);
  laps.lap("load the scenario");
  const std::unique_ptr<GlContext> context = make_context(std::nullopt);
  laps.lap("load Mesa, make and test a context");
  const Picture& picture = scenario->picture;
  Canvas canvas(*context, picture.size.width_px, picture.size.height_px);
  laps.lap("make the canvas");
  Image image;
  draw_frame(canvas, frame, {picture.theme}, image);
  laps.lap("draw, shaders compiled");
  draw_frame(canvas, frame, {picture.theme}, image);
  laps.lap("draw once more");
  write_png(out, image);
  laps.lap("write the PNG");
}

}  // namespace

void bench_first() {
  const TemporaryFolder folder;
  const std::vector<std::string> command{
      "render", PROOFREEL_SCENARIOS "/pyramid.lua", "-o", folder / "a.png", "--frames", "0:0", "--quiet"};
  std::vector<Cost> costs;
  for (int i = 0; i < runs; ++i) costs.push_back(cost_of_program(command));
  const Cost cost = median(costs);
  std::printf("  proofreel render pyramid -o a.png --frames 0:0, median of %d: %.2f s (%.2f s CPU; target %.1f s)\n",
              runs, cost.wall_s, cost.cpu_s, target_s);
  print_split(folder / "b.png");
}

}  // namespace proofreel
