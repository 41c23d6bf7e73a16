#include <cstdio>
#include <memory>

#include "golden/bless.h"
#include "golden/compare.h"
#include "golden/difference.h"
#include "golden/hex.h"
#include "golden/pictures.h"
#include "lab/bench.h"
#include "lab/bench_process.h"
#include "lab/page_picture.h"
#include "render/output_file.h"
#include "render/pixel_hash.h"
#include "render/png.h"
#include "scenarios/runner.h"

namespace proofreel {
namespace {

constexpr int rounds = 9, page_width_px = 3446, page_height_px = 10728;
constexpr double target_ratio = 1.3, target_frame_ms = 0.3, target_check_s = 15;
constexpr int checked_scenarios = 10, frames_each = 100;

double milliseconds(const Cost& cost) { return 1e3 * cost.wall_s; }

/// The median time of a few calls.
template <typename Call>
Cost cost_of(int calls, const Call& call) {
  std::vector<Cost> costs;
  for (int i = 0; i < calls; ++i) {
    const Stopwatch watch;
    call();
    costs.push_back(watch.elapsed());
  }
  return median(costs);
}

/// Two pages written to disk; says how much of them differs.
void write_pages(const std::string& expected, const std::string& actual) {
  const Image a = page_picture(page_width_px, page_height_px, false);
  const Image b = page_picture(page_width_px, page_height_px, true);
  write_png(expected, a);
  write_png(actual, b);
  const Comparison c = compare(a, b, 0);
  std::printf("  two pages of %dx%d, of whose pixels %.1f %% differ; both sides in turns, medians of %d\n",
              page_width_px, page_height_px, 100.0 * static_cast<double>(c.different) / static_cast<double>(c.total),
              rounds);
}

void print_comparing_alone(const std::string& expected, const std::string& actual) {
  const Image a = read_png(expected), b = read_png(actual);
  DifferenceSettings settings;
  settings.threads = 2;
  const Cost cost = cost_of(rounds, [&] { difference_between(a, b, settings); });
  const Cost exact = cost_of(rounds, [&] { compare(a, b, 0); });
  std::printf("  of which comparing, on 2 threads: %.0f ms; byte by byte on one: %.0f ms\n", milliseconds(cost),
              milliseconds(exact));
}

void bench_pages() {
  const TemporaryFolder folder;
  const std::string expected = folder / "expected.png", actual = folder / "actual.png";
  write_pages(expected, actual);
  const std::vector<std::string> command{"diff",      expected,  actual,       "--max-different",
                                         "100000000", "--quiet", "--max-bias", "255"};
  std::vector<Cost> whole, decode;
  for (int i = 0; i < rounds; ++i) {
    whole.push_back(cost_of_program(command));
    const Stopwatch watch;
    read_png(expected);
    decode.push_back(watch.elapsed());
  }
  const Cost ours = median(whole), one = median(decode);
  std::printf("  proofreel diff, from start to end:      %4.0f ms wall, %4.0f ms CPU\n", milliseconds(ours),
              1e3 * ours.cpu_s);
  std::printf("  decoding one of them once by libspng:   %4.0f ms wall, %4.0f ms CPU\n", milliseconds(one),
              1e3 * one.cpu_s);
  std::printf("  ratio: %.2f (target %.1f)\n", ours.wall_s / one.wall_s, target_ratio);
  print_comparing_alone(expected, actual);
}

/// A frame of a scenario in 1280x720 with a reference that it equals, as `check` sees it.
class PassingFrame {
 public:
  explicit PassingFrame(const TemporaryFolder& folder)
      : store_(folder / "golden"), scenario_(load_scenario(PROOFREEL_SCENARIOS "/pyramid.lua", {})) {
    scenario_->golden->size = {1280, 720};
    const Runner runner(*scenario_);
    trajectory_hash_ = runner.trajectory_hash();
    DrawnPicture picture = pictures_.draw(*scenario_, runner.frame(0));
    now_ = {0, hex(trajectory_hash_), std::move(picture.image), {}, std::move(picture.hash)};
    golden_.scenario = "passing";
    golden_.size = {1280, 720};
    then_ = {0, now_.trajectory_hash, now_.pixel_hash, "frame.png", "", {}};
    const std::vector<std::uint8_t> bytes = encode_png(now_.image);
    then_.file_hash = bytes_hash(bytes);
    std::filesystem::create_directories(store_.folder("passing"));
    write_png((store_.folder("passing") / "frame.png").string(), now_.image);
  }

