#include "verification/campaign/case_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "verification/campaign/campaign_run.hpp"

namespace slosh {
namespace {

using reports::Table;

std::string percent(const Estimate& estimate) {
  return fmt::format("{:+.2f} ± {:.2f} %", 100 * estimate.value, 100 * estimate.half_width);
}

std::string with_interval(const Estimate& estimate, const char* unit) {
  return fmt::format("{:+.3g} ± {:.2g} {}", estimate.value, estimate.half_width, unit);
}

std::string allowed(const GateRow& row) {
  const auto in_unit = [&](double value) {
    return row.unit == "1" ? fmt::format("{:.3g} %", 100 * value)
                           : fmt::format("{:.3g} {}", value, row.unit);
  };
  if (row.limit) return "at most " + in_unit(*row.limit);
  if (row.between) return in_unit(row.between->first) + " to " + in_unit(row.between->second);
  return "below that of " + *row.improves_on;
}

std::string state_name(RunState state) {
  switch (state) {
    case RunState::finished:
      return "finished";
    case RunState::failed:
      return "solver failed";
    case RunState::not_selected:
      return "not selected";
    case RunState::out_of_range:
      return "out of range";
  }
  throw std::logic_error("a state without a name");
}

std::string peaks(const std::vector<SpectralPeak>& found) {
  std::vector<std::string> texts;
  for (const SpectralPeak& peak : found)
    texts.push_back(fmt::format("{:.3f} Hz ({:.2e} m2)", peak.frequency, peak.power));
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace

Table gate_table(const std::vector<CaseAssessment>& cases) {
  Table table{"gate",
              "Gate",
              "Every row of every case file. A value that is no number, a series that ends early "
              "and a reference that is "
              "missing or out of its range never pass.",
              {"verdict", "case", "candidate", "reference", "quantity", "mode", "metric", "found",
               "allowed", "reason", "source"},
              {}};
  for (const CaseAssessment& one : cases)
    for (const GateOutcome& outcome : one.gate) {
      const GateRow& row = outcome.row;
      table.rows.push_back({verdict_name(outcome.verdict), one.definition.name, row.candidate,
                            row.reference, row.quantity, row.mode, metric_name(row.metric),
                            outcome.message, allowed(row), row.reason, row.source});
    }
  return table;
}

Table mode_table(const CaseAssessment& assessment) {
  Table table{assessment.definition.name + "-modes",
              "Fitted modes",
              "Harmonic least squares over the comparison window, forcing and natural modes "
              "together, natural modes with "
              "free frequency and decay; 95 % intervals. A positive lag is late.",
              {"candidate", "reference", "mode", "reference amplitude", "amplitude error", "lag",
               "lag [periods]", "frequency error", "decay of the candidate"},
              {}};
  for (const Comparison& pair : assessment.comparisons)
    for (const ModeComparison& mode : pair.modes)
      table.rows.push_back(
          {pair.candidate, pair.reference, mode.mode,
           fmt::format("{:.3f} mm", 1000 * mode.reference.amplitude.value),
           percent(mode.amplitude_error),
           with_interval(mode.phase_lag_degrees, "deg") +
               fmt::format(" ({:+.4f} s)", mode.phase_lag.value),
           fmt::format("{:+.4f}", mode.phase_lag_periods.value),
           mode.mode == "forced" ? "given" : percent(mode.frequency_error),
           mode.mode == "forced" ? "none" : with_interval(mode.decay_rate, "1/s")});
  return table;
}

Table history_table(const CaseAssessment& assessment) {
  Table table{assessment.definition.name + "-histories",
              "Whole histories",
              "Normalised rms: rms of the residual over rms of the reference. Peaks of the "
              "spectrum, highest first.",
              {"candidate", "reference", "normalised rms", "largest residual",
               "peaks of the candidate", "peaks of the reference"},
              {}};
  for (const Comparison& pair : assessment.comparisons)
    table.rows.push_back({pair.candidate, pair.reference,
                          fmt::format("{:.2f} %", 100 * pair.normalised_rms),
                          fmt::format("{:.3f} mm", 1000 * pair.maximum_residual),
                          peaks(pair.candidate_peaks), peaks(pair.reference_peaks)});
  return table;
}

Table cost_table(const CaseAssessment& assessment) {
  Table table{assessment.definition.name + "-cost-table",
              "Runs and their cost",
              "Times and peak memory as the operating system accounts for the run's own process "
              "and its children.",
              {"run", "state", "solver", "particles or cells", "steps", "user [s]", "system [s]",
               "wall [s]", "peak memory [MiB]", "remark"},
              {}};
  for (const RunDefinition& run : assessment.definition.runs) {
    const RunStatus& status = assessment.runs.status.at(run.name);
    std::vector<std::string> row{run.name, state_name(status.state)};
    const auto result = assessment.runs.results.find(run.name);
    if (result == assessment.runs.results.end()) {
      row.insert(row.end(), 7, "");
    } else {
      const RunCost& cost = result->second.cost;
      row.insert(row.end(),
                 {result->second.solver, fmt::format("{}", cost.elements),
                  fmt::format("{}", cost.steps), fmt::format("{:.2f}", cost.user_time),
                  fmt::format("{:.2f}", cost.system_time), fmt::format("{:.2f}", cost.wall_time),
                  fmt::format("{:.0f}", cost.peak_memory / 1048576)});
    }
    row.push_back(status.message);
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table provenance_table(const CaseAssessment& assessment) {
  Table table{assessment.definition.name + "-provenance",
              "Terms, diagnostics and provenance",
              "The physics that was active, what the run recorded of itself, and the command that "
              "repeats it.",
              {"run", "active terms", "diagnostics", "provenance", "repeat with"},
              {}};
  for (const RunDefinition& run : assessment.definition.runs) {
    const auto found = assessment.runs.results.find(run.name);
    if (found == assessment.runs.results.end()) continue;
    const RunResult& result = found->second;
    std::vector<std::string> diagnostics, provenance;
    for (const auto& [name, value] : result.diagnostics)
      diagnostics.push_back(fmt::format("{} = {:.6g}", name, value));
    for (const auto& [name, value] : result.provenance)
      if (name != "command") provenance.push_back(name + ": " + value);
    provenance.push_back("key: " + result.key);
    table.rows.push_back({run.name, fmt::format("{}", fmt::join(result.active_terms, "; ")),
                          fmt::format("{}", fmt::join(diagnostics, "; ")),
                          fmt::format("{}", fmt::join(provenance, "; ")),
                          fmt::format("`{}`", repeat_command(assessment.definition, run))});
  }
  return table;
}

}  // namespace slosh
