#include "verification/texts/series_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "reports/model/file_formats.hpp"

namespace slosh {
namespace {

// A text may have several lines.
std::string comment(const std::string& text) {
  std::string lines = "# ";
  for (const char letter : text) lines += letter == '\n' ? "\n# " : std::string(1, letter);
  return lines + "\n";
}

// Returns the times of all series, increasing, each once.
std::vector<double> moments(const RunResult& result) {
  std::vector<double> all;
  for (const TimeSeries& series : result.series) {
    const bool increases = std::adjacent_find(series.time.begin(), series.time.end(),
                                              std::not_fn(std::less())) == series.time.end();
    if (!increases)
      throw ResultError("the series " + series.name + ": expected times that increase");
    all.insert(all.end(), series.time.begin(), series.time.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

std::string theory_line(const TheoryRemarks& remarks) {
  return remarks.outside
             ? fmt::format("{} is outside its range: it {}", remarks.run, *remarks.outside)
             : fmt::format("{} is inside its range: {}", remarks.run, remarks.range);
}

std::string theory_csv(const CaseDefinition& definition, const CaseTheories& theories) {
  std::string text = comment(fmt::format("Case {}: {}", definition.name, definition.title)) +
                     comment("Source: " + definition.source);
  for (const TheoryRemarks& remarks : theories.remarks) {
    text += comment(fmt::format("{}: {}", remarks.run, remarks.solution));
    text += comment(fmt::format("{}, range: {}", remarks.run, remarks.range));
    if (remarks.outside) text += comment(theory_line(remarks));
    text += comment(fmt::format("{}, uncertainty: {}", remarks.run, remarks.uncertainty));
  }
  return text + series_csv(theories.result);
}

std::string series_csv(const RunResult& result) {
  std::vector<std::string> cells{"time [s]"};
  for (const TimeSeries& series : result.series)
    cells.push_back(series.name + " [" + series.unit + "]");
  std::string text = reports::csv_line(cells);
  std::vector<std::size_t> next(result.series.size(), 0);
  for (const double time : moments(result)) {
    cells.assign(1, reports::csv_number(time));
    for (std::size_t i = 0; i < result.series.size(); ++i) {
      const TimeSeries& series = result.series[i];
      const bool has_value = next[i] < series.time.size() && series.time[next[i]] == time;
      cells.push_back(has_value ? reports::csv_number(series.value[next[i]++]) : "");
    }
    text += reports::csv_line(cells);
  }
  return text;
}

}  // namespace slosh
