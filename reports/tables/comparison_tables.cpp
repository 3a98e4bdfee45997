// How the solutions of a case compare: modes, histories, distances, orders, pressure fields, and
// the changes to a scheme.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "reports/tables/case_tables.hpp"
#include "verification/assessment/across_runs/solution_distances.hpp"
#include "verification/assessment/observed_order.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/gate/field_metrics.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

using reports::Table;

std::string run_text(const CaseAssessment& assessment, const std::string& run) {
  const bool valid = assessment.runs.status.at(run).state != RunState::out_of_range;
  return valid ? run : run + " (out of its range)";
}

std::string with_interval(const Estimate& estimate, double scale = 1) {
  return interval_text({scale * estimate.value, scale * estimate.half_width});
}

// Returns amplitude error, lag in three units, frequency error and decay rate. A mode that cannot
// be distinguished from noise has none of them.
TableRow mode_measures(const ModeComparison& mode) {
  if (!mode.candidate.resolved) return {"not resolved", "", "", "", "", ""};
  const bool forced = is_forced(mode.mode);  // its frequency is given and it does not decay
  return {with_interval(mode.amplitude_error, 100),
          with_interval(mode.phase_lag_degrees),
          with_interval(mode.phase_lag),
          with_interval(mode.phase_lag_periods),
          forced ? "" : with_interval(mode.frequency_error, 100),
          forced ? "" : with_interval(mode.decay_rate)};
}

// Waves are given in millimetres.
std::string length_in_mm(double value, const std::string& unit) {
  return unit == "m" ? fmt::format("{:.3f} mm", 1000 * value)
                     : fmt::format("{:.4g} {}", value, unit);
}

// The unit of the power is "m2" for "m" and "(N/m)2" for "N/m".
std::string peaks(const std::vector<SpectralPeak>& found, const std::string& unit) {
  const std::string squared = unit.find('/') == unit.npos ? unit + "2" : "(" + unit + ")2";
  TableRow texts;
  for (const SpectralPeak& peak : found)
    texts.push_back(fmt::format("{:.3f} Hz ({:.2e} {})", peak.frequency, peak.power, squared));
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string order_text(const std::optional<double>& order) {
  return order ? fmt::format("{:.2f}", *order) : "";
}

// Adds the rows of one scheme, whose families have the same spacings.
void add_scheme(std::span<const ErrorFamily> families, Table& table) {
  const std::string& scheme = families.front().name;
  const std::size_t first = table.rows.size();
  for (const ErrorAtSpacing& one : families.front().errors)
    table.rows.push_back({scheme, fmt::format("{:.4g}", 1000 * one.spacing)});
  table.rows.push_back({scheme, "all, least squares"});
  for (const ErrorFamily& family : families) {
    for (std::size_t i = 0; i < family.errors.size(); ++i) {
      const Estimate& error = family.errors[i].error;
      append(table.rows[first + i],
             {std::isnan(error.value) ? "" : with_interval(error, family.scale),
              i == 0 ? "" : order_text(observed_order(family.errors[i - 1], family.errors[i]))});
    }
    append(table.rows.back(), {"", order_text(least_squares_order(family.errors))});
  }
}

TableRow field_row(const FieldComparison& compared, const CaseDefinition& definition) {
  const auto mean = [&](double FieldDifference::*value, double scale = 100) {
    double sum = 0;
    for (const FieldDifference& moment : compared.moments) sum += moment.*value;
    return scale * (sum / static_cast<double>(compared.moments.size()));
  };
  const auto lowest = [&](double FieldDifference::*value) {
    return std::ranges::min(compared.moments, {}, value).*value;
  };
  const double scale = 100 / pressure_under_depth(definition);
  TableRow row{compared.candidate, compared.reference};
  for (const FieldDifference& moment : compared.moments)
    row.push_back(fmt::format("{:.1f}", scale * moment.pressure_rms));
  append(row, {fmt::format("{:.1f}", mean(&FieldDifference::pressure_rms, scale)),
               fmt::format("{:.2f} ({:.2f})", mean(&FieldDifference::tension_share),
                           mean(&FieldDifference::reference_tension_share)),
               fmt::format("{:.0f} ({:.0f})", lowest(&FieldDifference::lowest_pressure),
                           lowest(&FieldDifference::reference_lowest_pressure)),
               fmt::format("{:.1f}", mean(&FieldDifference::uncovered_share)),
               fmt::format("{:.1f}", mean(&FieldDifference::excess_share))});
  return row;
}

}  // namespace

