#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "reports/tables/case_tables.hpp"
#include "reports/wording/case_text.hpp"
#include "verification/assessment/work_points.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

using reports::Table;

// Returns "" where the key is absent.
std::string value_of(const std::map<std::string, std::string>& values, const char* key) {
  const auto found = values.find(key);
  return found == values.end() ? "" : found->second;
}

TableRow step_row(const std::string& run, const RunResult& result, double core_seconds_of_run) {
  const auto told = [&](const char* name) {
    const auto found = result.diagnostics.find(name);
    return found == result.diagnostics.end() ? std::nullopt : std::optional(found->second);
  };
  const auto count = [](std::optional<double> n) { return n ? fmt::format("{:.0f}", *n) : ""; };
  const auto loop = told("loop_processor_time_s"), walls = told("wall_particles"),
             sound = told("speed_of_sound_m_s");
  const double liquid = result.cost.elements, steps = result.cost.steps;
  const auto nanoseconds = [&](double particles) {
    return fmt::format("{:.3g}", 1e9 * loop.value_or(core_seconds_of_run) / (particles * steps));
  };
  const bool is_mesh = result.provenance.contains("openfoam_version");  // its flags are not Slosh's
  return {run,
          count(liquid),
          count(walls),
          count(steps),
          count(told("evaluations_per_step")),
          loop ? "time loop" : "whole run",
          nanoseconds(liquid),
          walls ? nanoseconds(liquid + *walls) : "",
          sound ? fmt::format("{:.3g}", *sound) : "",
          is_mesh ? "" : value_of(result.provenance, "compiler_flags")};
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
TableRow time_and_memory(const RunCost& cost, bool is_stored) {
  const auto seconds = [](double time) { return fmt::format("{:.2f}", time); };
  if (!is_stored)
    return {seconds(cost.user_time), seconds(cost.system_time), seconds(cost.wall_time),
            fmt::format("{:.0f}", cost.peak_memory / 1048576)};
  return {seconds(cost.user_time), "", cost.wall_time > 0 ? seconds(cost.wall_time) : "", ""};
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
  const std::string remark = value_of(origin, "stored_remark");
  return fmt::format("{}, {}{}", origin.at("stored_date"), origin.at("stored_machine"),
                     remark.empty() ? "" : ". " + remark);
}

}  // namespace

Table case_table(const CaseDefinition& definition, const std::string& id, const std::string& title,
                 const std::string& caption, const TableRow& header) {
  return {case_id(definition.name) + "-" + id, title, caption, header};
}

const RunResult* find_result(const CaseRuns& runs, const std::string& run) {
  const auto found = runs.results.find(run);
  return found == runs.results.end() ? nullptr : &found->second;
}

Table step_table(const CaseAssessment& assessment) {
  Table table = case_table(
      assessment.definition, "step-table", "Cost of a particle's step",
      "Core-seconds over the number of steps and of particles: those of the liquid, or cells, and "
      "those of the liquid and the walls. A code that tells the time of its time loop is counted "
      "by that, another by the whole run. What a code does not tell is blank.",
      {"run", "liquid particles or cells", "wall particles", "steps",
       "evaluations of the forces per step", "counted", "per liquid particle and step [ns]",
       "per particle and step [ns]", "speed of sound [m/s]", "compiler flags"});
  const CaseRuns& runs = assessment.runs;
  bool compares_codes = false;
  for (const RunDefinition& run : assessment.definition.runs) {
    const RunResult* result = find_result(runs, run.name);
    if (is_later_member(run) || !is_simulation(run) || !result) continue;
    if (!(result->cost.elements > 0 && result->cost.steps > 0)) continue;
    compares_codes |= std::holds_alternative<ExternalRun>(run.solver) || is_stored(run);
    table.rows.push_back(step_row(run.name, *result, cost_of(runs, run.name).core_seconds.value));
  }
  if (!compares_codes) table.rows.clear();
  return table;
}

std::string software_text(const std::map<std::string, std::string>& origin) {
  if (origin.contains("stored_software"))
    return fmt::format("{}, computed elsewhere, read by Slosh {}", origin.at("stored_software"),
                       origin.at("slosh_version"));
  if (origin.contains("external_command"))
    return fmt::format("{}, started by Slosh {}",
                       origin.contains("external_version")
                           ? origin.at("external_version")
                           : "a program that does not tell its version",
                       origin.at("slosh_version"));
  return fmt::format(
      "Slosh {}, {}{}", origin.at("slosh_version"), origin.at("compiler"),
      origin.contains("openfoam_version") ? ", OpenFOAM " + origin.at("openfoam_version") : "");
}

