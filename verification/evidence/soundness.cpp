#include "verification/evidence/soundness.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "verification/gate/gate.hpp"

namespace slosh {
namespace {

struct SoundnessLimit {
  const char *series, *name;
  double limit;
  bool is_share;  // shown in percent
};
constexpr SoundnessLimit soundness_limits[] = {
    {"mach_number", "Mach number", 0.2, false},
    {"density_error", "density error", 0.05, true},
    {"packing_drift", "packing drift", 0.01, true},
    {"tension_share", "share of particles under tension", 0.5, true}};
constexpr SoundnessLimit courant_limit{"max_courant_number", "largest Courant number", 1, false};
constexpr double exempt_share = 0.05;  // of the samples

// The magnitude that the series exceeds for that share of its samples; NaN where one is NaN.
double usual_largest(const TimeSeries& series) {
  std::vector<double> magnitudes;
  for (const double value : series.value) magnitudes.push_back(std::abs(value));
  if (std::any_of(magnitudes.begin(), magnitudes.end(), [](double one) { return std::isnan(one); }))
    return not_a_number;
  const auto exempt =
      static_cast<std::size_t>(exempt_share * static_cast<double>(magnitudes.size()));
  std::nth_element(magnitudes.begin(), magnitudes.begin() + exempt, magnitudes.end(),
                   std::greater{});
  return magnitudes.at(exempt);
}

std::vector<std::string> doubts_of(const CaseDefinition& definition, const RunResult& result) {
  std::vector<std::string> doubts;
  const auto judge = [&](const SoundnessLimit& of, double value) {
    if (value <= of.limit) return;
    const auto shown = [&](double one) {
      return of.is_share ? in_unit(one, "1") : fmt::format("{:.2g}", one);
    };
    doubts.push_back(fmt::format("its {} is {}, limit {}", of.name, shown(value), shown(of.limit)));
  };
  for (const SoundnessLimit& one : soundness_limits)
    for (const TimeSeries& series : result.series)
      if (series.name == one.series && !series.value.empty() &&
          (definition.gravity > 0 || series.name != "tension_share"))
        judge(one, usual_largest(series));
  if (const auto found = result.diagnostics.find(courant_limit.series);
      found != result.diagnostics.end())
    judge(courant_limit, found->second);
  return doubts;
}

}  // namespace

std::string soundness_doubt(const CaseDefinition& definition, const CaseRuns& runs,
                            const std::set<std::string>& named) {
  std::string text;
  std::vector<std::string> others;
  for (const RunDefinition& run : definition.runs) {
    const auto result = runs.results.find(run.name);
    if (!named.contains(run.ensemble.empty() ? run.name : run.ensemble) ||
        result == runs.results.end())
      continue;
    const std::vector<std::string> doubts = doubts_of(definition, result->second);
    if (doubts.empty()) continue;
    if (text.empty())
      text = fmt::format("{} is not sound: {}", run.name, fmt::join(doubts, ", "));
    else
      others.push_back(run.name);
  }
  if (others.empty()) return text;
  return fmt::format("{}; nor {} {}", text, others.size() == 1 ? "is" : "are",
                     fmt::join(others, ", "));
}

std::string doubtful_runs(const CaseDefinition& definition, const CaseRuns& runs) {
  std::set<std::string> judged;
  for (const GateRow& row : definition.gate)
    judged.insert({row.candidate, row.reference, row.improves_on.value_or("")});
  const std::string doubt = soundness_doubt(definition, runs, judged);
  return doubt.empty() ? "" : fmt::format("doubtful: {}: {}", definition.name, doubt);
}

}  // namespace slosh
