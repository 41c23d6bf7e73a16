#pragma once

#include "tests/cli/program.h"
#include "tests/render/scratch_folder.h"

namespace proofreel {

/// A folder with scenarios/ and golden/ of a test's own, to run the program in.
class Collection {
 public:
  Collection() { std::filesystem::create_directories(folder_ / "golden"); }

  void write(const std::string& id, const std::string& lua) const {
    write_text(folder_ / ("scenarios/" + id + ".lua"), lua);
  }
  std::string operator/(const std::string& name) const { return folder_ / name; }
  std::string path() const { return folder_.path().string(); }
  Outcome run(const std::vector<std::string>& arguments, const Program::Environment& environment = {}) const {
    return proofreel_program(arguments, path(), environment);
  }

 private:
  ScratchFolder folder_;
};

/// Half a second of a ball in free fall: 30 frames, 120 ticks. `extra` is added at the end.
inline std::string falling_ball(const std::string& extra = "") {
  return "scenario { title = \"Falling ball\", duration = 0.5, size = {96, 64}, view = { center = {0, 2}, height = 8 "
         "},\n"
         "           golden = { frames = {0, 15, 29}, size = {96, 64} } }\n"
         "local ball = body { name = \"ball\", at = {0, 5}, shape = circle { radius = 0.5 } }\n"
         "measure(\"y\", function() return ball:position().y end)\n"
         "reference(\"y\", function(t) return 5 - 0.5 * 9.81 * t * t end)\n" +
         extra;
}

}  // namespace proofreel
