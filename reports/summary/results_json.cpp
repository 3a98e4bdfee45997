#include "reports/summary/results_json.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "reports/summary/shown_rows.hpp"
#include "verification/assessment/campaign_cost.hpp"
#include "verification/assessment/error_over_tolerance.hpp"
#include "verification/assessment/predictions.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/case/changed_input.hpp"
#include "verification/papers/claims.hpp"

namespace slosh {
namespace {

using Json = nlohmann::ordered_json;

// Null for an absent value and for an empty text.
template <class Value>
Json json_or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}
Json json_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

// The settings of an SPH run; a number of its scheme that it does not set is null.
Json sph_entry(const SphRun& sph) {
  Json numbers = Json::object();
  for (const auto& [name, number] : sph_number_names)
    numbers[name] = json_or_null(sph.numbers.*number);
  return {{"scheme", sph.scheme},
          {"particle_spacing_m", sph.particle_spacing},
          {"surface_particle_spacing_m", sph.surface_particle_spacing},
          {"variant", json_or_null(sph.variant)},
          {"initial_state", json_or_null(sph.initial_state)},
          {"expected_speed", sph.speed_from_coarse_run ? "coarse_run" : "estimate"},
          {"start_disorder", sph.start_disorder},
          {"start_seed", sph.start_disorder > 0 ? Json(sph.start_seed) : Json(nullptr)},
          {"start_rotation_deg", sph.start_rotation_deg},
          {"numbers", numbers}};
}

Json external_entry(const ExternalRun& external) {
  Json entry = Json::object();
  if (external.particle_spacing)
    entry = {{"method", external.method}, {"particle_spacing_m", *external.particle_spacing}};
  if (external.cores) entry["cores"] = *external.cores;
  return entry;
}

Json failure_entry(const RunFailure& failure) {
  return {{"kind", failure.kind},
          {"message", failure.message},
          {"details", failure.details},
          {"log", failure.log}};
}

// What a run or a problem took, without its repeats and its size.
Json cost_entry(const RunCost& cost) {
  return {{"user_time_s", cost.user_time},
          {"system_time_s", cost.system_time},
          {"wall_time_s", cost.wall_time},
          {"peak_memory_byte", cost.peak_memory}};
}

// The costs of a run's repeats that had a core to themselves, in the order in which they ran.
Json timings_entry(const CaseRuns& runs, const std::string& run) {
  Json list = Json::array();
  if (const auto found = runs.timings.find(run); found != runs.timings.end())
    for (const RunCost& cost : found->second) list.push_back(cost_entry(cost));
  return list;
}

Json count_entry(double count) { return count > 0 ? Json(count) : Json(nullptr); }

Json run_entry(const RunDefinition& run, const CaseRuns& runs) {
  const std::string& name = run.name;
  const RunStatus& status = runs.status.at(name);
  Json entry{{"name", name}, {"state", state_name(status.state)}, {"message", status.message}};
  if (!run.ensemble.empty()) entry["ensemble"] = run.ensemble;
  for (const auto& [input, change] : run.drawn_inputs)
    entry["drawn_inputs"].push_back({{"input", input_name(input)}, {"change", change}});
  if (const auto* sph = std::get_if<SphRun>(&run.solver)) entry.update(sph_entry(*sph));
  if (const auto* external = std::get_if<ExternalRun>(&run.solver))
    entry.update(external_entry(*external));
  if (const auto* stored = std::get_if<StoredRun>(&run.solver); stored && !stored->method.empty())
    entry.update({{"method", stored->method}, {"particle_spacing_m", stored->particle_spacing}});
  if (status.failure) entry["failure"] = failure_entry(*status.failure);
  const auto found = runs.results.find(name);
  if (found == runs.results.end()) return entry;
  const RunResult& result = found->second;
  entry.update({{"solver", result.solver}, {"key", result.key}});
  entry.update(cost_entry(result.cost));
  entry.update({{"timings", timings_entry(runs, name)},
                {"steps", count_entry(result.cost.steps)},
                {"elements", count_entry(result.cost.elements)},
                {"active_terms", result.active_terms},
                {"diagnostics", result.diagnostics},
                {"provenance", result.provenance}});
  return entry;
}

Json peaks(const std::vector<SpectralPeak>& found) {
  Json list = Json::array();
  for (const SpectralPeak& peak : found)
    list.push_back({{"frequency_Hz", peak.frequency}, {"power", peak.power}});
  return list;
}

Json field_entry(const FieldComparison& pair, const CaseDefinition& definition) {
  Json moments = Json::array();
  for (const FieldDifference& moment : pair.moments)
    moments.push_back({{"time_s", moment.time},
                       {"compared_cells", moment.compared_cells},
                       {"pressure_rms_Pa", moment.pressure_rms},
                       {"pressure_rms", moment.pressure_rms / pressure_under_depth(definition)},
                       {"pressure_offset_Pa", moment.pressure_offset},
                       {"lowest_pressure_Pa", moment.lowest_pressure},
                       {"reference_lowest_pressure_Pa", moment.reference_lowest_pressure},
                       {"tension_share", moment.tension_share},
                       {"reference_tension_share", moment.reference_tension_share},
                       {"uncovered_share", moment.uncovered_share},
                       {"excess_share", moment.excess_share}});
  return {{"candidate", pair.candidate}, {"reference", pair.reference}, {"moments", moments}};
}

Json share_entry(const std::optional<ErrorOverTolerance>& share) {
  return share ? Json(share->value) : Json(nullptr);
}

Json uncertainty_entry(const ThreeWayOutcome& judged) {
  const UncertaintyContributions& of = judged.contributions;
  return {{"all", judged.uncertainty},
          {"time_history", json_or_null(of.time_series.half_width)},
          {"reference", json_or_null(of.reference.half_width)},
          {"discretisation", json_or_null(of.discretisation.half_width)},
          {"input", json_or_null(of.input.half_width)},
          {"rests_on",
           {{"reference", of.reference.basis},
            {"discretisation", of.discretisation.basis},
            {"input", of.input.basis}}}};
}

// Adds to the entry what the rows of cases and of problems have in common behind their values.
template <class Outcome>
void add_terms(const Outcome& outcome, Json& entry) {
  entry.update({{"tolerance_share", share_entry(error_over_tolerance(outcome))},
                {"message", outcome.message},
                {"reason", outcome.row.reason},
                {"source", outcome.row.source},
                {"file", outcome.row.where.file},
                {"line", outcome.row.where.line}});
}

Json gate_entry(const GateOutcome& outcome) {
  const GateRow& row = outcome.row;
  Json entry{{"verdict", verdict_name(outcome.verdict)},
             {"kind", kind_name(row.kind)},
             {"candidate", row.candidate},
             {"reference", json_or_null(row.reference)},
             {"quantity", row.quantity},
             {"mode", row.mode},
             {"metric", metric_name(row.metric)},
             {"unit", row.unit},
             {"value", outcome.value.value},
             {"half_width_95", outcome.value.half_width}};
  add_terms(outcome, entry);
  if (const auto& judged = outcome.judgement) entry["uncertainty_95"] = uncertainty_entry(*judged);
  if (row.limit) entry["limit"] = *row.limit;
  if (row.error) entry["error"] = *row.error;
  if (row.part) {
    entry["part_begin_s"] = row.part->first;
    entry["part_end_s"] = row.part->second;
  }
  if (row.between) entry["between"] = {row.between->first, row.between->second};
  if (row.improves_on) entry["improves_on"] = *row.improves_on;
  return entry;
}

Json measure_entry(const MeasuredErrors& measure) {
  Json errors = Json::array();
  for (const auto& [step, error] : measure.errors)
    errors.push_back({{"step", step}, {"error", error}});
  return {{"name", measure.name},
          {"order", json_or_null(order_of(measure.errors))},
          {"errors", errors}};
}

Json gate_entry(const ProblemGateOutcome& outcome) {
  const ProblemGateRow& row = outcome.row;
  Json entry{{"verdict", verdict_name(outcome.verdict)},
             {"kind", kind_name(row.kind)},
             {"measure", row.measure},
             {"metric", metric_name(row.metric)},
             {"unit", row.unit},
             {"value", outcome.value}};
  add_terms(outcome, entry);
  if (row.limit) entry["limit"] = *row.limit;
  if (row.between) entry["between"] = {row.between->first, row.between->second};
  return entry;
}

Json problem_entry(const ProblemAssessment& one) {
  Json entry{{"name", one.definition.name},
             {"state", state_name(one.run.status.state)},
             {"message", one.run.status.message},
             {"measures", Json::array()},
             {"gate", Json::array()}};
  if (const auto& failure = one.run.status.failure) entry["failure"] = failure_entry(*failure);
  if (const auto& result = one.run.result) {
    entry["key"] = result->key;
    entry.update(cost_entry(result->cost));
    entry["provenance"] = result->provenance;
    for (const MeasuredErrors& measure : result->outcome.measures)
      entry["measures"].push_back(measure_entry(measure));
  }
  for (const ProblemGateOutcome& outcome : one.gate) entry["gate"].push_back(gate_entry(outcome));
  return entry;
}

// The verdicts at a glance: an entry for each case, or problem, pair of candidate and reference,
// and metric, with the worst of its rows. The pairs stand in the order of the rows, the metrics in
// that of their names.
template <class Assessment>
Json matrix_json(const std::vector<Assessment>& assessed, const char* of) {
  Json list = Json::array();
  for (const Assessment& one : assessed) {
    std::vector<ShownRow> first_of_pairs;
    std::map<std::pair<std::string, std::string>, std::map<std::string, std::vector<ShownRow>>>
        rows_of;
    for (const ShownRow& row : shown_rows(one)) {
      if (!rows_of.contains({row.candidate, row.reference})) first_of_pairs.push_back(row);
      rows_of[{row.candidate, row.reference}][row.metric].push_back(row);
    }
    for (const ShownRow& first : first_of_pairs)
      for (const auto& [metric, rows] : rows_of[{first.candidate, first.reference}]) {
        const ShownRow& worst = *std::ranges::min_element(rows, is_worse);
        list.push_back({{of, first.name},
                        {"candidate", first.candidate},
                        {"reference", json_or_null(first.outcome ? first.outcome->row.reference
                                                                 : first.reference)},
                        {"metric", metric},
                        {"verdict", verdict_name(worst.verdict)},
                        {"value", worst.value},
                        {"half_width_95", worst.half_width},
                        {"unit", worst.unit},
                        {"tolerance_share", share_entry(worst.share)},
                        {"rows", rows.size()}});
      }
  }
  return list;
}

Json claims_json(const std::string& paper, const std::vector<CaseAssessment>& cases) {
  Json list = Json::array();
  for (const DecidedClaim& one : decided_claims(paper_named(paper), cases))
    list.push_back({{"number", one.claim.number},
                    {"statement", one.claim.statement},
                    {"printed", one.claim.printed},
                    {"figures", one.claim.figures},
                    {"verdict", verdict_of(one.held)},
                    {"result", one.found},
                    {"why", one.why},
                    {"runs", one.runs}});
  return list;
}

}  // namespace

