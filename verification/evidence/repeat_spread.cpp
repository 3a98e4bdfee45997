#include "verification/evidence/repeat_spread.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "verification/gate/measured_value.hpp"
#include "verification/series/sample_moments.hpp"

namespace slosh {
double half_width_of_95_percent(const std::vector<double>& values) {
  if (values.size() < 2) throw std::invalid_argument("a single value has no scatter");
  const double n = static_cast<double>(values.size());
  return t95(n - 1) * rms(without_mean(values)) * std::sqrt(n / (n - 1));
}

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
                     const MeasureRow& measure, const FindComparison& comparison) {
  const auto* candidate = std::get_if<SphRun>(&run_named(definition, row.candidate).solver);
  if (!candidate || !run_named(definition, row.candidate).ensemble.empty()) return 0;
  std::vector<double> values;
  std::vector<std::string> repeats;
  for (const RunDefinition& run : definition.runs) {
    const auto* sph = std::get_if<SphRun>(&run.solver);
    if (!sph || run.varies_inputs || !runs.results.contains(run.name) ||
        !repeat_one_another(*sph, *candidate))
      continue;
    GateRow repeated = row;
    repeated.candidate = run.name;
    try {
      const double value = measure(repeated).value;
      if (!std::isfinite(value)) continue;
      values.push_back(value);
      repeats.push_back(run.name);
    } catch (const std::runtime_error&) {
      continue;  // ComparisonError or ResultError: this run has no such metric
    }
  }
  if (values.size() < 3) return 0;
  const double of_series =
      t95(static_cast<double>(values.size()) - 1) * spread_of_series(row, repeats, comparison);
  return std::max(half_width_of_95_percent(values), of_series) *
         std::sqrt(1 + 1 / static_cast<double>(values.size()));
}

}  // namespace slosh
