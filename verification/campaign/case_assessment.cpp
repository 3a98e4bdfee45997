#include "verification/campaign/case_assessment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>

#include "reference/linear_surge.hpp"
#include "verification/campaign/filtered_pressure.hpp"
#include "verification/case_file/motion.hpp"
#include "verification/case_file/natural_modes.hpp"
#include "verification/case_file/quantities.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/metrics/windowed_series.hpp"

namespace slosh {
namespace {

template <class Solver>
const Solver* solver_as(const CaseDefinition& definition, const std::string& run) {
  return std::get_if<Solver>(&run_named(definition, run).solver);
}

bool stands(const CaseRuns& runs, const std::string& run) { return runs.results.contains(run); }

bool is_theory(const RunDefinition& run) {
  return std::holds_alternative<LinearRun>(run.solver) ||
         std::holds_alternative<ViscousWaveRun>(run.solver);
}

// Of a theory; none of other runs.
std::optional<double> valid_elevation_over_depth(const RunDefinition& run) {
  if (const auto* linear = std::get_if<LinearRun>(&run.solver))
    return linear->valid_elevation_over_depth;
  if (const auto* viscous = std::get_if<ViscousWaveRun>(&run.solver))
    return viscous->valid_elevation_over_depth;
  return {};
}

// A reference may gate only where its own prediction stays within the range that the case declares
// for it.
void mark_references_out_of_range(const CaseDefinition& definition, CaseRuns& runs) {
  for (const auto& [name, result] : runs.results) {
    const auto valid = valid_elevation_over_depth(run_named(definition, name));
    if (!valid) continue;
    const auto recorded = result.diagnostics.find("highest_elevation_over_depth");
    const double ratio = recorded == result.diagnostics.end()
                             ? std::numeric_limits<double>::quiet_NaN()
                             : recorded->second;
    if (!(ratio <= *valid))
      runs.status[name] = {
          RunState::out_of_range,
          fmt::format("predicts an elevation of {:.3g} fill depths, valid to {:.3g}", ratio,
                      *valid)};
  }
}

// The finest interFoam that stands, which SPH is compared with; empty where there is none.
std::string finest_interfoam(const CaseDefinition& definition, const CaseRuns& runs) {
  std::string finest;
  int most_cells = 0;
  for (const auto& [name, result] : runs.results) {
    const InterFoamRun* mesh = solver_as<InterFoamRun>(definition, name);
    if (!mesh || mesh->cells_x * mesh->cells_z <= most_cells) continue;
    most_cells = mesh->cells_x * mesh->cells_z;
    finest = name;
  }
  return finest;
}

bool has_two_layer_theory(const CaseDefinition& definition) {
  return std::any_of(definition.runs.begin(), definition.runs.end(), [](const RunDefinition& run) {
    const LinearRun* linear = std::get_if<LinearRun>(&run.solver);
    return linear && linear->two_layer;
  });
}

using Pair = std::pair<std::string, std::string>;

// Candidate and reference, in the order of the case file.
std::vector<Pair> compared_pairs(const CaseDefinition& definition, const CaseRuns& runs) {
  const std::string mesh = finest_interfoam(definition, runs);
  const bool two_layers = has_two_layer_theory(definition);
  std::vector<Pair> pairs;
  for (const RunDefinition& candidate : definition.runs) {
    if (!stands(runs, candidate.name) || is_theory(candidate) ||
        std::holds_alternative<RecordRun>(candidate.solver))
      continue;
    const bool sees_gas = std::holds_alternative<InterFoamRun>(candidate.solver);
    for (const RunDefinition& reference : definition.runs) {
      if (!stands(runs, reference.name)) continue;
      const LinearRun* linear = std::get_if<LinearRun>(&reference.solver);
      const bool of_its_kind = linear ? linear->two_layer == (sees_gas && two_layers)
                                      : !std::holds_alternative<SphRun>(reference.solver) &&
                                            !std::holds_alternative<InterFoamRun>(reference.solver);
      if (of_its_kind) pairs.push_back({candidate.name, reference.name});
    }
    if (!sees_gas && !mesh.empty()) pairs.push_back({candidate.name, mesh});
  }
  return pairs;
}

// A record is compared on what it recorded; any two solvers on what the case's gauges ask for, and
// on whatever else both left.
std::vector<std::string> quantities_of(const CaseDefinition& definition, const CaseRuns& runs,
                                       const Pair& pair) {
  if (const RecordRun* record = solver_as<RecordRun>(definition, pair.second))
    return {record->quantity};
  std::vector<std::string> quantities = compared_quantities(definition);
  std::erase_if(quantities, [&](const std::string& quantity) {
    return !is_gauged(quantity) &&
           !(has_series(runs, pair.first, quantity) && has_series(runs, pair.second, quantity));
  });
  return quantities;
}

// The case's, or what a record covers of it: a candidate must cover it all.
TimeWindow window_of(const CaseDefinition& definition, const std::string& reference) {
  TimeWindow window{definition.window_begin, definition.window_end};
  if (const RecordRun* record = solver_as<RecordRun>(definition, reference)) {
    window.begin = std::max(window.begin, record->time.front());
    window.end = std::min(window.end, record->time.back());
  }
  return window;
}

// A record may be too short or too sparse for the modes: then the histories alone are compared.
Comparison compare_with_record(const TimeSeries& candidate, const TimeSeries& record,
                               TimeWindow window, const std::vector<ToneRequest>& modes) {
  try {
    return compare(candidate, record, window, modes);
  } catch (const ComparisonError&) {
    return compare(candidate, record, window, {});
  }
}

Comparison compare_runs(const CaseDefinition& definition, const CaseRuns& runs, const Pair& pair,
                        const std::string& quantity, const std::vector<ToneRequest>& all_modes) {
  const TimeSeries& candidate = runs.results.at(pair.first).at(quantity);
  const TimeSeries& reference = runs.results.at(pair.second).at(quantity);
  const TimeWindow window = window_of(definition, pair.second);
  const auto modes = has_modes(quantity) ? all_modes : std::vector<ToneRequest>{};
  Comparison comparison = solver_as<RecordRun>(definition, pair.second)
                              ? compare_with_record(candidate, reference, window, modes)
                              : compare(candidate, reference, window, modes);
  comparison.candidate = pair.first;
  comparison.reference = pair.second;
  return comparison;
}

}  // namespace

bool has_series(const CaseRuns& runs, const std::string& run, const std::string& quantity) {
  const auto& series = runs.results.at(run).series;
  return std::any_of(series.begin(), series.end(),
                     [&](const TimeSeries& one) { return one.name == quantity; });
}

std::vector<const Comparison*> judging_comparisons(const CaseAssessment& assessment) {
  const std::string quantity = compared_quantities(assessment.definition).front();
  std::vector<const Comparison*> judging;
  std::set<std::string> counted;
  for (const Comparison& comparison : assessment.comparisons)
    if (comparison.quantity == quantity &&
        assessment.runs.status.at(comparison.reference).state != RunState::out_of_range &&
        counted.insert(comparison.candidate).second)
      judging.push_back(&comparison);
  return judging;
}

const TimeSeries* series_of_record(const CaseAssessment& assessment, const std::string& quantity) {
  for (const RunDefinition& run : assessment.definition.runs)
    if (std::holds_alternative<RecordRun>(run.solver) && stands(assessment.runs, run.name) &&
        has_series(assessment.runs, run.name, quantity))
      return &assessment.runs.results.at(run.name).at(quantity);
  return nullptr;
}

const Comparison* comparison_with_truth(const CaseAssessment& assessment, const std::string& run) {
  for (const Comparison* judging : judging_comparisons(assessment))
    if (judging->candidate == run &&
        !solver_as<InterFoamRun>(assessment.definition, judging->reference))
      return judging;
  return nullptr;
}

const RunDefinition& run_named(const CaseDefinition& definition, const std::string& name) {
  const auto found = std::find_if(definition.runs.begin(), definition.runs.end(),
                                  [&](const RunDefinition& run) { return run.name == name; });
  if (found == definition.runs.end())
    throw std::invalid_argument("case " + definition.name + " has no run " + name);
  return *found;
}

std::vector<ToneRequest> modes_of(const CaseDefinition& definition, int count) {
  const reference::Tank tank{definition.tank.length, definition.liquid.fill_depth,
                             definition.gravity, definition.liquid.density};
  std::vector<ToneRequest> modes;
  const double forcing = forcing_frequency(definition);
  if (forcing > 0) modes.push_back({"forced", forcing, false});
  const std::vector<int> natural = natural_modes(definition, count);
  for (std::size_t n = 0; n < natural.size(); ++n)
    modes.push_back(
        {fmt::format("natural_{}", n + 1), reference::natural_frequency(tank, natural[n]), true});
  return modes;
}

std::vector<ToneRequest> fitted_modes(const CaseDefinition& definition) {
  return modes_of(definition, definition.natural_modes);
}

CaseAssessment assess(const CaseDefinition& definition, CaseRuns runs) {
  mark_references_out_of_range(definition, runs);
  std::vector<std::string> not_filtered = add_filtered_pressures(definition, runs);
  CaseAssessment assessment{definition, std::move(runs), {}, std::move(not_filtered), {}};
  const std::vector<ToneRequest> modes = fitted_modes(definition);
  std::map<std::string, Comparison> computed;
  const FindComparison find = [&](const std::string& candidate, const std::string& reference,
                                  const std::string& quantity) -> const Comparison& {
    const std::string key = candidate + "\n" + reference + "\n" + quantity;
    const auto known = computed.find(key);
    if (known != computed.end()) return known->second;
    return computed
        .emplace(key,
                 compare_runs(definition, assessment.runs, {candidate, reference}, quantity, modes))
        .first->second;
  };
  for (const Pair& pair : compared_pairs(definition, assessment.runs))
    for (const std::string& quantity : quantities_of(definition, assessment.runs, pair)) {
      try {
        assessment.comparisons.push_back(find(pair.first, pair.second, quantity));
      } catch (const std::runtime_error& error) {  // ComparisonError and ResultError
        assessment.not_comparable.push_back(
            fmt::format("{} against {}: {}", pair.first, pair.second, error.what()));
      }
    }
  const FindSeries find_series = [&](const std::string& run, const std::string& quantity) {
    return cut_to_window(assessment.runs.results.at(run).at(quantity),
                         {definition.window_begin, definition.window_end});
  };
  const MeasureImpacts measure_impacts = [&](const std::string& run, const GateRow& row) {
    return impact_metric(row.metric, row.mode, assessment.runs.results.at(run).at(row.quantity),
                         series_of_record(assessment, row.quantity), definition);
  };
  for (const GateRow& row : definition.gate)
    assessment.gate.push_back(
        evaluate(row, assessment.runs.status, {find, find_series, measure_impacts}));
  return assessment;
}

int exit_status(const std::vector<CaseAssessment>& cases) {
  std::vector<GateOutcome> outcomes;
  bool nothing_to_judge = false;
  for (const CaseAssessment& one : cases) {
    for (const auto& [run, status] : one.runs.status) {
      if (status.state == RunState::failed) return exit_solver_failed;
      nothing_to_judge |= status.state == RunState::missing;
    }
    nothing_to_judge |= one.comparisons.empty() && !one.not_comparable.empty();
    outcomes.insert(outcomes.end(), one.gate.begin(), one.gate.end());
  }
  const int gated = exit_status(outcomes);
  return gated == exit_pass && nothing_to_judge ? exit_not_compared : gated;
}

}  // namespace slosh