Table mode_table(const CaseAssessment& assessment) {
  Table table = case_table(
      assessment.definition, "modes", "Fitted modes",
      "Harmonic least squares over the comparison window. Forced and natural modes are fitted "
      "together; the frequency and the decay rate of natural modes are fitted too. ± is the 95 % "
      "interval. A positive lag means that the candidate is late.",
      {"candidate", "reference", "quantity", "mode", "amplitude error [%]", "lag [deg]", "lag [s]",
       "lag [periods]", "frequency error [%]", "decay rate [1/s]"});
  if (fitted_modes(assessment.definition).empty()) return table;
  for (const Comparison& pair : assessment.comparisons)
    for (const ModeComparison& mode : pair.modes) {
      table.rows.push_back(
          {pair.candidate, run_text(assessment, pair.reference), pair.quantity, mode.mode});
      append(table.rows.back(), mode_measures(mode));
    }
  return table;
}

Table history_table(const CaseAssessment& assessment) {
  const bool oscillates = !fitted_modes(assessment.definition).empty();
  Table table = case_table(
      assessment.definition, "histories", "Time series compared",
      "Normalised rms: rms of the residual over the rms of the reference about its mean. "
      "The 95 % interval comes from blocks of the window.",
      {"candidate", "reference", "quantity", "normalised rms", "largest residual"});
  table.caption +=
      oscillates ? " Spectral peaks: the highest comes first."
                 : " Lag: the time shift that minimises the residual; positive means that the "
                   "candidate is late.";
  append(table.header,
         oscillates ? TableRow{"spectral peaks of the candidate", "spectral peaks of the reference"}
                    : TableRow{"lag [s]", "normalised rms after the shift"});
  for (const Comparison& pair : assessment.comparisons) {
    TableRow row{pair.candidate, run_text(assessment, pair.reference), pair.quantity,
                 percent_interval_text(pair.normalised_rms),
                 length_in_mm(pair.maximum_residual, pair.unit)};
    if (oscillates)
      append(row, {peaks(pair.candidate_peaks, pair.unit), peaks(pair.reference_peaks, pair.unit)});
    else if (std::isnan(pair.alignment.lag))
      append(row, {"none found", ""});
    else
      append(row, {fmt::format("{:+.4f}", pair.alignment.lag),
                   fmt::format("{:.2f} %", 100 * pair.alignment.normalised_rms)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table distance_table(const CaseAssessment& assessment) {
  const auto [quantity, runs, distances] = solution_distances(assessment);
  if (runs.size() < 3) return {};
  const auto odd = outlier(distances);
  Table table = case_table(
      assessment.definition, "closure", "Distances between solutions",
      fmt::format(
          "Distance between the time series of {} [%]: rms of their difference over the geometric "
          "mean of both rms about their means. {}.",
          quantity,
          odd ? fmt::format(
                    "`{}` is an outlier: its mean distance to the others is more than twice "
                    "the mean distance among the others",
                    runs[*odd])
              : "No solution is an outlier: none has a mean distance to the others of more than "
                "twice the mean distance among them"),
      {"run"});
  append(table.header, runs);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    table.rows.push_back({run_text(assessment, runs[i])});
    for (std::size_t j = 0; j < runs.size(); ++j)
      table.rows.back().push_back(i == j || !std::isfinite(distances[i][j])
                                      ? ""
                                      : fmt::format("{:.3g}", 100 * distances[i][j]));
  }
  return table;
}

Table order_table(const CaseAssessment& assessment) {
  const std::vector<ErrorFamily> families = scheme_error_families(assessment);
  if (families.empty()) return {};
  Table table = case_table(
      assessment.definition, "orders", "Observed order of convergence",
      "Errors against theory or a published record at each particle spacing, the order between a "
      "spacing and the next coarser one, and the slope of the least-squares line through all. No "
      "order is given for an error that is smaller than its own 95 % interval.",
      {"scheme or method", "spacing [mm]"});
  // In the sequence of a scheme's error families.
  constexpr const char* orders[] = {"order of rms", "order of frequency", "order of decay"};
  constexpr std::size_t measures = std::size(orders);
  for (std::size_t i = 0; i < measures; ++i) append(table.header, {families[i].measure, orders[i]});
  for (std::size_t first = 0; first < families.size(); first += measures)
    add_scheme(std::span(families).subspan(first, measures), table);
  return table;
}

Table field_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  if (assessment.fields.empty()) return {};
  const double pressure = pressure_under_depth(definition);
  Table table = case_table(
      definition, "pressure-fields", "Pressure fields against interFoam's",
      fmt::format(
          "The pressure of each run less interFoam's, on interFoam's cells that are at least half "
          "liquid and that the run's liquid covers by half or more: the rms over these cells in "
          "percent of the pressure under the fill depth, {:.4g} Pa. Tension: the share of these "
          "cells with a pressure below -{:.3g} Pa, the mean over the moments; in brackets "
          "interFoam's. Lowest: the lowest of these cells at any of the moments. Not covered: "
          "interFoam's liquid cells that the run does not cover. Excess: the cells that it covers "
          "where interFoam has no liquid. Both are over interFoam's liquid cells, the mean over "
          "the moments.",
          pressure, small_tension_share * pressure),
      {"run", "against"});
  for (const FieldDifference& moment : assessment.fields.front().moments)
    table.header.push_back(fmt::format("rms at {:.4g} s [%]", moment.time));
  append(table.header,
         {"mean rms [%]", "tension [%]", "lowest [Pa]", "not covered [%]", "excess [%]"});
  for (const FieldComparison& compared : assessment.fields)
    table.rows.push_back(field_row(compared, definition));
  return table;
}

namespace {

struct AblationRun {
  std::string name;
  const SphRun* sph;
  const RunResult* result;       // null where the run left none
  const Comparison* comparison;  // against theory or a record; null where there is none
  std::string changes;
};

std::vector<AblationRun> ablation_runs(const CaseAssessment& assessment) {
  std::vector<AblationRun> runs;
  for (const RunDefinition& run : assessment.definition.runs)
    if (const SphRun* sph = std::get_if<SphRun>(&run.solver); sph && !is_later_member(run))
      runs.push_back({run.name, sph, find_result(assessment.runs, run.name),
                      comparison_with_truth(assessment, run.name), changes_of(*sph)});
  return runs;
}

// Returns the unchanged run of the same scheme and spacing; null for an unchanged run, and where
// the case has none.
const AblationRun* unchanged(const std::vector<AblationRun>& runs, const AblationRun& one) {
  if (one.changes.empty()) return nullptr;
  const auto found = std::ranges::find_if(runs, [&](const AblationRun& other) {
    return other.sph->scheme == one.sph->scheme &&
           other.sph->particle_spacing == one.sph->particle_spacing &&
           other.sph->surface_particle_spacing == one.sph->surface_particle_spacing &&
           other.changes.empty();
  });
  return found == runs.end() ? nullptr : &*found;
}

std::string spacing_text(const SphRun& sph) {
  const double inside = 1000 * sph.particle_spacing, surface = 1000 * sph.surface_particle_spacing;
  return inside == surface ? fmt::format("{:.4g}", inside)
                           : fmt::format("{:.4g} / {:.4g}", inside, surface);
}

std::string ratio(double value, double unchanged_value) {
  return fmt::format("{:.3g}", value / unchanged_value);
}

// The term that each number belongs to, in the sequence of sph_number_names.
constexpr const char* terms_of_numbers[] = {"kernel: h / spacing", "state: c0 / largest speed",
                                            "time step: dt c0 / h", "viscosity: alpha",
                                            "density diffusion: delta"};
static_assert(std::size(terms_of_numbers) == std::size(sph_number_names));

// "quintic kernel and viscosity": the terms that only the one result has.
std::string terms_besides(const RunResult& one, const RunResult& other) {
  TableRow terms = one.active_terms;
  std::erase_if(terms, [&](const std::string& term) {
    return std::ranges::find(other.active_terms, term) != other.active_terms.end();
  });
  return fmt::format("{}", fmt::join(terms, " and "));
}

// Returns the terms that a run has added, left out or replaced against the unchanged run, and the
// terms that its changed numbers belong to.
std::string changed_terms(const AblationRun& one, const AblationRun* plain) {
  TableRow texts;
  if (plain && plain->result && one.result) {
    const std::string with = terms_besides(*one.result, *plain->result),
                      without = terms_besides(*plain->result, *one.result);
    if (!with.empty() && !without.empty())
      texts.push_back(with + " instead of " + without);
    else if (!with.empty() || !without.empty())
      texts.push_back(with.empty() ? "without " + without : "with " + with);
  }
  if (!one.sph->initial_state.empty() || one.sph->start_disorder > unseen_disorder ||
      one.sph->start_rotation_deg != 0)
    texts.push_back("initial state");
  for (std::size_t i = 0; i < std::size(sph_number_names); ++i)
    if (one.sph->numbers.*sph_number_names[i].second) texts.push_back(terms_of_numbers[i]);
  return fmt::format("{}", fmt::join(texts, "; "));
}

// Returns a measure of the first fitted mode of a kind; empty where none was fitted.
std::string mode_cell(const Comparison& comparison, const std::string& kind,
                      Estimate ModeComparison::*measure, double scale) {
  for (const ModeComparison& mode : comparison.modes) {
    if (!mode.mode.starts_with(kind)) continue;
    if (!mode.resolved()) return "not resolved";
    const Estimate& estimate = mode.*measure;
    return interval_text({scale * estimate.value, scale * estimate.half_width});
  }
  return "";
}

TableRow error_cells(const AblationRun& one, const AblationRun* plain) {
  if (!one.comparison) return TableRow(7);
  const Comparison& comparison = *one.comparison;
  const bool same_reference =
      plain && plain->comparison && plain->comparison->reference == comparison.reference;
  return {comparison.reference,
          fmt::format("{:.2f}", 100 * comparison.normalised_rms.value),
          same_reference
              ? ratio(comparison.normalised_rms.value, plain->comparison->normalised_rms.value)
              : "",
          mode_cell(comparison, "forced", &ModeComparison::amplitude_error, 100),
          mode_cell(comparison, "forced", &ModeComparison::phase_lag_degrees, 1),
          mode_cell(comparison, "natural", &ModeComparison::frequency_error, 100),
          mode_cell(comparison, "natural", &ModeComparison::decay_rate, 1)};
}

TableRow cost_cells(const AblationRun& one, const AblationRun* plain, double duration) {
  if (!one.result) return TableRow(5);
  const RunCost& cost = one.result->cost;
  const double time = cost.core_seconds();
  return {fmt::format("{:.2f}", time),
          plain && plain->result ? ratio(time, plain->result->cost.core_seconds()) : "",
          fmt::format("{}", cost.steps),
          fmt::format("{:.4g}", 1e6 * time / (cost.elements * duration)),
          fmt::format("{:.0f}", cost.peak_memory / cost.elements)};
}

}  // namespace

reports::Table ablation_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  reports::Table table = case_table(
      definition, "choices", "Ablation: effect and cost of each change to a scheme",
      "The error of each SPH run against theory or a published record, and its cost. \"over "
      "unchanged\": ratio to the unchanged run of the same scheme and spacing. CPU time is user "
      "plus system time; peak memory is that of the whole process.",
      {"run", "scheme", "spacing [mm]", "change", "affected terms", "reference",
       "normalised rms [%]", "rms over unchanged", "forced amplitude error [%]", "forced lag [deg]",
       "natural frequency error [%]", "decay rate [1/s]", "CPU time [s]", "CPU time over unchanged",
       "steps", "CPU time [us per particle and simulated s]", "peak memory [byte per particle]"});
  const std::vector<AblationRun> runs = ablation_runs(assessment);
  const auto is_changed = [](const AblationRun& one) { return !one.changes.empty(); };
  const auto is_compared = [](const AblationRun& one) { return one.comparison != nullptr; };
  if (std::ranges::none_of(runs, is_changed) || std::ranges::none_of(runs, is_compared))
    return table;
  for (const AblationRun& one : runs) {
    const AblationRun* plain = unchanged(runs, one);
    TableRow row{one.name, one.sph->scheme, spacing_text(*one.sph),
                 one.changes.empty() ? "unchanged" : one.changes, changed_terms(one, plain)};
    append(row, error_cells(one, plain));
    append(row, cost_cells(one, plain, definition.duration));
    if (!one.result) row[5] = state_name(assessment.runs.status.at(one.name).state);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace slosh
