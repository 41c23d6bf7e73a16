#pragma once

#include <catch2/catch.hpp>

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

/// Options, and what the sentence says that refuses them.
using Refusals = std::vector<std::pair<std::vector<std::string>, std::string>>;

/// Each of these options after `words` is wrong use: exit status 2, a sentence, and nothing on standard output.
inline void require_refused(const Collection& c, const std::vector<std::string>& words, const Refusals& refusals) {
  for (const auto& [options, sentence] : refusals) {
    std::vector<std::string> arguments = words;
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome o = c.run(arguments);
    CAPTURE(options, o.err);
    REQUIRE(o.status == 2);
    REQUIRE(o.out.empty());
    REQUIRE_THAT(o.err, Catch::Matchers::Contains(sentence));
  }
}

}  // namespace proofreel
