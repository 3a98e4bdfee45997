#include "verification/assessment/references/case_theories.hpp"

#include <fmt/format.h>

#include <string_view>

#include "verification/assessment/validity_envelope.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/history_uncertainty.hpp"

namespace slosh {
namespace {

std::string uncertainty_text(const CaseDefinition& definition, const RunDefinition& run,
                             const RunResult& result) {
  if (std::string_view(solver_kind(run).leaves.front()) == coarser)
    return fmt::format(
        "the series with {} at their end hold half the 95 % interval at each sample: the "
        "difference "
        "from the same flow with fewer nodes",
        half_width_suffix);
  return fmt::format(
      "what linear equations leave out, which gate rows count by an estimate of the third order; "
      "the second adds about k A / 2 = {:.2g} of the wave to a crest",
      predicted_steepness(definition, result) / 2);
}

TheoryRemarks remarks_on(const CaseDefinition& definition, const RunDefinition& run,
                         const RunResult& result) {
  return {run.name, solver_text(run), validity_range(definition, run, result),
          uncertainty_text(definition, run, result), outside_validity(definition, run, result)};
}

// Adds the run's series, each with its half widths behind it where these are known.
void add_series(const CaseDefinition& definition, const CaseRuns& runs, const RunDefinition& run,
                RunResult& joint) {
  for (const TimeSeries& series : runs.results.at(run.name).series) {
    const auto is_left_beside = [&](const char* suffix) { return series.name.ends_with(suffix); };
    if (is_left_beside(coarser) || is_left_beside(finer) || is_left_beside(nonlinear)) continue;
    const std::string name = series.name + "/" + run.name;
    joint.series.push_back({name, series.unit, series.time, series.value});
    std::vector<double> widths = numerical_half_widths(definition, runs, run.name, series.name);
    if (!widths.empty())
      joint.series.push_back(
          {name + half_width_suffix, series.unit, series.time, std::move(widths)});
  }
}

}  // namespace

CaseTheories case_theories(const CaseDefinition& definition, const CaseRuns& runs) {
  CaseTheories theories{};
  RunResult& joint = theories.result;
  joint.case_name = definition.name;
  joint.run_name = "references";
  joint.solver = "references";
  joint.case_text = definition.text;
  for (const RunDefinition& run : definition.runs) {
    const auto found = runs.results.find(run.name);
    if (!is_theory(run) || found == runs.results.end()) continue;
    add_series(definition, runs, run, joint);
    const TheoryRemarks& remarks =
        theories.remarks.emplace_back(remarks_on(definition, run, found->second));
    joint.provenance[run.name] = remarks.solution;
    joint.provenance[run.name + "_range"] = remarks.range;
    joint.provenance[run.name + "_uncertainty"] = remarks.uncertainty;
    if (remarks.outside) joint.provenance[run.name + outside_its_range] = *remarks.outside;
  }
  return theories;
}

}  // namespace slosh
