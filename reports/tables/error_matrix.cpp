#include "reports/tables/error_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "verification/case/quantities.hpp"
#include "verification/case/run_family.hpp"
#include "verification/series/estimate.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

// NaN of series that cannot be compared.
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

// In the order of the case file.
std::vector<std::string> members(const CaseAssessment& assessment, const std::string& quantity) {
  std::map<std::string, const RunDefinition*> finest;
  for (const RunDefinition& run : assessment.definition.runs) {
    if (!assessment.runs.results.contains(run.name) || is_changed(run) ||
        !has_series(assessment.runs, run.name, quantity))
      continue;
    const RunDefinition*& standing = finest[family(run)];
    if (!standing || resolution(run) > resolution(*standing)) standing = &run;
  }
  std::vector<std::string> names;
  for (const RunDefinition& run : assessment.definition.runs)
    if (const auto found = finest.find(family(run)); found != finest.end() && found->second == &run)
      names.push_back(run.name);
  return names;
}

// To all but those two.
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

std::optional<std::size_t> odd_one_out(const std::vector<std::vector<double>>& distances) {
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

std::optional<reports::Table> error_matrix(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const std::string quantity = compared_quantities(definition).front();
  const std::vector<std::string> names = members(assessment, quantity);
  if (names.size() < 3) return {};
  const TimeWindow window{definition.window_begin, definition.window_end};
  std::vector<std::vector<double>> distances(names.size(), std::vector<double>(names.size(), 0.0));
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      distances[i][j] = distances[j][i] =
          distance(assessment.runs.results.at(names[i]).at(quantity),
                   assessment.runs.results.at(names[j]).at(quantity), window);
  const auto odd = odd_one_out(distances);
  reports::Table table{
      definition.name + "-closure",
      "Who agrees with whom",
      fmt::format(
          "Distance of the histories of {} [%]: rms of the difference over the root of both "
          "rms about their means. {}.",
          quantity,
          odd ? fmt::format("`{}` stands apart: its mean distance to the others is more than "
                            "twice theirs among one another",
                            names[*odd])
              : "None stands apart from the others by more than twice their own distances"),
      {"run"},
      {}};
  table.header.insert(table.header.end(), names.begin(), names.end());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool valid = assessment.runs.status.at(names[i]).state != RunState::out_of_range;
    std::vector<std::string> row{valid ? names[i] : names[i] + " (out of its range)"};
    for (std::size_t j = 0; j < names.size(); ++j)
      row.push_back(i == j || !std::isfinite(distances[i][j])
                        ? ""
                        : fmt::format("{:.3g}", 100 * distances[i][j]));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace slosh
