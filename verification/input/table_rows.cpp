#include "verification/input/table_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace slosh {
namespace {

constexpr std::array<double, 3> likely_marks{999, 9999, 99999};

std::string_view first_word(std::string_view line) {
  line = without_comment_mark(line);
  return line.substr(0, line.find_first_of(" \t;,"));
}

bool stands_alone(double mark, const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [mark](double value) {
    return value == mark || std::abs(value - mark) > std::abs(mark) / 2;
  });
}

double time_after(const TableReader& reader, const std::string& column, std::string_view text,
                  const std::string& unit, const TableSegment& segment, bool may_go_back) {
  const double time = reader.number(column, text, unit);
  if (!may_go_back && !segment.time.empty() && time <= segment.time.back())
    reader.refuse(
        column, text,
        fmt::format("a number above the last row's {}, in {}", segment.time.back(), unit));
  return time;
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
    const bool is_head = !line.empty() && line == trimmed(head_.text);
    const std::string_view word = first_word(line);
    if (!is_head && is_comment(line) && !word.empty() && word == first_word(head_.text))
      reader_.refuse(
          "head", line,
          fmt::format("the head of line {} again: the columns must stay the same", head_.line));
    follows_head_ |= is_head || is_comment(line);
    if (line.empty() || is_head || is_comment(line)) continue;
    fields_ = fields_of_row(reader_, head_);
    return true;
  }
  return false;
}

std::vector<TableSegment> read_segments(TableReader& reader, const TableHead& head,
                                        const SeriesPlaces& places) {
  std::vector<TableSegment> segments(1);
  TableRows rows(reader, head);
  while (rows.next()) {
    const auto& fields = rows.fields();
    const double time = time_after(reader, head.columns[head.time].name, fields[head.time],
                                   places.time_unit, segments.back(), rows.follows_head());
    for (const MarkOfNone& one : head.marks)
      if (places.summands.front() == one.column && fields[one.column] == fields[one.mark])
        reader.refuse(places.name, fields[one.column], one.expected);
    const double value = sum_of(reader, fields, places);
    if (!segments.back().time.empty() && time <= segments.back().time.back())
      segments.emplace_back();
    segments.back().time.push_back(time);
    segments.back().value.push_back(value);
    segments.back().lines.push_back(reader.line_number());
  }
  refuse_marks(reader, segments, places);
  return segments;
}

std::optional<std::size_t> first_mark_of_none(const std::vector<double>& values) {
  auto first = std::find_if(values.begin(), values.end(),
                            [](double value) { return !(std::abs(value) < least_mark_of_none); });
  for (const double magnitude : likely_marks)
    for (const double mark : {-magnitude, magnitude})
      if (const auto found = std::find(values.begin(), first, mark);
          found != first && stands_alone(mark, values))
        first = found;
  if (first == values.end()) return std::nullopt;
  return static_cast<std::size_t>(first - values.begin());
}

}  // namespace slosh
