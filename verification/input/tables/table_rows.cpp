#include "verification/input/tables/table_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace slosh {
namespace {

std::string_view first_word(std::string_view line) {
  line = without_comment_mark(line);
  return line.substr(0, line.find_first_of(" \t;,"));
}

// What one value stands apart from all others by.
struct Standing {
  std::size_t count = 0;  // of samples that have it
  double nearest = std::numeric_limits<double>::infinity(), lowest = nearest, highest = -nearest;
};

Standing standing_of(double mark, const std::vector<double>& values) {
  Standing of;
  for (const double value : values) {
    if (value == mark) {
      ++of.count;
      continue;
    }
    of.nearest = std::min(of.nearest, std::abs(value - mark));
    of.lowest = std::min(of.lowest, value);
    of.highest = std::max(of.highest, value);
  }
  return of;
}

// 1000 for 999, 999.9 and 999.99; 0 for a number of other digits.
double end_of_nines(double size) {
  for (double end = 100; end <= 1e9; end *= 10)
    for (double last = 1; last > 1e-4; last /= 10)
      if (std::abs(size - (end - last)) < 1e-12 * end) return end;
  return 0;
}

// Programs and loggers write nines, or the least or largest number of an integer. Two nines are a
// value too, unless they stand apart from all others by more than these do from one another. So is
// any other whole number, unless it comes more than once and stands apart by ten times as much.
bool is_mark(double value, const std::vector<double>& values) {
  static constexpr std::array<double, 6> of_integers{32767,      32768,      65535,
                                                     2147483647, 2147483648, 4294967295};
  const double size = std::abs(value), nines = end_of_nines(size);
  const bool is_whole = size >= 9 && value == std::round(value);
  if (!is_whole && nines == 0) return false;
  const Standing of = standing_of(value, values);
  if (!(of.nearest > size / 2)) return false;
  if (nines > 100 || std::ranges::count(of_integers, size) > 0) return true;
  const double apart = of.nearest / (of.highest - of.lowest);
  return (nines == 100 && apart > 1) || (of.count > 1 && apart > 10 && std::isfinite(apart));
}

double sum_of(const TableReader& reader, const std::vector<std::string_view>& fields,
              const SeriesPlaces& places) {
  double sum = 0;
  for (const std::size_t place : places.summands) {
    const double value = reader.number(places.name, fields[place], places.unit);
    if (!(std::abs(value) < least_mark_of_none))
      reader.refuse(places.name, fields[place],
                    fmt::format("{}, in {}", no_mark_of_none, places.unit));
    sum += value;
  }
  return sum;
}

void refuse_marks(const TableReader& reader, const std::vector<TableSegment>& segments,
                  const SeriesPlaces& places) {
  std::vector<double> values;
  std::vector<int> lines;
  for (const TableSegment& segment : segments) {
    values.insert(values.end(), segment.value.begin(), segment.value.end());
    lines.insert(lines.end(), segment.lines.begin(), segment.lines.end());
  }
  if (const auto mark = first_mark_of_none(values))
    throw table_error(reader.file(), lines[*mark], places.name, fmt::format("{}", values[*mark]),
                      fmt::format("{}, in {}", no_mark_of_none, places.unit));
}

}  // namespace

bool TableRows::next() {
  follows_head_ = false;
  while (!started_ || reader_.next()) {
    started_ = true;
    const std::string_view line = trimmed(reader_.line());
    if (line.empty()) continue;
    const bool is_head = line == trimmed(head_.text);
    if (!is_head && !is_comment(line)) {
      fields_ = fields_of_row(reader_, head_);
      return true;
    }
    const std::string_view word = first_word(line);
    if (!is_head && !word.empty() && word == first_word(head_.text))
      reader_.refuse(
          "head", line,
          fmt::format("the head of line {} again: the columns must stay the same", head_.line));
    follows_head_ = true;
  }
  return false;
}

std::vector<TableSegment> read_segments(TableReader& reader, const TableHead& head,
                                        const SeriesPlaces& places) {
  const std::string& time_name = head.columns[head.time].name;
  std::vector<TableSegment> segments(1);
  TableRows rows(reader, head);
  while (rows.next()) {
    const auto& fields = rows.fields();
    const std::string_view text = fields[head.time];
    const double time = reader.number(time_name, text, places.time_unit);
    const std::vector<double>& before = segments.back().time;
    const bool goes_back = !before.empty() && time <= before.back();
    if (goes_back && !rows.follows_head())
      reader.refuse(
          time_name, text,
          fmt::format("a number above the last row's {}, in {}", before.back(), places.time_unit));
    for (const MarkOfNone& one : head.marks)
      if (places.summands.front() == one.column && fields[one.column] == fields[one.mark])
        reader.refuse(places.name, fields[one.column], one.expected);
    if (goes_back) segments.emplace_back();
    segments.back().time.push_back(time);
    segments.back().value.push_back(sum_of(reader, fields, places));
    segments.back().lines.push_back(reader.line_number());
  }
  refuse_marks(reader, segments, places);
  return segments;
}

std::optional<std::size_t> first_mark_of_none(const std::vector<double>& values) {
  auto first = std::find_if(values.begin(), values.end(),
                            [](double value) { return !(std::abs(value) < least_mark_of_none); });
  if (first == values.end() && !values.empty()) {
    // A mark is the lowest or the highest value.
    const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
    for (const double extreme : {*lowest, *highest})
      if (is_mark(extreme, values))
        first = std::min(first, std::find(values.begin(), first, extreme));
  }
  if (first == values.end()) return std::nullopt;
  return static_cast<std::size_t>(first - values.begin());
}

}  // namespace slosh
