#include "openfoam_cases/output/read_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "openfoam_cases/errors.hpp"

namespace slosh::openfoam {
namespace {

namespace fs = std::filesystem;

// Throws RunError unless a sample comes at every interval up to the end.
void check_times(const SloshingTank& tank, const std::vector<double>& times, const fs::path& file) {
  const double interval = tank.sample_interval;
  double previous = 0;
  for (const double time : times) {
    if (!(time > previous && time - previous < 1.5 * interval)) {
      refuse(file, fmt::format("a sample at {} s follows one at {} s, expected one every {} s",
                               time, previous, interval));
    }
    previous = time;
  }
  const double last = std::floor(tank.duration / interval * (1 + 1e-9)) * interval;
  if (!(std::abs(previous - last) < 0.5 * interval)) {
    refuse(file, fmt::format("ends at {} s, expected {} s", previous, last));
  }
}

}  // namespace

std::vector<double> numbers_in(std::string row) {
  std::replace_if(
      row.begin(), row.end(), [](char c) { return c == '(' || c == ')' || c == '\t'; }, ' ');
  std::vector<double> numbers;
  for (const char *at = row.data(), *end = at + row.size();;) {
    while (at != end && *at == ' ') ++at;
    if (at == end) return numbers;
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc{}) return {};
    numbers.push_back(value);
    at = next;
  }
}

fs::path series_file(const fs::path& case_directory, const std::string& function_object,
                     const char* name) {
  return case_directory / "postProcessing" / function_object / "0" / name;
}

Rows read_rows(const SloshingTank& tank, const fs::path& file, std::size_t columns) {
  std::ifstream in(file);
  if (!in) refuse(file, "missing: a function object has not run");
  Rows rows;
  int line_number = 0;
  for (std::string line; std::getline(in, line);) {
    ++line_number;
    if (line.starts_with('#')) continue;
    const std::vector<double> numbers = numbers_in(line);
    if (numbers.size() != columns ||
        !std::all_of(numbers.begin(), numbers.end(), [](double v) { return std::isfinite(v); })) {
      refuse(file, fmt::format("line {}: \"{}\": expected {} finite numbers", line_number, line,
                               columns));
    }
    rows.time.push_back(numbers[0]);
    rows.values.emplace_back(numbers.begin() + 1, numbers.end());
  }
  check_times(tank, rows.time, file);
  return rows;
}

History read_series(const SloshingTank& tank, const fs::path& file, std::size_t columns) {
  Rows rows = read_rows(tank, file, columns);
  History history{std::move(rows.time), {}};
  for (const std::vector<double>& values : rows.values) history.value.push_back(values[0]);
  return history;
}

}  // namespace slosh::openfoam
