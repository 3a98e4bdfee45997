#include "verification/assessment/observed_order.hpp"

#include <cmath>
#include <map>

#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/refinement.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

constexpr std::size_t least_spacings = 3;

bool has_size(const Estimate& error) {
  return std::isfinite(error.value) && std::abs(error.value) > error.half_width;
}

// The error measures of one run, in the order of the columns.
struct Measures {
  Estimate rms{not_a_number, 0}, frequency_error{not_a_number, 0}, decay_excess{not_a_number, 0};
};

struct Column {
  const char* error;
  Estimate Measures::*measure;
  double scale;
};

constexpr Column columns[] = {{"normalised rms [%]", &Measures::rms, 100},
                              {"natural frequency error [%]", &Measures::frequency_error, 100},
                              {"decay beyond the reference's [1/s]", &Measures::decay_excess, 1}};

Measures measures_of(const Comparison& comparison) {
  Measures measures;
  measures.rms = comparison.normalised_rms;
  for (const ModeComparison& mode : comparison.modes) {
    if (!mode.mode.starts_with("natural")) continue;
    if (!mode.resolved()) break;
    measures.frequency_error = mode.frequency_error;
    const Estimate& own = mode.decay_rate;
    const Estimate& exact = mode.reference.decay_rate;
    measures.decay_excess = {own.value - exact.value, std::hypot(own.half_width, exact.half_width)};
    break;  // after the lowest
  }
  return measures;
}

// By spacing, coarsest first.
using MeasuresBySpacing = std::map<double, Measures, std::greater<>>;

bool has_finer_surface(const RunDefinition& run) {
  const SphRun* sph = std::get_if<SphRun>(&run.solver);
  return sph && sph->particle_spacing != sph->surface_particle_spacing;
}

// The runs of each scheme that change nothing of it and have one spacing throughout, and those of
// each method of an external program.
std::map<std::string, MeasuresBySpacing> measures_by_scheme(const CaseAssessment& assessment) {
  std::map<std::string, MeasuresBySpacing> schemes;
  for (const RunDefinition& run : assessment.definition.runs) {
    const std::optional<double> spacing = particle_spacing(run);
    if (!spacing || is_changed(run) || has_finer_surface(run)) continue;
    if (const Comparison* comparison = comparison_with_truth(assessment, run.name))
      schemes[family(run)][*spacing] = measures_of(*comparison);
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

void add_families(const std::string& name, const MeasuresBySpacing& spacings,
                  std::vector<ErrorFamily>& families) {
  if (spacings.size() < least_spacings) return;
  for (const Column& column : columns)
    families.push_back({name, column.error, column.scale, errors_of(spacings, column)});
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

std::vector<ErrorFamily> scheme_error_families(const CaseAssessment& assessment) {
  std::vector<ErrorFamily> families;
  for (const auto& [scheme, spacings] : measures_by_scheme(assessment))
    add_families(scheme, spacings, families);
  return families;
}

std::vector<ErrorFamily> error_families(const CaseAssessment& assessment) {
  std::vector<ErrorFamily> families = scheme_error_families(assessment);
  for (const RefinementDefinition& path : assessment.definition.refinements)
    if (path.number == RefinedNumber::mesh)
      add_families(path.name, measures_of_meshes(assessment, path), families);
  return families;
}

}  // namespace slosh
