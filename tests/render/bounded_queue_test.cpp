#include "render/bounded_queue.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <thread>

namespace proofreel {
namespace {

TEST_CASE("Values come out in the order they went in, each once", "[queue]") {
  BoundedQueue<int> queue(3);
  std::jthread producer([&] {
    for (int i = 0; i < 10000; ++i) queue.push(i);
    queue.close();
  });
  int expected = 0;
  while (const std::optional<int> value = queue.pop()) REQUIRE(*value == expected++);
  REQUIRE(expected == 10000);
}

TEST_CASE("A producer is never more than the capacity ahead", "[queue]") {
  BoundedQueue<int> queue(2);
  std::atomic<int> pushed{0};
  std::jthread producer([&] {
    for (int i = 0; i < 50; ++i) {
      queue.push(i);
      pushed = i + 1;
    }
    queue.close();
  });
  for (int taken = 1; queue.pop(); ++taken) {
    std::this_thread::yield();
    REQUIRE(pushed <= taken + 2);
  }
}

TEST_CASE("A closed queue still hands out what is in it, and takes nothing more", "[queue]") {
  BoundedQueue<int> queue(2);
  queue.push(1);
  queue.close();
  REQUIRE_FALSE(queue.push(2));
  REQUIRE(queue.pop() == 1);
  REQUIRE_FALSE(queue.pop().has_value());
}

TEST_CASE("Abandoning a queue wakes whoever waits for it, and drops what is in it", "[queue]") {
  BoundedQueue<int> full(1), empty(1);
  full.push(1);
  bool pushed = true, popped = true;
  std::jthread producer([&] { pushed = full.push(2); });
  std::jthread consumer([&] { popped = empty.pop().has_value(); });
  full.abandon();
  empty.abandon();
  producer.join();
  consumer.join();
  REQUIRE_FALSE(pushed);
  REQUIRE_FALSE(popped);
  REQUIRE_FALSE(full.pop().has_value());
}

}  // namespace
}  // namespace proofreel
