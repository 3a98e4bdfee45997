// What a particle's step costs in each code.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>

#include "reports/tables/case_tables.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/assessment/work_points.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

using reports::Table;

std::string nanoseconds(double seconds, double particle_steps) {
  return fmt::format("{:.3g}", 1e9 * seconds / particle_steps);
}

template <class Values>
std::optional<typename Values::mapped_type> value_of(const Values& values, const char* key) {
  const auto found = values.find(key);
  if (found == values.end()) return std::nullopt;
  return found->second;
}

// Those of interFoam are not Slosh's.
std::string flags_of(const std::map<std::string, std::string>& origin) {
  if (origin.contains("openfoam_version")) return "";
  return value_of(origin, "compiler_flags").value_or("");
}

std::vector<std::string> row_of(const std::string& run, const RunResult& result,
                                double core_seconds_of_run) {
  const auto loop = value_of(result.diagnostics, "loop_processor_time_s");
  const auto walls = value_of(result.diagnostics, "wall_particles");
  const auto evaluations = value_of(result.diagnostics, "evaluations_per_step");
  const auto sound = value_of(result.diagnostics, "speed_of_sound_m_s");
  const double seconds = loop.value_or(core_seconds_of_run);
  const double liquid = result.cost.elements, steps = result.cost.steps;
  return {run,
          fmt::format("{:.0f}", liquid),
          walls ? fmt::format("{:.0f}", *walls) : "",
          fmt::format("{:.0f}", steps),
          evaluations ? fmt::format("{:.0f}", *evaluations) : "",
          loop ? "time loop" : "whole run",
          nanoseconds(seconds, liquid * steps),
          walls ? nanoseconds(seconds, (liquid + *walls) * steps) : "",
          sound ? fmt::format("{:.3g}", *sound) : "",
          flags_of(result.provenance)};
}

// Returns "10.4 ± 0.2 (5)": core-seconds, half width of the 95 % interval, number of timings.
std::string timed_text(const MeasuredCost& cost) {
  if (cost.timings == 0) return "";
  const Estimate& time = cost.core_seconds;
  return cost.has_interval() ? fmt::format("{} ({})", interval_text(time), cost.timings)
                             : fmt::format("{:.3g} (1)", time.value);
}

std::string count_text(double count) { return count > 0 ? fmt::format("{}", count) : ""; }

// What a stored result does not tell stays blank.
std::vector<std::string> time_and_memory(const RunCost& cost, bool is_stored) {
  if (!is_stored)
    return {fmt::format("{:.2f}", cost.user_time), fmt::format("{:.2f}", cost.system_time),
            fmt::format("{:.2f}", cost.wall_time),
            fmt::format("{:.0f}", cost.peak_memory / 1048576)};
  return {fmt::format("{:.2f}", cost.user_time), "",
          cost.wall_time > 0 ? fmt::format("{:.2f}", cost.wall_time) : "", ""};
}

// Returns the largest magnitude within the window; "not available" where a value is not finite.
std::string largest(const TimeSeries& series, TimeWindow window) {
  double largest = 0;
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    if (series.time[i] < window.begin || series.time[i] > window.end) continue;
    if (!std::isfinite(series.value[i])) return "not available";
    largest = std::max(largest, std::abs(series.value[i]));
  }
  return fmt::format("{:.2g}", largest);
}

// Those of a stored result are when and where it was computed, with its remark.
std::string date_and_processor(const std::map<std::string, std::string>& origin) {
  if (!origin.contains("stored_software"))
    return fmt::format("{}, {}", origin.at("date_utc"), origin.at("processor"));
  const auto remark = origin.find("stored_remark");
  return fmt::format("{}, {}{}", origin.at("stored_date"), origin.at("stored_machine"),
                     remark == origin.end() ? "" : ". " + remark->second);
}

}  // namespace

std::optional<Table> step_table(const CaseAssessment& assessment) {
  Table table{case_id(assessment.definition.name) + "-step-table",
              "Cost of a particle's step",
              "Core-seconds over the number of steps and of particles: those of the liquid, or "
              "cells, and those of the liquid and the walls. A code that tells the time of its "
              "time loop is counted by that, another by the whole run. What a code does not tell "
              "is blank.",
              {"run", "liquid particles or cells", "wall particles", "steps",
               "evaluations of the forces per step", "counted", "per liquid particle and step [ns]",
               "per particle and step [ns]", "speed of sound [m/s]", "compiler flags"},
              {}};
  const CaseRuns& runs = assessment.runs;
  bool compares_codes = false;
  for (const RunDefinition& run : assessment.definition.runs) {
    const auto result = runs.results.find(run.name);
    if (is_later_member(run) || !is_simulation(run) || result == runs.results.end()) continue;
    const RunCost& cost = result->second.cost;
    if (!(cost.elements > 0 && cost.steps > 0)) continue;
    compares_codes =
        compares_codes || std::holds_alternative<ExternalRun>(run.solver) || is_stored(run);
    table.rows.push_back(
        row_of(run.name, result->second, cost_of(runs, run.name).core_seconds.value));
  }
  if (!compares_codes) return std::nullopt;
  return table;
}

std::string software_text(const std::map<std::string, std::string>& origin) {
  if (const auto stored = origin.find("stored_software"); stored != origin.end())
    return fmt::format("{}, computed elsewhere, read by Slosh {}", stored->second,
                       origin.at("slosh_version"));
  if (origin.contains("external_command")) {
    const auto version = origin.find("external_version");
    return fmt::format(
        "{}, started by Slosh {}",
        version == origin.end() ? "a program that does not tell its version" : version->second,
        origin.at("slosh_version"));
  }
  const auto openfoam = origin.find("openfoam_version");
  return fmt::format("Slosh {}, {}{}", origin.at("slosh_version"), origin.at("compiler"),
                     openfoam == origin.end() ? "" : ", OpenFOAM " + openfoam->second);
}

