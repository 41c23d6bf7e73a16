#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <vector>

#include "engine/broad_phase.h"
#include "lab/bench.h"
#include "lab/bench_process.h"
#include "lab/peers/box2d_tree.h"
#include "lab/peers/chipmunk_tree.h"

// Compiled in single precision, as Box2D is.
namespace proofreel {
namespace {

constexpr float rate = 60;            ///< steps per second
constexpr float speed = 2;            ///< m/s at most, each way
constexpr double ground_per_box = 2;  ///< m^2, of which a box covers half on average
constexpr std::size_t many = 10'000;  ///< boxes
constexpr int rounds = 9;
constexpr int steps = 40;  ///< of a round
constexpr double target_pairs = 1.5;
constexpr double target_query = 1.2;

/// Boxes of 0.5 to 1.5 m that fly about in a square and turn back at its edge.
class Swarm {
 public:
  explicit Swarm(std::size_t count)
      : side_(static_cast<float>(std::sqrt(ground_per_box * static_cast<double>(count)))) {
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2f lower{between(0, side_), between(0, side_)};
      boxes.push_back({lower, lower + Vec2f{between(0.5F, 1.5F), between(0.5F, 1.5F)}});
      displacements.push_back((1 / rate) * Vec2f{between(-speed, speed), between(-speed, speed)});
    }
  }
  void advance() {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      boxes[i] = {boxes[i].lower + displacements[i], boxes[i].upper + displacements[i]};
      turn_back(boxes[i].lower.x, displacements[i].x);
      turn_back(boxes[i].lower.y, displacements[i].y);
    }
  }

  std::vector<BoxF> boxes;
  std::vector<Vec2f> displacements;  ///< until the next step

 private:
  void turn_back(float position, float& way) const {
    if ((position < 0 && way < 0) || (position > side_ && way > 0)) way = -way;
  }
  /// Marsaglia's xorshift64.
  float between(float low, float high) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return low + (high - low) * (static_cast<float>(state_ >> 40) * 0x1p-24F);
  }

  float side_;
  std::uint64_t state_ = 0x9e3779b97f4a7c15U;
};

/// Our broad phase, with a dynamic body for every box.
class OurBroadPhase {
 public:
  /// A shape's margin is a tenth of its thickness.
  explicit OurBroadPhase(const std::vector<BoxF>& boxes) : shapes_(boxes.size()), bodies_(boxes.size()) {
    for (ShapeIndex i = 0; i < boxes.size(); ++i) {
      shapes_[i].body = i;
      shapes_[i].hull.thickness = 10 * Box2dBroadPhase::margin();
      bodies_[i].type = BodyType::dynamic;
      phase_.add(i, shapes_[i], expanded(boxes[i], Box2dBroadPhase::margin()));
    }
  }
  void move(const std::vector<BoxF>& boxes, const std::vector<Vec2f>& displacements) {
    for (ShapeIndex i = 0; i < boxes.size(); ++i) phase_.move(i, shapes_[i], boxes[i], displacements[i]);
  }
  void update_pairs(std::vector<BoxPair>& pairs) {
    pairs.clear();
    for (const ShapePair pair : phase_.new_pairs(shapes_, bodies_)) pairs.emplace_back(pair.a, pair.b);
  }
  std::size_t query(const std::vector<BoxF>& boxes) const {
    std::size_t found = 0;
    for (const BoxF& box : boxes) phase_.tree().query(box, [&](ProxyId, std::uint32_t) { return ++found > 0; });
    return found;
  }
  BoxF fat_box(std::uint32_t index) const { return phase_.tree().aabb(shapes_[index].proxy); }
  void forget(BoxPair pair) { phase_.forget({pair.first, pair.second}); }
  const DynamicTree& tree() const { return phase_.tree(); }

 private:
  BroadPhase phase_;
  std::vector<Shape> shapes_;
  std::vector<Body> bodies_;
};

void forget(OurBroadPhase& phase, BoxPair pair) { phase.forget(pair); }
void forget(Box2dBroadPhase&, BoxPair) {}  // remembers nothing