Json estimate_json(const Estimate& value) {
  return {{"value", value.value}, {"half_width_95", value.half_width}};
}

Json comparison_entry(const Comparison& pair) {
  Json modes = Json::array();
  for (const ModeComparison& mode : pair.modes)
    modes.push_back({{"mode", mode.mode},
                     {"resolved", mode.resolved()},
                     {"candidate_amplitude", estimate_json(mode.candidate.amplitude)},
                     {"reference_amplitude", estimate_json(mode.reference.amplitude)},
                     {"amplitude_error", estimate_json(mode.amplitude_error)},
                     {"phase_lag_s", estimate_json(mode.phase_lag)},
                     {"phase_lag_deg", estimate_json(mode.phase_lag_degrees)},
                     {"phase_lag_periods", estimate_json(mode.phase_lag_periods)},
                     {"frequency_error", estimate_json(mode.frequency_error)},
                     {"decay_rate_1_s", estimate_json(mode.decay_rate)},
                     {"reference_decay_rate_1_s", estimate_json(mode.reference.decay_rate)}});
  return {{"candidate", pair.candidate},
          {"reference", pair.reference},
          {"quantity", pair.quantity},
          {"unit", pair.unit},
          {"window_begin_s", pair.window.begin},
          {"window_end_s", pair.window.end},
          {"normalised_rms", estimate_json(pair.normalised_rms)},
          {"mean_offset", pair.candidate_wave.mean - pair.reference_wave.mean},
          {"normalised_rms_without_offset", normalised_rms_without_offset(pair)},
          {"maximum_residual", pair.maximum_residual},
          {"cross_correlation_lag_s", pair.cross_correlation_lag},
          {"time_lag_s", pair.alignment.lag},
          {"aligned_rms", pair.alignment.normalised_rms},
          {"sprague_geers_magnitude", estimate_json(pair.sprague_geers_magnitude)},
          {"sprague_geers_phase", estimate_json(pair.sprague_geers_phase)},
          {"candidate_peaks", peaks(pair.candidate_peaks)},
          {"reference_peaks", peaks(pair.reference_peaks)},
          {"modes", modes}};
}

