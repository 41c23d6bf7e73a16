#include <malloc.h>

#include <catch2/catch.hpp>

#include "scenarios/runner.h"
#include "tests/scenarios/scene_text.h"

using namespace proofreel;

namespace {

/// Things rain on a turning paddle in a box for ten minutes; of 61 the oldest goes.
constexpr const char* rain = R"(
scenario { duration = 600, rate = 120, fps = 60, seed = 7 }
ground { y = 0 }
wall { a = {-9, 0}, b = {-9, 16} }
wall { a = {9, 0}, b = {9, 16} }
body { type = "kinematic", at = {2, 4}, spin = 1.3, shape = box { width = 5, height = 0.4 } }
local bob = body { at = {-1, 9}, shape = circle { radius = 0.6 }, density = 3 }
local arm = revolute { world, bob, at = {-4, 9} }
local alive = {}
every(0.12, function()
  if #alive > 60 then table.remove(alive, 1):remove() end
  local at = { -8 + 16 * math.random(), 14 }
  if math.random() < 0.5 then
    alive[#alive + 1] = body { at = at, shape = circle { radius = 0.2 + 0.3 * math.random() }, restitution = 0.3 }
  else
    alive[#alive + 1] = body { at = at, angle = 6 * math.random(), shape = regular { sides = math.random(3, 7), radius = 0.3 + 0.3 * math.random() } }
  end
end)
expect("nothing escapes", function()
  for _, b in ipairs(alive) do
    local p = b:position()
    if math.abs(p.x) > 9.2 or p.y < -0.2 or p.y > 17 then return false end
  end
  return true
end, { always = true })
expect("the pendulum holds", function() return arm:gap() < 1e-6 end, { always = true })
)";

double megabytes_in_use() {
  const auto heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd) / 1e6;
}

}  // namespace

TEST_CASE("Ten minutes of things that come and go: nothing escapes, nothing fails, memory hardly grows") {
  const auto scenario = load_text(rain);
  Runner runner(*scenario);
  const auto run_until = [&](std::int64_t tick) {
    while (runner.tick() < tick) runner.step();
  };
  run_until(60 * 120);
  const double early = megabytes_in_use();
  run_until(scenario->ticks());
  const double late = megabytes_in_use();
  const RunReport report = runner.finish();
  for (const ExpectationResult& e : report.expectations) {
    INFO(e.text << ", tick " << e.tick);
    CHECK(e.held);
  }
  // Ids are never used again: of each of 4,500 bodies that have gone an entry in a few tables is kept. Shapes, contacts
  // and boxes are not, which would be 15 MB more; and there are the samples of 36,000 frames.
  CHECK(late - early < 10);
}
