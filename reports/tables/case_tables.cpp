#include "reports/tables/case_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "reports/tables/report_places.hpp"
#include "verification/assessment/work_points.hpp"
#include "verification/case/ensemble.hpp"

namespace slosh {
namespace {

using reports::Table;

std::string reference_name(const CaseAssessment& assessment, const Comparison& pair) {
  const bool valid = assessment.runs.status.at(pair.reference).state != RunState::out_of_range;
  return valid ? pair.reference : pair.reference + " (out of its range)";
}

std::string with_interval(const Estimate& estimate, double scale = 1) {
  return fmt::format("{:+.3g} ± {:.2g}", scale * estimate.value, scale * estimate.half_width);
}

// Amplitude error, lag three times, frequency error, decay. A candidate's mode that cannot be told
// from noise has none of them.
std::vector<std::string> mode_measures(const ModeComparison& mode) {
  if (!mode.candidate.resolved) return {"not resolved", "", "", "", "", ""};
  const bool forced = mode.mode == "forced";  // of a given frequency and without decay
  return {with_interval(mode.amplitude_error, 100),
          with_interval(mode.phase_lag_degrees),
          with_interval(mode.phase_lag),
          with_interval(mode.phase_lag_periods),
          forced ? "" : with_interval(mode.frequency_error, 100),
          forced ? "" : with_interval(mode.decay_rate)};
}

std::string allowed(const GateRow& row) {
  if (row.limit) return "at most " + in_unit(*row.limit, row.unit);
  if (row.between)
    return in_unit(row.between->first, row.unit) + " to " + in_unit(row.between->second, row.unit);
  return "below that of " + *row.improves_on;
}

// "10.4 ± 0.2 (5)"
std::string timed_text(const MeasuredCost& cost) {
  if (cost.timings == 0) return "";
  const Estimate& time = cost.core_seconds;
  return cost.has_interval()
             ? fmt::format("{:.3g} ± {:.2g} ({})", time.value, time.half_width, cost.timings)
             : fmt::format("{:.3g} (1)", time.value);
}

std::string rms_text(const Estimate& rms) {
  return rms.half_width > 0
             ? fmt::format("{:.2f} ± {:.2g} %", 100 * rms.value, 100 * rms.half_width)
             : fmt::format("{:.2f} %", 100 * rms.value);
}

// Of waves millimetres are read more easily than metres.
std::string length_in_mm(double value, const std::string& unit) {
  return unit == "m" ? fmt::format("{:.3f} mm", 1000 * value)
                     : fmt::format("{:.4g} {}", value, unit);
}

// "m" gives "m2", "N/m" "(N/m)2".
std::string squared(const std::string& unit) {
  return unit.find('/') == unit.npos ? unit + "2" : "(" + unit + ")2";
}

std::string peaks(const std::vector<SpectralPeak>& found, const std::string& unit) {
  std::vector<std::string> texts;
  for (const SpectralPeak& peak : found)
    texts.push_back(
        fmt::format("{:.3f} Hz ({:.2e} {})", peak.frequency, peak.power, squared(unit)));
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace

std::string measure_name(const GateRow& row) {
  std::string metric = measured_name(row);
  std::replace(metric.begin(), metric.end(), '_', ' ');
  return (row.mode == "whole" ? "" : row.mode + " ") + metric + " of " + row.quantity;
}

Table gate_table(const CaseAssessment& assessment) {
  const std::string& name = assessment.definition.name;
  Table table{name + "-gate",
              "Gate rows",
              "NaN, a series that ends early and a reference that is missing "
              "or out of its range never pass.",
              {"verdict", "candidate", "reference", "measure", "found"},
              {}};
  for (const GateOutcome& outcome : assessment.gate) {
    table.row_ids.push_back(case_row_id(name, table.rows.size()));
    table.rows.push_back({verdict_name(outcome.verdict), outcome.row.candidate,
                          outcome.row.reference.empty() ? "none" : outcome.row.reference,
                          measure_name(outcome.row), outcome.message});
  }
  return table;
}

Table limits_table(const CaseAssessment& assessment) {
  Table table{assessment.definition.name + "-limits",
              "Limits and their reasons",
              "",
              {"measure", "allowed", "reason", "source"},
              {}};
  for (const GateRow& row : assessment.definition.gate) {
    std::vector<std::string> line{measure_name(row), allowed(row), row.reason, row.source};
    if (std::find(table.rows.begin(), table.rows.end(), line) == table.rows.end())
      table.rows.push_back(std::move(line));
  }
  return table;
}

Table mode_table(const CaseAssessment& assessment) {
  Table table{
      assessment.definition.name + "-modes",
      "Fitted modes",
      "Harmonic least squares over the comparison window, forcing and natural modes together, "
      "natural modes with free frequency and decay; 95 % intervals. A positive lag is late.",
      {"candidate", "reference", "quantity", "mode", "amplitude error [%]", "lag [deg]", "lag [s]",
       "lag [periods]", "frequency error [%]", "decay [1/s]"},
      {}};
  for (const Comparison& pair : assessment.comparisons)
    for (const ModeComparison& mode : pair.modes) {
      std::vector<std::string> row{pair.candidate, reference_name(assessment, pair), pair.quantity,
                                   mode.mode};
      const std::vector<std::string> measures = mode_measures(mode);
      row.insert(row.end(), measures.begin(), measures.end());
      table.rows.push_back(std::move(row));
    }
  return table;
}

Table history_table(const CaseAssessment& assessment) {
  const bool swings = !fitted_modes(assessment.definition).empty();
  Table table{assessment.definition.name + "-histories",
              "Whole histories",
              "Normalised rms: rms of the residual over rms of the reference about its mean, with "
              "the 95 % interval that blocks of the window give.",
              {"candidate", "reference", "quantity", "normalised rms", "largest residual"},
              {}};
  if (swings) {
    table.caption += " Peaks of the spectrum, highest first.";
    table.header.insert(table.header.end(), {"peaks of the candidate", "peaks of the reference"});
  } else {
    table.caption += " The lag is the one that brings the candidate nearest; positive is late.";
    table.header.insert(table.header.end(), {"lag [s]", "normalised rms without the lag"});
  }
  for (const Comparison& pair : assessment.comparisons) {
    std::vector<std::string> row{pair.candidate, reference_name(assessment, pair), pair.quantity,
                                 rms_text(pair.normalised_rms),
                                 length_in_mm(pair.maximum_residual, pair.unit)};
    if (swings)
      row.insert(row.end(),
                 {peaks(pair.candidate_peaks, pair.unit), peaks(pair.reference_peaks, pair.unit)});
    else if (std::isnan(pair.alignment.lag))
      row.insert(row.end(), {"none found", ""});
    else
      row.insert(row.end(), {fmt::format("{:+.4f}", pair.alignment.lag),
                             fmt::format("{:.2f} %", 100 * pair.alignment.normalised_rms)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table cost_table(const CaseAssessment& assessment) {
  Table table{
      assessment.definition.name + "-cost-table",
      "Runs and their cost",
      "Times and peak memory as the operating system accounts for the run's own process "
      "and its children. Timed alone: the mean over repeats that had a core for themselves, "
      "user and system time, with its 95 % interval and their number.",
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
      row.insert(
          row.end(),
          {result->second.solver, fmt::format("{}", cost.elements), fmt::format("{}", cost.steps),
           fmt::format("{:.2f}", cost.user_time), fmt::format("{:.2f}", cost.system_time),
           fmt::format("{:.2f}", cost.wall_time), fmt::format("{:.0f}", cost.peak_memory / 1048576),
           timed_text(cost_of(assessment.runs, run.name))});
    }
    row.push_back(status.message);
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::optional<Table> failure_table(const std::string& name,
                                   const std::map<std::string, RunStatus>& runs) {
  Table table{name + "-failures",
              "Failures",
              "How each run failed, and below that its program's own words.",
              {"run", "kind", "words", "log"},
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
  Table table{
      assessment.definition.name + "-terms",
      "Active terms and diagnostics",
      "The physics that was compiled in or switched on, and what the run recorded of itself.",
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
  Table table{assessment.definition.name + "-provenance",
              "Provenance",
              "The whole key stands in the result file and in `results.json`.",
              {"run", "made by", "on", "key", "repeat with"},
              {}};
  std::set<std::string> flags;
  for (const RunDefinition& run : assessment.definition.runs) {
    const auto found = assessment.runs.results.find(run.name);
    if (found == assessment.runs.results.end()) continue;
    const auto& origin = found->second.provenance;
    if (const auto of = origin.find("compiler_flags"); of != origin.end()) flags.insert(of->second);
    const auto openfoam = origin.find("openfoam_version");
    table.rows.push_back(
        {run.name,
         fmt::format("Slosh {}, {}{}", origin.at("slosh_version"), origin.at("compiler"),
                     openfoam == origin.end() ? "" : ", OpenFOAM " + openfoam->second),
         fmt::format("{}, {}", origin.at("date_utc"), origin.at("processor")),
         fmt::format("`{}`", found->second.key.substr(0, 8)),
         fmt::format("`{}`", origin.at("command"))});
  }
  if (!flags.empty())
    table.caption += fmt::format(" Compiler flags: `{}`.", fmt::join(flags, "`; `"));
  return table;
}

}  // namespace slosh
