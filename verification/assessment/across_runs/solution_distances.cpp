#include "verification/assessment/across_runs/solution_distances.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/time_series.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

// Returns NaN for series that cannot be compared.
double distance(const TimeSeries& one, const TimeSeries& other, TimeWindow window) try {
  const TimeWindow both{std::max({window.begin, one.time.front(), other.time.front()}),
                        std::min({window.end, one.time.back(), other.time.back()})};
  cut_to_window(one, both);  // for its checks
  const CommonSamples common = common_samples(one, cut_to_window(other, both));
  return rms(minus(common.candidate, common.reference)) /
         std::sqrt(rms(without_mean(common.candidate)) * rms(without_mean(common.reference)));
} catch (const ComparisonError&) {
  return not_a_number;
}

std::vector<std::string> finest_unchanged_runs(const CaseAssessment& assessment,
                                               const std::string& quantity) {
  std::map<std::string, const RunDefinition*> finest;
  for (const RunDefinition& run : assessment.definition.runs) {
    if (is_changed(run) || !has_series(assessment.runs, run.name, quantity)) continue;
    const RunDefinition*& standing = finest[family(run)];
    if (!standing || resolution(run) > resolution(*standing)) standing = &run;
  }
  std::vector<std::string> names;
  for (const RunDefinition& run : assessment.definition.runs)
    if (const auto found = finest.find(family(run)); found != finest.end() && found->second == &run)
      names.push_back(run.name);
  return names;
}

// The mean over all other members but `left_out`; NaN where no distance is finite.
double mean_distance(const std::vector<double>& distances, std::size_t own, std::size_t left_out) {
  double sum = 0;
  int count = 0;
  for (std::size_t j = 0; j < distances.size(); ++j) {
    if (j == own || j == left_out || !std::isfinite(distances[j])) continue;
    sum += distances[j];
    ++count;
  }
  return count == 0 ? not_a_number : sum / count;
}

}  // namespace

std::optional<std::size_t> outlier(const std::vector<std::vector<double>>& distances) {
  constexpr double apart = 2;
  const std::size_t n = distances.size();
  for (std::size_t i = 0; i < n; ++i) {
    double among = 0;
    int counted = 0;
    for (std::size_t k = 0; k < n; ++k) {
      if (k == i) continue;
      const double others = mean_distance(distances[k], k, i);
      if (!std::isfinite(others)) continue;
      among += others;
      ++counted;
    }
    if (counted > 0 && mean_distance(distances[i], i, i) > apart * among / counted) return i;
  }
  return {};
}

SolutionDistances solution_distances(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  SolutionDistances found;
  found.quantity = compared_quantities(definition).front();
  found.runs = finest_unchanged_runs(assessment, found.quantity);
  const TimeWindow window{definition.window_begin, definition.window_end};
  const std::size_t n = found.runs.size();
  found.distances.assign(n, std::vector<double>(n, 0.0));
  const auto series = [&](std::size_t i) -> const TimeSeries& {
    return assessment.runs.results.at(found.runs[i]).at(found.quantity);
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j)
      found.distances[i][j] = found.distances[j][i] = distance(series(i), series(j), window);
  return found;
}

}  // namespace slosh