/// A broad phase, the pairs a client would hold, and what it cost.
template <typename Phase>
struct Side {
  Phase phase;
  std::vector<BoxPair> held;
  std::vector<double> step_s{};   ///< CPU of a step, mean of each round
  std::vector<double> query_s{};  ///< CPU of a query
  std::size_t found = 0;          ///< by all queries

  explicit Side(const Swarm& swarm) : phase(swarm.boxes) { phase.update_pairs(held), keep({}); }
  /// What is timed: all boxes are told, and what is new is found out.
  double step(const Swarm& swarm) {
    std::vector<BoxPair> pairs;
    const Stopwatch watch;
    phase.move(swarm.boxes, swarm.displacements);
    phase.update_pairs(pairs);
    const double cost = watch.elapsed().cpu_s;
    keep(pairs);
    return cost;
  }
  /// The client's part: pairs that parted go, new ones come.
  void keep(const std::vector<BoxPair>& pairs) {
    std::erase_if(held, [this](BoxPair pair) {
      if (overlaps(phase.fat_box(pair.first), phase.fat_box(pair.second))) return false;
      forget(phase, pair);
      return true;
    });
    held.insert(held.end(), pairs.begin(), pairs.end());
    std::sort(held.begin(), held.end());
    held.erase(std::unique(held.begin(), held.end()), held.end());
  }
  void query(const std::vector<BoxF>& boxes) {
    const Stopwatch watch;
    found += phase.query(boxes);
    query_s.push_back(watch.elapsed().cpu_s / static_cast<double>(boxes.size()));
  }
  /// Whether the pairs held are those of all fat boxes, each compared with each.
  bool is_right(std::size_t count) const {
    std::vector<BoxPair> expected;
    for (std::uint32_t i = 0; i < count; ++i) {
      const BoxF box = phase.fat_box(i);
      for (std::uint32_t j = i + 1; j < count; ++j) {
        if (overlaps(box, phase.fat_box(j))) expected.emplace_back(i, j);
      }
    }
    return held == expected;
  }
};

/// Both sides go through the same steps, in turns.
void run_round(Swarm& swarm, Side<OurBroadPhase>& ours, Side<Box2dBroadPhase>& theirs, int count) {
  double our_cost = 0;
  double their_cost = 0;
  for (int i = 0; i < count; ++i) {
    swarm.advance();
    their_cost += theirs.step(swarm);
    our_cost += ours.step(swarm);
  }
  ours.step_s.push_back(our_cost / count);
  theirs.step_s.push_back(their_cost / count);
}

void print_ratio(const char* what, double ours, double theirs, double target) {
  std::printf("  %-22s proofreel %7.2f us, Box2D %7.2f us: %.2f times as many per second (target %.1f)\n", what,
              1e6 * ours, 1e6 * theirs, theirs / ours, target);
}

void print_check(const Side<OurBroadPhase>& ours, const Side<Box2dBroadPhase>& theirs) {
  std::printf(
      "  pairs held at the end: proofreel %zu, %s; Box2D %zu, %s (each against brute force over its own boxes)\n",
      ours.held.size(), ours.is_right(many) ? "all right" : "WRONG", theirs.held.size(),
      theirs.is_right(many) ? "all right" : "WRONG");
  std::printf("  found by the queries: proofreel %zu, Box2D %zu\n", ours.found, theirs.found);
}

void compare_with_box2d() {
  std::printf(
      "  %zu boxes of 0.5 to 1.5 m on %.0f m^2 each, up to %.0f m/s each way, %.0f steps per second, single "
      "precision\n",
      many, ground_per_box, static_cast<double>(speed), static_cast<double>(rate));
  std::printf(
      "  fattening, both sides: %.1f m to all sides and four steps ahead, renewed when the box or its next step\n"
      "  leaves it; CPU, in turns, medians of %d rounds of %d steps; ours also sorts out known pairs, Box2D does not\n",
      static_cast<double>(Box2dBroadPhase::margin()), rounds, steps);
  Swarm swarm(many);
  Side<OurBroadPhase> ours(swarm);
  Side<Box2dBroadPhase> theirs(swarm);
  for (int i = 0; i < rounds; ++i) {
    run_round(swarm, ours, theirs, steps);
    theirs.query(swarm.boxes);
    ours.query(swarm.boxes);
  }
  print_ratio("move and find pairs", median(ours.step_s), median(theirs.step_s), target_pairs);
  print_ratio("query with one box", median(ours.query_s), median(theirs.query_s), target_query);
  print_check(ours, theirs);
}

