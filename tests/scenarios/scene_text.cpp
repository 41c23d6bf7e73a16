#include "scene_text.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace proofreel {

ScratchFolder::ScratchFolder() {
  static int count = 0;
  const auto name = "proofreel-" + std::to_string(getpid()) + "-" + std::to_string(++count);
  path_ = (std::filesystem::temp_directory_path() / name).string();
  std::filesystem::create_directories(path_);
}

ScratchFolder::~ScratchFolder() { std::filesystem::remove_all(path_); }

std::string ScratchFolder::write(const std::string& name, const std::string& text) const {
  const std::filesystem::path path = std::filesystem::path(path_) / name;
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
  return path.string();
}

std::vector<std::string> all_scenarios() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("scenarios")) {
    const std::string folder = entry.path().parent_path().filename().string();
    if (folder != "include" && folder != "beyond" && entry.path().extension() == ".lua")
      paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<Override> shortened(const std::string& path) {
  if (path.ends_with("/large_pyramid.lua")) return {{"duration", "0.15"}};
  return {};
}

std::unique_ptr<Scenario> load_text(const std::string& text, const std::vector<Override>& overrides) {
  const ScratchFolder folder;
  return load_scenario(folder.write("scene.lua", text), overrides);
}

std::string error_of(const std::string& text, const std::vector<Override>& overrides) {
  const ScratchFolder folder;
  try {
    const auto scenario = load_scenario(folder.write("scene.lua", text), overrides);
    auto simulation = std::make_unique<FakeSimulation>(scenario->scene);
    Runner(*scenario, std::move(simulation)).finish();
  } catch (const ScenarioError& error) {
    std::string message = error.what();
    const std::string cut = folder.path() + "/";
    for (auto at = message.find(cut); at != std::string::npos; at = message.find(cut)) message.erase(at, cut.size());
    return message;
  }
  return {};
}

double value_of(const std::string& expression, const std::string& preamble) {
  const auto scenario = load_text("scenario{}\n" + preamble + "\nlocal value = " + expression +
                                  "\nmeasure('value', function() return value end)");
  return scenario->script->measure(0);
}

bool is_true(const std::string& expression, const std::string& preamble) {
  const auto scenario = load_text("scenario{}\n" + preamble + "\nlocal value = " + expression +
                                  "\nexpect('value', function() return value end)");
  return scenario->script->expectation(0);
}

FakeRun::FakeRun(const std::string& text) : scenario(load_text(text)) {
  auto made = std::make_unique<FakeSimulation>(scenario->scene);
  simulation = made.get();
  runner = std::make_unique<Runner>(*scenario, std::move(made));
}

void FakeRun::until(std::int64_t tick) {
  while (runner->tick() < tick) runner->step();
}

}  // namespace proofreel