std::optional<Table> rest_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const TimeWindow whole{0, definition.duration};
  const TimeWindow late{definition.window_begin, definition.window_end};
  Table table{
      case_id(definition.name) + "-rest",
      "Deviation from rest",
      fmt::format("Largest magnitudes over the whole run and from {} to {} s. Hydrostatic pressure "
                  "error: rms difference from the hydrostatic pressure, over the hydrostatic "
                  "pressure at the bottom. Kinetic over potential energy: kinetic energy, over the "
                  "potential energy of the liquid at rest. Wall gap: distance between a wall and "
                  "the nearest particles, in spacings. Volume drift: change of the liquid's "
                  "volume, over its volume at the start.",
                  late.begin, late.end),
      {"run"},
      {}};
  for (const std::string name : rest_quantities) {
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    table.header.push_back(words);
    table.header.push_back(fmt::format("{}, from {} s", words, late.begin));
  }
  for (const RunDefinition& run : definition.runs) {
    const auto result = assessment.runs.results.find(run.name);
    if (is_later_member(run) || result == assessment.runs.results.end() ||
        !has_series(assessment.runs, run.name, rest_quantities[0]))
      continue;
    std::vector<std::string> row{run.name};
    for (const char* name : rest_quantities)
      for (const TimeWindow window : {whole, late})
        row.push_back(largest(result->second.at(name), window));
    table.rows.push_back(std::move(row));
  }
  if (table.rows.empty()) return std::nullopt;
  return table;
}

Table cost_table(const CaseAssessment& assessment) {
  Table table{
      case_id(assessment.definition.name) + "-cost-table",
      "Cost of the runs",
      "Times and peak memory as the operating system reports them for the run's process and its "
      "children; those of a stored result are its own code's, with all its processor time as "
      "user time. Timed alone: user plus system time, averaged over repeated runs that had a core "
      "to themselves, with its 95 % interval and the number of repeats.",
      {"run", "state", "solver", "particles or cells", "steps", "user [s]", "system [s]",
       "wall [s]", "peak memory [MiB]", "timed alone [core-s]", "remark"},
      {}};
  for (const RunDefinition& run : assessment.definition.runs) {
    const RunStatus& status = assessment.runs.status.at(run.name);
    std::vector<std::string> row{run.name, state_name(status.state)};
    const auto result = assessment.runs.results.find(run.name);
    if (result == assessment.runs.results.end()) {
      row.insert(row.end(), 8, "");
    } else {
      const RunCost& cost = result->second.cost;
      row.insert(row.end(),
                 {result->second.solver, count_text(cost.elements), count_text(cost.steps)});
      for (std::string& cell : time_and_memory(cost, is_stored(run)))
        row.push_back(std::move(cell));
      row.push_back(timed_text(cost_of(assessment.runs, run.name)));
    }
    row.push_back(status.message);
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::optional<Table> failure_table(const std::string& name,
                                   const std::map<std::string, RunStatus>& runs) {
  Table table{case_id(name) + "-failures",
              "Failures",
              "How each run failed, followed by the messages of its program.",
              {"run", "kind", "message", "log"},
              {}};
  for (const auto& [run, status] : runs) {
    if (!status.failure) continue;
    const RunFailure& failure = *status.failure;
    table.rows.push_back({run, failure.kind, failure.message, failure.log});
    std::istringstream lines(failure.details);
    for (std::string line; std::getline(lines, line);) table.rows.push_back({"", "", line, ""});
  }
  if (table.rows.empty()) return std::nullopt;
  return table;
}

Table terms_table(const CaseAssessment& assessment) {
  Table table{case_id(assessment.definition.name) + "-terms",
              "Active terms and diagnostics",
              "The terms of the model that were active, and the diagnostics that the run recorded.",
              {"run", "active terms", "diagnostics"},
              {}};
  for (const RunDefinition& run : assessment.definition.runs) {
    const auto found = assessment.runs.results.find(run.name);
    if (is_later_member(run) || found == assessment.runs.results.end()) continue;
    std::vector<std::string> diagnostics;
    for (const auto& [name, value] : found->second.diagnostics)
      diagnostics.push_back(fmt::format("{} = {:.4g}", name, value));
    table.rows.push_back({run.name, fmt::format("{}", fmt::join(found->second.active_terms, "; ")),
                          fmt::format("{}", fmt::join(diagnostics, "; "))});
  }
  return table;
}

Table provenance_table(const CaseAssessment& assessment) {
  Table table{case_id(assessment.definition.name) + "-provenance",
              "Provenance",
              "The full key is in the result file and in `results.json`.",
              {"run", "software", "date and processor", "key", "command to repeat it"},
              {}};
  std::set<std::string> flags;
  for (const RunDefinition& run : assessment.definition.runs) {
    const auto found = assessment.runs.results.find(run.name);
    if (found == assessment.runs.results.end()) continue;
    const auto& origin = found->second.provenance;
    if (const auto of = origin.find("compiler_flags"); of != origin.end()) flags.insert(of->second);
    table.rows.push_back({run.name, software_text(origin), date_and_processor(origin),
                          fmt::format("`{}`", found->second.key.substr(0, 8)),
                          fmt::format("`{}`", origin.at("command"))});
  }
  if (!flags.empty())
    table.caption += fmt::format(" Compiler flags: `{}`.", fmt::join(flags, "`; `"));
  return table;
}

}  // namespace slosh
