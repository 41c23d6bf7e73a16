#include "lab/bench.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <thread>
#include <vector>

using namespace proofreel;

namespace {

struct Bench {
  std::string name;
  void (*run)();
};

void bench_collision() {
  bench_manifolds();
  bench_gjk();
  bench_tree();
}

/// `first` goes first: it measures what has not been loaded yet.
const std::vector<Bench> benches{{"first", bench_first},     {"clip", bench_clip},     {"collision", bench_collision},
                                 {"effects", bench_effects}, {"engine", bench_engine}, {"golden", bench_golden}};

int usage() {
  std::fputs("usage: bench [first|clip|collision|effects|engine|golden]\n", stderr);
  return 2;
}

void describe_machine() {
  double load = 0;
  getloadavg(&load, 1);
  std::printf("%u cores, load %.1f at the start (figures are good when it is near 0)\n",
              std::thread::hardware_concurrency(), load);
}

int run(const std::string& wanted) {
  describe_machine();
  bool found = false;
  for (const Bench& bench : benches) {
    if (!wanted.empty() && bench.name != wanted) continue;
    found = true;
    std::printf("\n%s\n", bench.name.c_str());
    bench.run();
  }
  return found ? 0 : usage();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2) return usage();
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // long work: each line as soon as it is known
  try {
    return run(argc == 2 ? argv[1] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
