#pragma once

/// Scenarios that are blessed and then broken on purpose.

#include <string>
#include <vector>

#include "golden/bless.h"
#include "golden/check.h"
#include "tests/render/scratch_folder.h"

namespace proofreel::defects {

/// One context for the whole program, since each costs a tenth of a second. It is never let go: at the end of the
/// program Mesa may be gone before it.
inline Pictures& pictures() {
  static auto& pictures = *new Pictures(std::nullopt);
  return pictures;
}

/// A scenario of 120 ticks and 30 frames, of which 0, 15 and 29 are golden; its last line can be added to.
inline std::string scenario_text(const std::string& keys, const std::string& body) {
  return "scenario { duration = 0.5, size = {160, 90}, " + keys +
         ", golden = { frames = {0, 15, 29}, size = {160, 90} } }\n" + body + "\n";
}

/// Three boxes on the ground, contacts shown.
inline std::string pile() {
  return scenario_text(
      "view = { center = {0, 1.5}, height = 4 }, layers = { 'bodies', 'contacts' }",
      "ground { y = 0 }\n"
      "body { name = 'low', at = {0, 0.5}, shape = box { width = 1, height = 1 } }\n"
      "body { name = 'middle', at = {0, 1.5}, shape = box { width = 1, height = 1 } }\n"
      "body { name = 'top', at = {0, 2.5}, color = 0x4080c0, shape = box { width = 1, height = 1 } }\n");
}

/// Two boxes that slide side by side.
inline std::string slide() {
  return scenario_text("view = { center = {1, 1}, height = 4 }",
                       "ground { y = 0, friction = 0.5 }\n"
                       "body { name = 'left', at = {-2, 0.25}, velocity = {3, 0}, friction = 0.4,\n"
                       "       shape = box { width = 0.5, height = 0.5 } }\n"
                       "body { name = 'right', at = {1, 0.25}, velocity = {3, 0}, friction = 0.5,\n"
                       "       shape = box { width = 0.5, height = 0.5 } }\n");
}

/// A ball that meets another one after a while, and a third that nothing meets.
inline std::string billiard() {
  return scenario_text(
      "gravity = {0, 0}, view = { center = {0, 0}, height = 3 }",
      "body { name = 'cue', at = {-1, 0}, velocity = {2.5, 0}, mass = 1, restitution = 1,\n"
      "       shape = circle { radius = 0.3 } }\n"
      "body { name = 'target', at = {0.5, 0}, mass = 1, shape = circle { radius = 0.3 } }\n"
      "body { name = 'bystander', at = {0, 1.1}, velocity = {1, 0}, shape = circle { radius = 0.2 } }\n");
}

/// A bob with a trail, an arrow, a label and a caption.
inline std::string pendulum() {
  return scenario_text("view = { center = {0, -0.5}, height = 3 }",
                       "local bob = body { name = 'bob', at = {1, 0}, shape = circle { radius = 0.2 } }\n"
                       "revolute { world, bob, at = {0, 0} }\n"
                       "trail { body = bob, seconds = 1 }\n"
                       "vector { body = bob, of = 'velocity', scale = 0.1 }\n"
                       "label { body = bob, text = 'v' }\n"
                       "caption { text = 'It swings', from = 0, to = 1 }\n");
}

/// Planks on hinges under a box that falls on them, with the hierarchy.
inline std::string bridge() {
  return scenario_text(
      "view = { center = {0, 0}, height = 3 }, layers = { 'bodies', 'joints', 'bvh' }",
      "local before = world\n"
      "for i = 1, 4 do\n"
      "  local plank = body { name = 'plank ' .. i, at = {i - 2.5, 0}, shape = box { width = 0.9, height = "
      "0.15 } }\n"
      "  revolute { before, plank, at = {i - 3, 0} }\n"
      "  before = plank\n"
      "end\n"
      "revolute { before, world, at = {2, 0} }\n"
      "body { name = 'load', at = {0.3, 0.8}, shape = box { width = 0.4, height = 0.4 } }\n");
}

inline std::vector<std::string> all_scenes() { return {pile(), slide(), billiard(), pendulum(), bridge()}; }

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw std::runtime_error("nothing to replace: " + what);
  return text.replace(at, what.size(), by);
}

/// A blessed scenario in a store of its own.
class Blessed {
 public:
  explicit Blessed(const std::string& lua) : store_(folder_ / "golden") {
    write(lua);
    plan_blessing(file(), {}, store_, pictures(), false).carry_out();
  }

  const GoldenStore& store() const { return store_; }
  std::string file() const { return folder_ / "scenarios/scene.lua"; }
  void write(const std::string& lua) const { write_text(file(), lua); }
  Golden golden() const { return *store_.load("scene"); }
  void keep(const Golden& golden) const { write_text(store_.json_path("scene"), to_json_text(golden)); }

  CheckResult check(const PictureTools& tools) const { return check_scenario(file(), {}, store_, tools); }
  CheckResult check() const { return check(pictures().tools(store_)); }
  CheckResult check(const std::string& lua) const {
    write(lua);
    return check();
  }

 private:
  ScratchFolder folder_;
  GoldenStore store_;
};

inline std::vector<Verdict> verdicts(const CheckResult& result) {
  std::vector<Verdict> list;
  for (const Finding& finding : result.findings) list.push_back(finding.verdict);
  return list;
}

}  // namespace proofreel::defects