nlohmann::ordered_json bias_json(const PredictionSet& set) {
  Json predictions = Json::array();
  for (const Prediction& one : set.predictions)
    predictions.push_back({{"case", one.case_name},
                           {"candidate", one.candidate},
                           {"reference", one.reference},
                           {"quantity", one.quantity},
                           {"mode", one.mode},
                           {"predicted", one.value.predicted},
                           {"reference_value", one.value.reference},
                           {"reference_relative_deviation", one.value.reference_deviation},
                           {"ratio_half_width_95", one.ratio_half_width}});
  const auto number = [&](double ModelBias::*member) {
    return set.bias ? Json((*set.bias).*member) : Json(nullptr);
  };
  return {{"quantity_kind", set.kind},
          {"unit", set.unit},
          {"model", set.model},
          {"bias", number(&ModelBias::bias)},
          {"relative_deviation", number(&ModelBias::relative_deviation)},
          {"reference_relative_deviation", number(&ModelBias::reference_deviation)},
          {"comparisons", predictions}};
}

std::string results_json(const std::string& campaign, bool quick,
                         const std::vector<CaseAssessment>& cases,
                         const std::vector<ProblemAssessment>& problems, const std::string& paper) {
  Json document{{"$schema", "results.schema.json"},
                {"schema", "slosh results"},
                {"schema_version", 3},
                {"campaign", campaign},
                {"quick", quick},
                {"exit_status", exit_status(cases, problems)},
                {"core_seconds_s", campaign_cost(cases, problems).core_seconds},
                {"verdict_matrix", matrix_json(cases, "case")},
                {"problem_matrix", matrix_json(problems, "problem")},
                {"model_bias", Json::array()},
                {"cases", Json::array()},
                {"problems", Json::array()}};
  for (const PredictionSet& set : prediction_sets(cases))
    document["model_bias"].push_back(bias_json(set));
  for (const CaseAssessment& one : cases) {
    Json entry{{"name", one.definition.name},
               {"runs", Json::array()},
               {"comparisons", Json::array()},
               {"gate", Json::array()}};
    for (const RunDefinition& run : one.definition.runs)
      entry["runs"].push_back(run_entry(run, one.runs));
    for (const Comparison& pair : one.comparisons)
      entry["comparisons"].push_back(comparison_entry(pair));
    for (const GateOutcome& outcome : one.gate) entry["gate"].push_back(gate_entry(outcome));
    for (const FieldComparison& pair : one.fields)
      entry["fields"].push_back(field_entry(pair, one.definition));
    entry["work_precision"] = work_precision_json(one);
    document["cases"].push_back(std::move(entry));
  }
  for (const ProblemAssessment& one : problems) document["problems"].push_back(problem_entry(one));
  if (!paper.empty()) document["claims"] = claims_json(paper, cases);
  // nlohmann writes numbers that are not finite as null. A message may contain a solver's output in
  // any encoding.
  return document.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string with_exit_status(int status, const std::string& results_json) {
  Json document = Json::parse(results_json);
  document["exit_status"] = status;
  return document.dump(2);
}

}  // namespace slosh
