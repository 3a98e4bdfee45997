#include "verification/evidence/soundness.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ranges>
#include <utility>
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

// The magnitude that the series exceeds for that share of its samples inside of the window, or of
// all where none lies inside; NaN where one is NaN.
double usual_largest(const TimeSeries& series, TimeWindow window) {
  std::vector<double> magnitudes;
  for (std::size_t i = 0; i < series.value.size(); ++i)
    if (series.time[i] >= window.begin && series.time[i] <= window.end)
      magnitudes.push_back(std::abs(series.value[i]));
  if (magnitudes.empty()) return usual_largest(series, {series.time.front(), series.time.back()});
  const auto exempt =
      static_cast<std::ptrdiff_t>(exempt_share * static_cast<double>(magnitudes.size()));
  const bool has_nan = std::ranges::any_of(magnitudes, [](double one) { return std::isnan(one); });
  if (!has_nan) std::ranges::nth_element(magnitudes, magnitudes.begin() + exempt, std::greater{});
  return has_nan ? not_a_number : magnitudes[static_cast<std::size_t>(exempt)];
}

// Over the window, and over all the time that led to its end.
double usual_largest_until_end(const TimeSeries& series, TimeWindow window) {
  const double inside = usual_largest(series, window),
               until = usual_largest(series, {series.time.front(), window.end});
  return inside >= until || std::isnan(inside) ? inside : until;
}

// Adds the doubts of the runs of these names by name, of an ensemble those of the first that has
// any, unless they are told already.
void add_unsound(const CaseDefinition& definition, const CaseRuns& runs,
                 const std::set<std::string>& named,
                 std::vector<std::pair<std::string, std::string>>& told) {
  const TimeWindow window{definition.window_begin, definition.window_end};
  for (const RunDefinition& run : definition.runs) {
    const auto result = runs.results.find(run.name);
    const std::string& group = run.ensemble.empty() ? run.name : run.ensemble;
    const bool is_named = named.contains(run.name) || named.contains(group);
    const bool is_told = std::ranges::any_of(told, [&](auto& one) { return one.first == group; });
    if (!is_named || is_told || result == runs.results.end()) continue;
    const std::string doubts = soundness_doubts(result->second, window, definition.gravity > 0);
    if (!doubts.empty())
      told.emplace_back(group, fmt::format("{} is not sound: {}", run.name, doubts));
  }
}

std::string joined(const std::vector<std::pair<std::string, std::string>>& told) {
  std::vector<std::string> texts;
  for (const auto& [group, text] : told) texts.push_back(text);
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace

std::string soundness_doubts(const RunResult& result, TimeWindow window, bool has_gravity) {
  std::vector<std::string> doubts;
  for (const auto& [recorded, name, limit] : soundness_limits) {
    double value = 0;
    for (const TimeSeries& series : result.series)
      if (series.name == recorded && !series.value.empty())
        value = usual_largest_until_end(series, window);
    if (const auto fact = result.diagnostics.find(recorded); fact != result.diagnostics.end())
      value = fact->second;
    const bool has_scale = has_gravity || recorded != std::string("tension_share");
    if (!(value <= limit) && has_scale)
      doubts.push_back(fmt::format("its {} is {:.2g}, limit {:.2g}", name, value, limit));
  }
  return fmt::format("{}", fmt::join(doubts, ", "));
}

std::string soundness_doubt(const CaseDefinition& definition, const CaseRuns& runs,
                            const std::set<std::string>& named) {
  std::vector<std::pair<std::string, std::string>> told;
  add_unsound(definition, runs, named, told);
  return joined(told);
}

std::string doubtful_runs(const CaseDefinition& definition, const CaseRuns& runs) {
  std::vector<std::pair<std::string, std::string>> told;
  for (const GateRow& row : definition.gate)
    add_unsound(judged_over(row, definition), runs,
                {row.candidate, row.reference, row.improves_on.value_or("")}, told);
  return told.empty() ? "" : fmt::format("doubtful: {}: {}", definition.name, joined(told));
}

}  // namespace slosh
