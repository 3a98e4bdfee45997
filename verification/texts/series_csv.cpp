#include "verification/texts/series_csv.hpp"

#include <algorithm>
#include <functional>

#include "reports/model/file_formats.hpp"

namespace slosh {
namespace {

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
