#include "verification/evidence/repeat_spread.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <vector>

#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

double prediction_half_width(const std::vector<double>& values) {
  const double n = static_cast<double>(values.size());
  double squares = 0;
  for (const double value : without_mean(values)) squares += value * value;
  const double t = boost::math::quantile(boost::math::students_t(n - 1), 0.975);
  return t * std::sqrt(squares / (n - 1) * (1 + 1 / n));
}

}  // namespace

bool repeat_one_another(const SphRun& one, const SphRun& other) {
  SphRun alike = one;
  alike.particle_spacing = other.particle_spacing;
  alike.surface_particle_spacing = other.surface_particle_spacing;
  alike.start_disorder = other.start_disorder;
  alike.start_seed = other.start_seed;
  alike.energy_budget = other.energy_budget;
  return one.start_disorder > 0 && alike == other;
}

double repeat_spread(const CaseDefinition& definition, const CaseRuns& runs, const GateRow& row,
                     const MeasureRow& measure) {
  const auto* candidate = std::get_if<SphRun>(&run_named(definition, row.candidate).solver);
  if (!candidate || !run_named(definition, row.candidate).ensemble.empty()) return 0;
  std::vector<double> values;
  for (const RunDefinition& run : definition.runs) {
    const auto* sph = std::get_if<SphRun>(&run.solver);
    if (!sph || !runs.results.contains(run.name) || !repeat_one_another(*sph, *candidate)) continue;
    GateRow repeated = row;
    repeated.candidate = run.name;
    try {
      const double value = measure(repeated).value;
      if (std::isfinite(value)) values.push_back(value);
    } catch (const std::runtime_error&) {
      continue;  // ComparisonError or ResultError: this run has no such metric
    }
  }
  return values.size() < 3 ? 0 : prediction_half_width(values);
}

}  // namespace slosh
