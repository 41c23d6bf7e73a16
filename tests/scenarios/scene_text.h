#pragma once

/// Scenarios written inside tests.

#include <memory>
#include <string>
#include <vector>

#include "fake_simulation.h"
#include "scenarios/runner.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// A folder of its own for one test, gone with it.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  /// Writes a file below the folder and gives its path.
  std::string write(const std::string& name, const std::string& text) const;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// The paths of all scenarios there are, in order.
std::vector<std::string> all_scenarios();

/// What keeps a scenario that takes half a minute from being stepped half a dozen times in full: it begins only.
std::vector<Override> shortened(const std::string& path);

/// Loads the text as the file scene.lua.
std::unique_ptr<Scenario> load_text(const std::string& text, const std::vector<Override>& overrides = {});

/// What loading (or, when that works, running) the text says is wrong; empty when nothing is. The scratch folder's
/// path is cut off: the message begins with "scene.lua: ".
std::string error_of(const std::string& text, const std::vector<Override>& overrides = {});

/// The value of a Lua expression that may use what `preamble` defines.
double value_of(const std::string& expression, const std::string& preamble = {});
/// Whether the value of a Lua expression is true.
bool is_true(const std::string& expression, const std::string& preamble = {});

/// A scenario stepped by a fake simulation.
struct FakeRun {
  explicit FakeRun(const std::string& text);
  /// Steps until the given tick.
  void until(std::int64_t tick);
  double measure(int index = 0) { return scenario->script->measure(index); }

  std::unique_ptr<Scenario> scenario;
  FakeSimulation* simulation = nullptr;  ///< owned by the runner
  std::unique_ptr<Runner> runner;
};

}  // namespace proofreel