Table rest_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const TimeWindow whole{0, definition.duration};
  const TimeWindow late{definition.window_begin, definition.window_end};
  Table table = case_table(
      definition, "rest", "Deviation from rest",
      fmt::format("Largest magnitudes over the whole run and from {} to {} s. Hydrostatic pressure "
                  "error: rms difference from the hydrostatic pressure, over the hydrostatic "
                  "pressure at the bottom. Kinetic over potential energy: kinetic energy, over the "
                  "potential energy of the liquid at rest. Wall gap: distance between a wall and "
                  "the nearest particles, in spacings. Volume drift: change of the liquid's "
                  "volume, over its volume at the start.",
                  late.begin, late.end),
      {"run"});
  for (std::string words : rest_quantities) {
    std::ranges::replace(words, '_', ' ');
    append(table.header, {words, fmt::format("{}, from {} s", words, late.begin)});
  }
  for (const RunDefinition& run : definition.runs) {
    if (is_later_member(run) || !has_series(assessment.runs, run.name, rest_quantities[0]))
      continue;
    const RunResult& result = assessment.runs.results.at(run.name);
    table.rows.push_back({run.name});
    for (const char* name : rest_quantities)
      append(table.rows.back(), {largest(result.at(name), whole), largest(result.at(name), late)});
  }
  return table;
}

Table cost_table(const CaseAssessment& assessment) {
  Table table = case_table(
      assessment.definition, "cost-table", "Cost of the runs",
      "Times and peak memory as the operating system reports them for the run's process and its "
      "children; those of a stored result are its own code's, with all its processor time as "
      "user time. Timed alone: user plus system time, averaged over repeated runs that had a core "
      "to themselves, with its 95 % interval and the number of repeats.",
      {"run", "state", "solver", "particles or cells", "steps", "user [s]", "system [s]",
       "wall [s]", "peak memory [MiB]", "timed alone [core-s]", "remark"});
  for (const RunDefinition& run : assessment.definition.runs) {
    const RunStatus& status = assessment.runs.status.at(run.name);
    TableRow row{run.name, state_name(status.state)};
    if (const RunResult* result = find_result(assessment.runs, run.name)) {
      const RunCost& cost = result->cost;
      append(row, {result->solver, count_text(cost.elements), count_text(cost.steps)});
      append(row, time_and_memory(cost, is_stored(run)));
      row.push_back(timed_text(cost_of(assessment.runs, run.name)));
    }
    row.resize(table.header.size() - 1);
    row.push_back(status.message);
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table failure_table(const std::string& name, const std::map<std::string, RunStatus>& runs) {
  Table table{case_id(name) + "-failures",
              "Failures",
              "How each run failed, followed by the messages of its program.",
              {"run", "kind", "message", "log"}};
  for (const auto& [run, status] : runs) {
    if (!status.failure) continue;
    const RunFailure& failure = *status.failure;
    table.rows.push_back({run, failure.kind, failure.message, failure.log});
    std::istringstream lines(failure.details);
    for (std::string line; std::getline(lines, line);) table.rows.push_back({"", "", line, ""});
  }
  return table;
}

Table terms_table(const CaseAssessment& assessment) {
  Table table = case_table(
      assessment.definition, "terms", "Active terms and diagnostics",
      "The terms of the model that were active, and the diagnostics that the run recorded.",
      {"run", "active terms", "diagnostics"});
  for (const RunDefinition& run : assessment.definition.runs) {
    const RunResult* result = find_result(assessment.runs, run.name);
    if (is_later_member(run) || !result) continue;
    TableRow diagnostics;
    for (const auto& [name, value] : result->diagnostics)
      diagnostics.push_back(fmt::format("{} = {:.4g}", name, value));
    table.rows.push_back({run.name, fmt::format("{}", fmt::join(result->active_terms, "; ")),
                          fmt::format("{}", fmt::join(diagnostics, "; "))});
  }
  return table;
}

Table provenance_table(const CaseAssessment& assessment) {
  Table table =
      case_table(assessment.definition, "provenance", "Provenance",
                 "The full key is in the result file and in `results.json`.",
                 {"run", "software", "date and processor", "key", "command to repeat it"});
  std::set<std::string> flags;
  for (const RunDefinition& run : assessment.definition.runs) {
    const RunResult* result = find_result(assessment.runs, run.name);
    if (!result) continue;
    const auto& origin = result->provenance;
    if (origin.contains("compiler_flags")) flags.insert(origin.at("compiler_flags"));
    table.rows.push_back({run.name, software_text(origin), date_and_processor(origin),
                          fmt::format("`{}`", result->key.substr(0, 8)),
                          fmt::format("`{}`", origin.at("command"))});
  }
  if (!flags.empty())
    table.caption += fmt::format(" Compiler flags: `{}`.", fmt::join(flags, "`; `"));
  return table;
}

}  // namespace slosh