void time_chipmunk(const char* name, ChipmunkIndex::Kind kind) {
  Swarm swarm(many);
  ChipmunkIndex index(kind, swarm.boxes);
  std::vector<double> cost;
  std::size_t pairs = 0;
  for (int i = 0; i < rounds; ++i) {
    for (int j = 0; j < steps / 10; ++j) {
      swarm.advance();
      const Stopwatch watch;
      pairs = index.step(swarm.boxes, swarm.displacements);
      cost.push_back(watch.elapsed().cpu_s);
    }
  }
  std::printf("  %-22s %7.2f us per step, %zu pairs (double, fattened its own way, all pairs told anew)\n", name,
              1e6 * median(cost), pairs);
}

/// What finding all pairs of `count` boxes takes.
struct Search {
  double step_s = 0;       ///< incremental, per step
  double box2d_s = 0;      ///< the same by Box2D
  double traversal_s = 0;  ///< of the whole tree against itself
  double visits = 0;       ///< pairs of nodes looked at by it
};

Search search_among(std::size_t count) {
  Swarm swarm(count);
  Side<OurBroadPhase> ours(swarm);
  Side<Box2dBroadPhase> theirs(swarm);
  for (int i = 0; i < 3; ++i) run_round(swarm, ours, theirs, 16);
  std::vector<double> traversals;
  for (int i = 0; i < 5; ++i) {
    std::size_t pairs = 0;
    const Stopwatch watch;
    ours.phase.tree().for_each_pair([&](ProxyId, ProxyId) { ++pairs; });
    traversals.push_back(watch.elapsed().cpu_s);
  }
  double visits = 0;
  ours.phase.tree().for_each_pair([](ProxyId, ProxyId) {}, Observer([&](const Event&) { ++visits; }));
  return {median(ours.step_s), median(theirs.step_s), median(traversals), visits};
}

/// k of t ~ n^k between the first and the last.
double exponent(double first, double last, double growth) { return std::log(last / first) / std::log(growth); }

void show_growth() {
  const std::vector<double> counts{1e3, 1e4, 1e5};
  std::vector<Search> searches;
  for (const double count : counts) {
    searches.push_back(search_among(static_cast<std::size_t>(count)));
    const Search& one = searches.back();
    std::printf("  %6.0f boxes: step %6.0f us (Box2D %6.0f us), traversal %6.0f us, %8.0f pairs of nodes visited\n",
                count, 1e6 * one.step_s, 1e6 * one.box2d_s, 1e6 * one.traversal_s, one.visits);
  }
  const Search& first = searches.front();
  const Search& last = searches.back();
  const double growth = counts.back() / counts.front();
  const double n_log_n =
      exponent(counts.front() * std::log(counts.front()), counts.back() * std::log(counts.back()), growth);
  std::printf(
      "  growth with n^k: visits %.2f (target n log n: %.2f); CPU of a step %.2f (Box2D %.2f), of a traversal %.2f:\n"
      "  (times grow with the cache misses too: %.0f boxes are small beside the caches, %.0f are not)\n",
      exponent(first.visits, last.visits, growth), n_log_n, exponent(first.step_s, last.step_s, growth),
      exponent(first.box2d_s, last.box2d_s, growth), exponent(first.traversal_s, last.traversal_s, growth),
      counts.front(), counts.back());
}

}  // namespace

void bench_tree() {
  compare_with_box2d();
  time_chipmunk("Chipmunk cpBBTree", ChipmunkIndex::Kind::tree);
  time_chipmunk("Chipmunk cpSpaceHash", ChipmunkIndex::Kind::hash);
  show_growth();
}

}  // namespace proofreel
