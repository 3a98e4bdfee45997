#include "reports/tables/rest_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/case/ensemble.hpp"

namespace slosh {
namespace {

// "no number" where a value is none.
std::string largest(const TimeSeries& series, TimeWindow window) {
  double largest = 0;
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    if (series.time[i] < window.begin || series.time[i] > window.end) continue;
    if (!std::isfinite(series.value[i])) return "no number";
    largest = std::max(largest, std::abs(series.value[i]));
  }
  return fmt::format("{:.2g}", largest);
}

}  // namespace

std::optional<reports::Table> rest_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const TimeWindow whole{0, definition.duration};
  const TimeWindow late{definition.window_begin, definition.window_end};
  reports::Table table{
      definition.name + "-rest",
      "How far from rest",
      fmt::format("Largest magnitudes over the whole run and from {} to {} s. Pressure: rms "
                  "difference from the hydrostatic one, over that at the bottom. Gap: between a "
                  "wall and the particles next to it, in spacings. All others are ratios.",
                  late.begin, late.end),
      {"run"},
      {}};
  for (const std::string name : rest_quantities) {
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    table.header.push_back(words);
    table.header.push_back(fmt::format("{}, from {} s", words, late.begin));
  }
  for (const RunDefinition& run : definition.runs) {
    const auto result = assessment.runs.results.find(run.name);
    if (is_later_member(run) || result == assessment.runs.results.end() ||
        !has_series(assessment.runs, run.name, rest_quantities[0]))
      continue;
    std::vector<std::string> row{run.name};
    for (const char* name : rest_quantities)
      for (const TimeWindow window : {whole, late})
        row.push_back(largest(result->second.at(name), window));
    table.rows.push_back(std::move(row));
  }
  if (table.rows.empty()) return std::nullopt;
  return table;
}

}  // namespace slosh
