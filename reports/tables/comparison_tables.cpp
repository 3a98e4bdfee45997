// The tables of pressure fields that were compared with interFoam's.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "reports/tables/case_tables.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/assessment/across_runs/solution_distances.hpp"
#include "verification/assessment/observed_order.hpp"
#include "verification/case/motion.hpp"
#include "verification/gate/field_metrics.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

using reports::Table;
using Row = std::vector<std::string>;

double mean_of(const FieldComparison& compared, double FieldDifference::*value) {
  double sum = 0;
  for (const FieldDifference& moment : compared.moments) sum += moment.*value;
  return sum / static_cast<double>(compared.moments.size());
}

double lowest_of(const FieldComparison& compared, double FieldDifference::*value) {
  double lowest = compared.moments.front().*value;
  for (const FieldDifference& moment : compared.moments) lowest = std::min(lowest, moment.*value);
  return lowest;
}

std::string fields_caption(const CaseDefinition& definition) {
  return fmt::format(
      "The pressure of each run less interFoam's, on interFoam's cells that are at least half "
      "liquid and that the run's liquid covers by half or more: the rms over these cells in "
      "percent of the pressure under the fill depth, {:.4g} Pa. Tension: the share of these cells "
      "with a pressure below -{:.3g} Pa, the mean over the moments; in brackets interFoam's. "
      "Lowest: the lowest of these cells at any of the moments. Not covered: interFoam's liquid "
      "cells that the run does not cover. Excess: the cells that it covers where interFoam has no "
      "liquid. Both are over interFoam's liquid cells, the mean over the moments.",
      pressure_under_depth(definition), small_tension_share * pressure_under_depth(definition));
}

Row field_row(const FieldComparison& compared, const CaseDefinition& definition) {
  const double scale = 100 / pressure_under_depth(definition);
  Row row{compared.candidate, compared.reference};
  for (const FieldDifference& moment : compared.moments)
    row.push_back(fmt::format("{:.1f}", scale * moment.pressure_rms));
  row.push_back(fmt::format("{:.1f}", scale * mean_of(compared, &FieldDifference::pressure_rms)));
  row.push_back(fmt::format("{:.2f} ({:.2f})",
                            100 * mean_of(compared, &FieldDifference::tension_share),
                            100 * mean_of(compared, &FieldDifference::reference_tension_share)));
  row.push_back(fmt::format("{:.0f} ({:.0f})",
                            lowest_of(compared, &FieldDifference::lowest_pressure),
                            lowest_of(compared, &FieldDifference::reference_lowest_pressure)));
  row.push_back(fmt::format("{:.1f}", 100 * mean_of(compared, &FieldDifference::uncovered_share)));
  row.push_back(fmt::format("{:.1f}", 100 * mean_of(compared, &FieldDifference::excess_share)));
  return row;
}

std::string run_text(const CaseAssessment& assessment, const std::string& run) {
  const bool valid = assessment.runs.status.at(run).state != RunState::out_of_range;
  return valid ? run : run + " (out of its range)";
}

std::string with_interval(const Estimate& estimate, double scale = 1) {
  return interval_text({scale * estimate.value, scale * estimate.half_width});
}

// Returns amplitude error, lag in three units, frequency error and decay rate. A mode that cannot
// be distinguished from noise has none of them.
std::vector<std::string> mode_measures(const ModeComparison& mode) {
  if (!mode.candidate.resolved) return {"not resolved", "", "", "", "", ""};
  const bool forced = is_forced(mode.mode);  // its frequency is given and it does not decay
  return {with_interval(mode.amplitude_error, 100),
          with_interval(mode.phase_lag_degrees),
          with_interval(mode.phase_lag),
          with_interval(mode.phase_lag_periods),
          forced ? "" : with_interval(mode.frequency_error, 100),
          forced ? "" : with_interval(mode.decay_rate)};
}

std::string rms_text(const Estimate& rms) { return percent_interval_text(rms); }

// Waves are given in millimetres.
std::string length_in_mm(double value, const std::string& unit) {
  return unit == "m" ? fmt::format("{:.3f} mm", 1000 * value)
                     : fmt::format("{:.4g} {}", value, unit);
}

// Returns "m2" for "m" and "(N/m)2" for "N/m".
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

// The headings of the order columns, in the sequence of a scheme's error families.
constexpr const char* order_headings[] = {"order of rms", "order of frequency", "order of decay"};

std::string error_text(const Estimate& error, double scale) {
  if (std::isnan(error.value)) return "";
  return interval_text({scale * error.value, scale * error.half_width});
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
      auto& row = table.rows[first + i];
      row.push_back(error_text(family.errors[i].error, family.scale));
      row.push_back(i == 0 ? ""
                           : order_text(observed_order(family.errors[i - 1], family.errors[i])));
    }
    table.rows.back().push_back("");
    table.rows.back().push_back(order_text(least_squares_order(family.errors)));
  }
}

}  // namespace