  bool passes() const {
    return hex(trajectory_hash_) == then_.trajectory_hash && pixel_hash(now_.image) == now_.pixel_hash &&
           pictures_.judge(store_, golden_, then_, now_).verdict == Verdict::exact;
  }

  double decode_ms() const {
    const std::string file = (store_.folder("passing") / "frame.png").string();
    return milliseconds(cost_of(rounds, [&file] { read_png(file); }));
  }

 private:
  GoldenStore store_;
  std::unique_ptr<Scenario> scenario_;
  Pictures pictures_{std::nullopt};
  std::uint64_t trajectory_hash_ = 0;
  ObservedFrame now_;
  Golden golden_;
  GoldenFrame then_;
};

void bench_passing_frame() {
  const TemporaryFolder folder;
  const PassingFrame frame(folder);
  bool passed = true;
  const Cost cost = cost_of(101, [&] { passed = frame.passes() && passed; });
  std::printf("  a frame of 1280x720 that %s, beyond stepping and drawing it: %.3f ms (target %.1f ms)\n",
              passed ? "passes" : "FAILS", milliseconds(cost), target_frame_ms);
  std::printf("  decoding its reference would take %.1f ms\n", frame.decode_ms());
}

/// Sixty bodies of all shapes that fall into a heap, every sixth frame of ten seconds golden.
std::string heap(int seed) {
  std::string frames;
  for (int i = 0; i < frames_each; ++i) frames += std::to_string(6 * i) + ",";
  std::string lua = "scenario { duration = 10, view = { center = {0, 4}, height = 9 },\n";
  lua +=
      "           seed = " + std::to_string(seed) + ", golden = { frames = {" + frames + "}, size = {480, 270} } }\n";
  return lua + R"(
    local shapes = { circle { radius = 0.25 }, box { width = 0.5, height = 0.4 }, regular { sides = 5, radius = 0.3 } }
    ground { y = 0 }
    for i = 1, 60 do
      body { at = { 6 * math.random() - 3, 1 + 0.3 * i }, shape = shapes[1 + i % 3] }
    end
  )";
}

/// A folder of scenarios, blessed.
void write_heaps(const std::string& folder, const GoldenStore& store) {
  Pictures pictures(std::nullopt);
  for (int seed = 1; seed <= checked_scenarios; ++seed) {
    const std::string path = folder + "heap_" + std::to_string(seed) + ".lua";
    write_file(path, heap(seed));
    plan_blessing(path, {}, store, pictures, false).carry_out();
  }
}

/// Stepping, drawing and judging a thousand golden frames, as CI does.
void bench_check() {
  const TemporaryFolder folder;
  const std::string scenarios = folder / "", store = folder / "golden";
  write_heaps(scenarios, GoldenStore(store));
  std::printf(
      "  %d golden frames of 480x270, in %d scenarios, stepped, drawn and judged (target %.0f s on two cores):\n",
      checked_scenarios * frames_each, checked_scenarios, target_check_s);
  for (const char* jobs : {"1", "2"}) {
    const Cost cost = cost_of_program({"check", scenarios, "--golden", store, "--jobs", jobs, "--quiet"});
    std::printf("    --jobs %s: %.1f s wall, %.1f s CPU\n", jobs, cost.wall_s, cost.cpu_s);
  }
}

}  // namespace

void bench_golden() {
  bench_pages();
  bench_passing_frame();
  bench_check();
}

}  // namespace proofreel
