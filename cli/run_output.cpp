#include "cli/run_output.h"

#include <cmath>

#include "golden/hex.h"
#include "lab/csv.h"
#include "scenarios/formatted.h"

namespace proofreel {
namespace {

std::string rounded(double value) { return formatted("%.9g", value); }

std::string line_of(const MeasureResult& measure) {
  std::string text("  measure ");
  if (!measure.unknown_for.empty()) return text.append(measure.name).append(": not known\n");
  text.append(measure.name).append(": final ").append(rounded(measure.final)).append(", min ");
  text.append(rounded(measure.min)).append(", max ").append(rounded(measure.max));
  if (measure.max_error) text.append(", largest error ").append(rounded(*measure.max_error));
  return text.append("\n");
}

std::string line_of(const ExpectationResult& expectation) {
  std::string text(!expectation.unknown_for.empty() ? "  not known: " : expectation.held ? "  holds: " : "  FAILS: ");
  text.append(expectation.text);
  if (expectation.failed()) text.append(" (first at tick ").append(std::to_string(expectation.tick)).append(")");
  return text.append("\n");
}

/// So that nobody takes its figures for ours.
std::string line_of(const Stepper& peer) {
  std::string text("  stepped by ");
  text.append(peer.name).append(" ").append(peer.version).append(", not by proofreel (");
  const char* gap = "";
  for (const auto& [name, value] : peer.settings.items()) {
    text.append(gap).append(name).append("=").append(value.is_string() ? value.get<std::string>() : value.dump());
    gap = ", ";
  }
  return text.append("); the hashes are its own, of this machine\n");
}

Json json_of(const MeasureResult& measure) {
  if (!measure.unknown_for.empty())
    return {{"final", nullptr}, {"min", nullptr}, {"max", nullptr}, {"max_error", nullptr}};
  Json json{{"final", measure.final}, {"min", measure.min}, {"max", measure.max}, {"max_error", nullptr}};
  if (measure.max_error) json["max_error"] = *measure.max_error;
  return json;
}

}  // namespace

std::string text_of(const RunReport& report, const Stepper& stepper) {
  std::string text(report.scenario);
  text.append(": ").append(std::to_string(report.ticks)).append(" ticks");
  if (report.resumed_at) text.append(" (from ").append(std::to_string(*report.resumed_at)).append(" on)");
  text.append(", trajectory hash ");
  text.append(hex(report.trajectory_hash)).append(", state hash ").append(hex(report.state_hash)).append("\n");
  if (stepper.is_peer()) text += line_of(stepper);
  for (const MeasureResult& measure : report.measures) text += line_of(measure);
  for (const ExpectationResult& expectation : report.expectations) text += line_of(expectation);
  text.append("  energy: ").append(rounded(report.initial_energy.total())).append(" J at first, ");
  text.append(rounded(report.final_energy.total())).append(" J at the end, largest drift ");
  text.append(rounded(report.max_energy_drift)).append(" J");
  return text.append(stepper.is_peer() ? ", work done during steps included\n" : "\n");
}

Json json_of(const std::vector<ExpectationResult>& expectations) {
  Json list = Json::array();
  for (const ExpectationResult& e : expectations) {
    Json one{{"text", e.text}, {"held", nullptr}, {"tick", e.tick}};
    if (e.unknown_for.empty()) one["held"] = e.held;
    list.push_back(one);
  }
  return list;
}

Json json_of(const RunReport& report, const Stepper& stepper, const std::vector<std::string>& warnings, double wall_s) {
  Json measures = Json::object();
  for (const MeasureResult& measure : report.measures) measures[measure.name] = json_of(measure);
  Json json{{"scenario", report.scenario},
            {"ticks", report.ticks},
            {"trajectory_hash", hex(report.trajectory_hash)},
            {"state_hash", hex(report.state_hash)},
            {"measures", measures},
            {"expectations", json_of(report.expectations)},
            {"energy",
             {{"initial", report.initial_energy.total()},
              {"final", report.final_energy.total()},
              {"max_drift", report.max_energy_drift}}},
            {"energy_grew", nullptr},
            {"wall_s", wall_s},
            {"warnings", warnings},
            {"engine", {{"name", stepper.name}, {"version", stepper.version}, {"settings", stepper.settings}}}};
  if (report.energy_grew)
    json["energy_grew"] = {{"tick", report.energy_grew->tick}, {"joules", report.energy_grew->joules}};
  if (report.resumed_at) json["resumed_at"] = *report.resumed_at;
  return json;
}

std::string csv_of(const Scenario& scenario, const std::vector<Sample>& samples) {
  std::string text("t");
  for (const std::string& name : measure_names(scenario)) text.append(",").append(csv_quoted(name));
  text += "\n";
  for (const Sample& sample : samples) {
    text += exact(static_cast<double>(sample.tick) / scenario.scene.rate);
    for (const double value : sample.values) text.append(",").append(std::isnan(value) ? std::string() : exact(value));
    text += "\n";
  }
  return text;
}

std::vector<std::string> unknowns_of(const RunReport& report) {
  std::vector<std::string> sentences;
  const auto add = [&](const std::string& what, const std::string& variable) {
    if (variable.empty()) return;
    sentences.push_back(report.scenario + ": " + what + " is not known after resuming: it can see the variable \"" +
                        variable + "\", which the script changed in the saved run");
  };
  for (const MeasureResult& m : report.measures) add("measure \"" + m.name + "\"", m.unknown_for);
  for (const ExpectationResult& e : report.expectations) add("whether \"" + e.text + "\" holds", e.unknown_for);
  return sentences;
}

std::vector<std::string> failures_of(const std::string& scenario, const std::vector<ExpectationResult>& expectations) {
  std::vector<std::string> sentences;
  for (const ExpectationResult& e : expectations) {
    if (!e.failed()) continue;
    std::string sentence(scenario);
    sentence.append(": does not hold at tick ").append(std::to_string(e.tick)).append(": ").append(e.text);
    sentences.push_back(std::move(sentence));
  }
  return sentences;
}

}  // namespace proofreel
