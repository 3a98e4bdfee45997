#include "verification/campaign/order_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "verification/campaign/ablation_table.hpp"
#include "verification/campaign/refinement.hpp"
#include "verification/metrics/estimate.hpp"

namespace slosh {
namespace {

constexpr std::size_t least_spacings = 3;

bool has_size(const Estimate& error) {
  return std::isfinite(error.value) && std::abs(error.value) > error.half_width;
}

// The measures of one run whose order is asked for, in the order of the columns.
struct Measures {
  Estimate rms{not_a_number, 0}, frequency_error{not_a_number, 0}, decay_excess{not_a_number, 0};
};

struct Column {
  const char *error, *order;
  Estimate Measures::*measure;
  double scale;
};

constexpr Column columns[] = {
    {"normalised rms [%]", "order of rms", &Measures::rms, 100},
    {"natural frequency error [%]", "order of frequency", &Measures::frequency_error, 100},
    {"decay beyond the reference's [1/s]", "order of decay", &Measures::decay_excess, 1}};

Measures measures_of(const Comparison& comparison) {
  Measures measures;
  measures.rms = comparison.normalised_rms;
  for (const ModeComparison& mode : comparison.modes) {
    if (mode.mode != "natural_1" || !mode.resolved()) continue;
    measures.frequency_error = mode.frequency_error;
    const Estimate& own = mode.decay_rate;
    const Estimate& exact = mode.reference.decay_rate;
    measures.decay_excess = {own.value - exact.value, std::hypot(own.half_width, exact.half_width)};
  }
  return measures;
}

// By spacing, coarsest first.
using MeasuresBySpacing = std::map<double, Measures, std::greater<>>;

// Of a scheme the runs of one spacing throughout that change nothing of it.
std::map<std::string, MeasuresBySpacing> measures_by_scheme(const CaseAssessment& assessment) {
  std::map<std::string, MeasuresBySpacing> schemes;
  for (const RunDefinition& run : assessment.definition.runs) {
    const SphRun* sph = std::get_if<SphRun>(&run.solver);
    if (!sph || !changes_of(*sph).empty() || sph->particle_spacing != sph->surface_particle_spacing)
      continue;
    if (const Comparison* comparison = comparison_with_truth(assessment, run.name))
      schemes[sph->scheme][sph->particle_spacing] = measures_of(*comparison);
  }
  return schemes;
}

// The root of a cell's area stands for the spacing.
MeasuresBySpacing measures_of_meshes(const CaseAssessment& assessment,
                                     const RefinementDefinition& path) {
  MeasuresBySpacing meshes;
  const TankDefinition& tank = assessment.definition.tank;
  for (const std::string& run : path.runs)
    if (const Comparison* comparison = comparison_with_truth(assessment, run))
      meshes[std::sqrt(tank.length * tank.height) *
             step_of(path.number, run_named(assessment.definition, run), assessment.runs)] =
          measures_of(*comparison);
  return meshes;
}

std::vector<ErrorAtSpacing> errors_of(const MeasuresBySpacing& spacings, const Column& column) {
  std::vector<ErrorAtSpacing> errors;
  for (const auto& [spacing, measures] : spacings)
    errors.push_back({spacing, measures.*column.measure});
  return errors;
}

std::string error_text(const Estimate& error, double scale) {
  if (std::isnan(error.value)) return "";
  const std::string value = fmt::format("{:.3g}", scale * error.value);
  return error.half_width > 0 ? fmt::format("{} ± {:.2g}", value, scale * error.half_width) : value;
}

std::string order_text(const std::optional<double>& order) {
  return order ? fmt::format("{:.2f}", *order) : "";
}

void add_scheme(const std::string& scheme, const MeasuresBySpacing& spacings,
                reports::Table& table) {
  const std::size_t first = table.rows.size();
  for (const auto& [spacing, measures] : spacings)
    table.rows.push_back({scheme, fmt::format("{:.4g}", 1000 * spacing)});
  table.rows.push_back({scheme, "all, least squares"});
  for (const Column& column : columns) {
    const std::vector<ErrorAtSpacing> errors = errors_of(spacings, column);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      auto& row = table.rows[first + i];
      row.push_back(error_text(errors[i].error, column.scale));
      row.push_back(i == 0 ? "" : order_text(observed_order(errors[i - 1], errors[i])));
    }
    table.rows.back().push_back("");
    table.rows.back().push_back(order_text(least_squares_order(errors)));
  }
}

}  // namespace

std::optional<double> observed_order(const ErrorAtSpacing& coarse, const ErrorAtSpacing& fine) {
  if (!has_size(coarse.error) || !has_size(fine.error)) return std::nullopt;
  return std::log(std::abs(coarse.error.value / fine.error.value)) /
         std::log(coarse.spacing / fine.spacing);
}

std::optional<double> least_squares_order(const std::vector<ErrorAtSpacing>& errors) {
  const auto line = least_squares_line(errors);
  return line ? std::optional(line->order.value) : std::nullopt;
}

std::optional<PowerLawLine> least_squares_line(const std::vector<ErrorAtSpacing>& errors) {
  std::vector<ValueAtStep> sized;
  for (const auto& [spacing, error] : errors)
    if (has_size(error)) sized.push_back({spacing, std::abs(error.value), error.half_width});
  if (sized.size() < least_spacings) return std::nullopt;
  return fit_power_law_line(sized);
}

std::vector<ErrorFamily> error_families(const CaseAssessment& assessment) {
  std::vector<ErrorFamily> families;
  const auto add = [&](const std::string& name, const MeasuresBySpacing& spacings) {
    if (spacings.size() < least_spacings) return;
    for (const Column& column : columns)
      families.push_back({name, column.error, column.scale, errors_of(spacings, column)});
  };
  for (const auto& [scheme, spacings] : measures_by_scheme(assessment)) add(scheme, spacings);
  for (const RefinementDefinition& path : assessment.definition.refinements)
    if (path.number == RefinedNumber::mesh) add(path.name, measures_of_meshes(assessment, path));
  return families;
}

std::optional<reports::Table> order_table(const CaseAssessment& assessment) {
  reports::Table table{
      assessment.definition.name + "-orders",
      "Observed order",
      "Errors against theory or a published record over the particle spacing; the order between a "
      "spacing and the coarser one above it, and the slope through all. An error within its own 95 "
      "% interval has no order.",
      {"scheme", "spacing [mm]"},
      {}};
  for (const Column& column : columns) {
    table.header.push_back(column.error);
    table.header.push_back(column.order);
  }
  for (const auto& [scheme, spacings] : measures_by_scheme(assessment))
    if (spacings.size() >= least_spacings) add_scheme(scheme, spacings, table);
  if (table.rows.empty()) return std::nullopt;
  return table;
}

}  // namespace slosh