std::optional<Table> field_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  if (assessment.fields.empty()) return std::nullopt;
  Table table{case_id(definition.name) + "-pressure-fields",
              "Pressure fields against interFoam's",
              fields_caption(definition),
              {"run", "against"},
              {}};
  for (const FieldDifference& moment : assessment.fields.front().moments)
    table.header.push_back(fmt::format("rms at {:.4g} s [%]", moment.time));
  table.header.insert(table.header.end(), {"mean rms [%]", "tension [%]", "lowest [Pa]",
                                           "not covered [%]", "excess [%]"});
  for (const FieldComparison& compared : assessment.fields)
    table.rows.push_back(field_row(compared, definition));
  return table;
}

Table mode_table(const CaseAssessment& assessment) {
  Table table{
      case_id(assessment.definition.name) + "-modes",
      "Fitted modes",
      "Harmonic least squares over the comparison window. Forced and natural modes are fitted "
      "together; the frequency and the decay rate of natural modes are fitted too. ± is the 95 % "
      "interval. A positive lag means that the candidate is late.",
      {"candidate", "reference", "quantity", "mode", "amplitude error [%]", "lag [deg]", "lag [s]",
       "lag [periods]", "frequency error [%]", "decay rate [1/s]"},
      {}};
  for (const Comparison& pair : assessment.comparisons)
    for (const ModeComparison& mode : pair.modes) {
      std::vector<std::string> row{pair.candidate, run_text(assessment, pair.reference),
                                   pair.quantity, mode.mode};
      const std::vector<std::string> measures = mode_measures(mode);
      row.insert(row.end(), measures.begin(), measures.end());
      table.rows.push_back(std::move(row));
    }
  return table;
}

Table history_table(const CaseAssessment& assessment) {
  const bool oscillates = !fitted_modes(assessment.definition).empty();
  Table table{
      case_id(assessment.definition.name) + "-histories",
      "Time series compared",
      "Normalised rms: rms of the residual over the rms of the reference about its mean. The "
      "95 % interval comes from blocks of the window.",
      {"candidate", "reference", "quantity", "normalised rms", "largest residual"},
      {}};
  if (oscillates) {
    table.caption += " Spectral peaks: the highest comes first.";
    table.header.insert(table.header.end(),
                        {"spectral peaks of the candidate", "spectral peaks of the reference"});
  } else {
    table.caption +=
        " Lag: the time shift that minimises the residual; positive means that the candidate is "
        "late.";
    table.header.insert(table.header.end(), {"lag [s]", "normalised rms after the shift"});
  }
  for (const Comparison& pair : assessment.comparisons) {
    std::vector<std::string> row{pair.candidate, run_text(assessment, pair.reference),
                                 pair.quantity, rms_text(pair.normalised_rms),
                                 length_in_mm(pair.maximum_residual, pair.unit)};
    if (oscillates)
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

std::optional<Table> distance_table(const CaseAssessment& assessment) {
  const auto [quantity, runs, distances] = solution_distances(assessment);
  if (runs.size() < 3) return {};
  const auto odd = outlier(distances);
  Table table{
      case_id(assessment.definition.name) + "-closure",
      "Distances between solutions",
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
      {"run"},
      {}};
  table.header.insert(table.header.end(), runs.begin(), runs.end());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::vector<std::string> row{run_text(assessment, runs[i])};
    for (std::size_t j = 0; j < runs.size(); ++j)
      row.push_back(i == j || !std::isfinite(distances[i][j])
                        ? ""
                        : fmt::format("{:.3g}", 100 * distances[i][j]));
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::optional<Table> order_table(const CaseAssessment& assessment) {
  const std::vector<ErrorFamily> families = scheme_error_families(assessment);
  if (families.empty()) return std::nullopt;
  Table table{
      case_id(assessment.definition.name) + "-orders",
      "Observed order of convergence",
      "Errors against theory or a published record at each particle spacing, the order between a "
      "spacing and the next coarser one, and the slope of the least-squares line through all. No "
      "order is given for an error that is smaller than its own 95 % interval.",
      {"scheme or method", "spacing [mm]"},
      {}};
  constexpr std::size_t measures = std::size(order_headings);
  for (std::size_t i = 0; i < measures; ++i) {
    table.header.push_back(families[i].measure);
    table.header.push_back(order_headings[i]);
  }
  for (std::size_t first = 0; first < families.size(); first += measures)
    add_scheme(std::span(families).subspan(first, measures), table);
  return table;
}

}  // namespace slosh
