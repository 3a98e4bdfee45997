// How the solutions of a case compare: modes, histories, distances, orders and pressure fields.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "reports/tables/case_tables.hpp"
#include "verification/assessment/across_runs/solution_distances.hpp"
#include "verification/assessment/observed_order.hpp"
#include "verification/case/motion.hpp"
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

}  // namespace slosh
