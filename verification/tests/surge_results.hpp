// The small surge of sample_case.hpp, 20 s long, with results made by hand from linear theory:
// every solver agrees with its theory exactly, until a test spoils one.
#pragma once

#include <compare>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reference/linear_surge.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/case/quantities.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh {

inline const std::string surge_quantity = "elevation@right";

inline GateRow surge_row(const std::string& mode, Metric metric, const std::string& unit,
                         double limit) {
  GateRow row{};
  row.candidate = "particles";
  row.reference = "theory";
  row.quantity = surge_quantity;
  row.mode = mode;
  row.metric = metric;
  row.unit = unit;
  row.limit = limit;
  row.reason = "a reason";
  row.source = "a source";
  row.where = {"small_surge.toml", 50};
  return row;
}

inline CaseDefinition surge_case() {
  CaseDefinition definition = sample_case();
  definition.title = "A small surge";
  definition.source = "none";
  definition.duration = 20;
  definition.sample_interval = 0.04;
  definition.gauges = {{"right", 0.95}};
  definition.window_begin = 1;
  definition.window_end = 20;
  const auto run = [](const std::string& name, const decltype(RunDefinition::solver)& solver) {
    RunDefinition one = sample_run(solver);
    one.name = name;
    return one;
  };
  definition.runs = {
      run("theory", LinearRun{500, false, 0.1}), run("theory_with_gas", LinearRun{500, true, 0.1}),
      run("particles", SphRun{"recommended", 0.01, 0.01}),
      run("coarse_mesh", InterFoamRun{50, 50, 1}), run("fine_mesh", InterFoamRun{50, 100, 1})};
  definition.gate = {surge_row("forced", Metric::amplitude_error, "1", 0.05),
                     surge_row("forced", Metric::phase_lag, "deg", 2),
                     surge_row("natural_1", Metric::frequency_error, "1", 0.015)};
  return definition;
}

// Li et al.'s tank and motion but for what a test changes.
struct Theory {
  double gravity = 9.81;                     // [m/s2]
  double amplitude = 0.02;                   // [m], of the tank's motion
  double gas_density = 0;                    // [kg/m3]; 0: one layer
  double angular_frequency = 0.3 * 4.94488;  // [rad/s]

  auto operator<=>(const Theory&) const = default;
};

inline TimeSeries elevation_of(const Theory& theory) {
  static std::map<Theory, TimeSeries> computed;
  if (computed.contains(theory)) return computed.at(theory);
  const reference::Tank tank{1, 0.35, theory.gravity, 1000};
  const reference::SineSurge motion{theory.amplitude, theory.angular_frequency};
  constexpr auto start = reference::Start::earth;
  constexpr int modes = 500;
  const auto solution =
      theory.gas_density > 0
          ? reference::LinearSurge(tank, {theory.gas_density, 0.65}, start, motion, modes)
          : reference::LinearSurge(tank, start, motion, modes);
  TimeSeries series{surge_quantity, "m", {}, {}};
  for (int i = 0; i <= 500; ++i) series.time.push_back(0.04 * i);
  series.value = solution.elevation(0.45, series.time);
  return computed[theory] = series;
}

inline RunResult result_of(const std::string& run, const TimeSeries& elevation) {
  RunResult result;
  result.case_name = "small_surge";
  result.run_name = run;
  result.solver = "made by hand";
  result.key = "0123456789abcdef";
  result.provenance = {{"slosh_version", "0"},
                       {"compiler", "none"},
                       {"date_utc", "2000-01-01T00:00:00Z"},
                       {"processor", "none"},
                       {"command", "./slosh run small_surge " + run}};
  result.active_terms = {"none"};
  result.diagnostics = {{"highest_elevation_over_depth", 0.027}};
  result.cost = {.wall_time = 1, .user_time = 1, .steps = 10, .elements = 100};
  result.series = {elevation};
  if (run.starts_with("theory"))  // exact, until a test moves what linear theory leaves beside it
    for (const char* suffix : {finer, nonlinear}) {
      result.series.push_back(elevation);
      result.series.back().name += suffix;
    }
  return result;
}

inline CaseRuns surge_runs() {
  CaseRuns runs;
  const TimeSeries one_layer = elevation_of({});
  const TimeSeries two_layers = elevation_of({.gas_density = 1.2});
  for (const auto& [run, series] : {std::pair{"theory", one_layer},
                                    {"theory_with_gas", two_layers},
                                    {"particles", one_layer},
                                    {"coarse_mesh", two_layers},
                                    {"fine_mesh", two_layers}}) {
    runs.results[run] = result_of(run, series);
    runs.status[run] = {RunState::finished, ""};
  }
  return runs;
}

inline TimeSeries scaled(TimeSeries series, double factor) {
  for (double& value : series.value) value *= factor;
  return series;
}

struct ScaledRun {
  std::string name;
  decltype(RunDefinition::solver) solver;
  double scale;  // of theory's elevation: the error is this less one
  RunCost cost;
};

// The surge with these runs instead of its own.
inline CaseAssessment assess_scaled(const std::vector<ScaledRun>& scaled_runs) {
  CaseDefinition definition = surge_case();
  definition.gate.clear();
  definition.runs = {definition.runs.at(0)};
  CaseRuns runs;
  runs.results["theory"] = surge_runs().results.at("theory");
  runs.status["theory"] = {RunState::finished, ""};
  for (const ScaledRun& one : scaled_runs) {
    definition.runs.push_back(sample_run(one.solver));
    definition.runs.back().name = one.name;
    runs.results[one.name] = result_of(one.name, scaled(elevation_of({}), one.scale));
    runs.results[one.name].cost = one.cost;
    runs.status[one.name] = {RunState::finished, ""};
  }
  return assess(definition, std::move(runs));
}

inline CaseRuns surge_runs_with(const std::string& run, const TimeSeries& elevation) {
  CaseRuns runs = surge_runs();
  runs.results[run] = result_of(run, elevation);
  return runs;
}

// A run that left no result.
inline CaseRuns surge_runs_without(const std::string& run, RunState why,
                                   const std::string& message) {
  CaseRuns runs = surge_runs();
  runs.results.erase(run);
  runs.status[run] = {why, message};
  return runs;
}

}  // namespace slosh
