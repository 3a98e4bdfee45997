#include "verification/evidence/soundness.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace slosh {
namespace {

// Of a weakly compressible liquid the density differs by the square of the Mach number, here 4 %
// (Monaghan 1994, J. Comput. Phys. 110:399), and by 1 % under the weight of a column at c0 = 10 V.
// A liquid that keeps its volume keeps its kernel sum, and under gas it parts where its pressure
// falls below the gas's. OpenFOAM's limited flux is explicit.
struct SoundnessLimit {
  const char *recorded, *name;
  double limit;
};
constexpr SoundnessLimit soundness_limits[] = {
    {"mach_number", "Mach number but for 5 % of the time", 0.2},
    {"density_error", "density error but for 5 % of the time", 0.05},
    {"packing_drift", "packing drift but for 5 % of the time", 0.01},
    {"tension_share", "share of particles under tension but for 5 % of the time", 0.5},
    {"max_courant_number", "largest Courant number", 1}};
constexpr double exempt_share = 0.05;  // of the samples: drops and impacts are short

// The magnitude that the series exceeds for that share of its samples; NaN where one is NaN.
double usual_largest(const TimeSeries& series) {
  std::vector<double> magnitudes;
  for (const double value : series.value) magnitudes.push_back(std::abs(value));
  const auto exempt =
      static_cast<std::ptrdiff_t>(exempt_share * static_cast<double>(magnitudes.size()));
  const bool has_nan = std::ranges::any_of(magnitudes, [](double one) { return std::isnan(one); });
  if (!has_nan) std::ranges::nth_element(magnitudes, magnitudes.begin() + exempt, std::greater{});
  return has_nan ? not_a_number : magnitudes[static_cast<std::size_t>(exempt)];
}

std::string doubts_of(const CaseDefinition& definition, const RunResult& result) {
  std::vector<std::string> doubts;
  for (const auto& [recorded, name, limit] : soundness_limits) {
    double value = 0;
    for (const TimeSeries& series : result.series)
      if (series.name == recorded && !series.value.empty()) value = usual_largest(series);
    if (const auto fact = result.diagnostics.find(recorded); fact != result.diagnostics.end())
      value = fact->second;
    const bool has_scale = definition.gravity > 0 || recorded != std::string("tension_share");
    if (!(value <= limit) && has_scale)
      doubts.push_back(fmt::format("its {} is {:.2g}, limit {:.2g}", name, value, limit));
  }
  return fmt::format("{}", fmt::join(doubts, ", "));
}

}  // namespace

std::string soundness_doubt(const CaseDefinition& definition, const CaseRuns& runs,
                            const std::set<std::string>& named) {
  for (const RunDefinition& run : definition.runs) {
    const auto result = runs.results.find(run.name);
    if (!named.contains(run.ensemble.empty() ? run.name : run.ensemble) ||
        result == runs.results.end())
      continue;
    if (const std::string doubts = doubts_of(definition, result->second); !doubts.empty())
      return fmt::format("{} is not sound: {}", run.name, doubts);
  }
  return "";
}

std::string doubtful_runs(const CaseDefinition& definition, const CaseRuns& runs) {
  std::set<std::string> judged;
  for (const GateRow& row : definition.gate)
    judged.insert({row.candidate, row.reference, row.improves_on.value_or("")});
  const std::string doubt = soundness_doubt(definition, runs, judged);
  return doubt.empty() ? "" : fmt::format("doubtful: {}: {}", definition.name, doubt);
}

}  // namespace slosh
