#include "cli/in_order.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <stdexcept>

namespace proofreel {
namespace {

using Order = InOrder<int>;

/// Things that take the longer the earlier they are.
Order::Worker slow_first() {
  return [](std::size_t i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(i < 3 ? 5 : 0));
    if (i == 7) throw std::runtime_error("seven");
    return static_cast<int>(i);
  };
}

TEST_CASE("What is done side by side is handed over in order, whatever the number of threads", "[in_order]") {
  for (const int jobs : {1, 2, 7, 100}) {
    std::vector<int> taken;
    Order(slow_first).run(7, jobs, [&taken](int i) { taken.push_back(i); });
    CHECK(taken == std::vector<int>{0, 1, 2, 3, 4, 5, 6});
  }
  Order(slow_first).run(0, 4, [](int) { FAIL("nothing was to be done"); });
}

TEST_CASE("An error is thrown after what comes before it was handed over, and ends the work", "[in_order]") {
  for (const int jobs : {1, 3}) {
    std::atomic<int> begun = 0;
    std::vector<int> taken;
    Order order([&begun]() -> Order::Worker {
      return [&begun, worker = slow_first()](std::size_t i) {
        ++begun;
        return worker(i);
      };
    });
    CHECK_THROWS_WITH(order.run(1000, jobs, [&taken](int i) { taken.push_back(i); }), "seven");
    CHECK(taken == std::vector<int>{0, 1, 2, 3, 4, 5, 6});
    if (jobs == 1) CHECK(begun == 8);  // several may have gone ahead of the one that fails
  }
}

TEST_CASE("A worker that cannot be made, or a result nobody wants, ends the work too", "[in_order]") {
  Order broken([]() -> Order::Worker { throw std::runtime_error("no context"); });
  CHECK_THROWS_WITH(broken.run(5, 2, [](int) {}), "no context");
  Order unwanted(slow_first);
  CHECK_THROWS_WITH(unwanted.run(5, 2, [](int) { throw std::runtime_error("enough"); }), "enough");
}

}  // namespace
}  // namespace proofreel
