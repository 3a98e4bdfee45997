#include "verification/input/tables/time_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "verification/input/tables/table_head.hpp"
#include "verification/input/tables/table_rows.hpp"
#include "verification/input/units.hpp"

namespace slosh {
namespace {

constexpr double pascal_per_mbar = 100;
constexpr std::size_t fewest_runs = 2;  // needed for a scatter

using Row = std::array<double, 4>;

std::optional<Row> row_of(const TableReader& reader) {
  const auto fields = fields_of(reader.line(), ' ');
  Row row{};
  if (fields.size() != row.size()) return std::nullopt;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::optional<double> number = number_in(fields[i]);
    if (!number || !std::isfinite(*number)) return std::nullopt;
    row[i] = *number;
  }
  return row;
}

bool names_mbar(std::string line) {
  std::transform(line.begin(), line.end(), line.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return line.find("mbar") != std::string::npos;
}

constexpr std::size_t least_rows = 4;  // what motion.hpp's spline and a comparison need

TimeTable read_table(TableReader& reader, const TableHead& head, const SeriesPlaces& places) {
  std::vector<TableSegment> segments = read_segments(reader, head, places);
  if (segments.size() > 1)
    throw table_error(reader.file(), segments[1].lines.front(), head.columns[head.time].name,
                      fmt::format("{}", segments[1].time.front()),
                      fmt::format("a number above the last row's {}, in {}",
                                  segments[0].time.back(), places.time_unit));
  TableSegment& rows = segments.front();
  if (rows.time.size() < least_rows)
    reader.refuse("rows", std::to_string(rows.time.size()), fmt::format("at least {}", least_rows));
  return {places.name, std::move(rows.time), std::move(rows.value), std::move(rows.lines)};
}

// "displacement_m" of "displacement [m]" too.
std::string written_name(const TableColumn& column) {
  std::string name = column.unit.empty() ? column.name : column.name + "_" + column.unit;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

// "m" of "displacement_m", "m/s2" of "acceleration_m_s2".
std::string unit_of_name(const std::string& column) {
  const std::size_t last = column.rfind('_'), word = column.rfind('_', last - 1);
  if (!column.ends_with("_s2") || word == column.npos) return column.substr(last + 1);
  return column.substr(word + 1, last - word - 1) + "/s2";
}

// The places of the columns of such a name.
std::vector<std::size_t> places_of(const TableHead& head, const std::string& name) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < head.columns.size(); ++i)
    if (written_name(head.columns[i]) == written_name({name, ""})) places.push_back(i);
  return places;
}

}  // namespace

PeakTable read_peak_table(const std::filesystem::path& file) {
  TableReader reader(file);
  if (reader.line_number() == 0)
    reader.refuse("title", "", "a file that can be read and holds a table of peaks");
  if (!names_mbar(reader.line()))
    reader.refuse("title", reader.line(), "a title that names the unit, mbar");
  if (!reader.next() || fields_of(reader.line(), ' ').empty() || row_of(reader))
    reader.refuse("header", reader.line(), "the names of the columns");

  PeakTable table;
  while (reader.next()) {
    if (fields_of(reader.line(), ' ').empty()) continue;
    const std::optional<Row> row = row_of(reader);
    if (!row || reader.is_cut())
      reader.refuse("row", reader.line(), "four numbers, in mbar, and an end of the line");
    for (std::size_t i = 0; i < row->size(); ++i)
      table.impacts[i].push_back(pascal_per_mbar * (*row)[i]);
  }
  const std::size_t runs = table.impacts.front().size();
  if (runs < fewest_runs)
    reader.refuse("rows", std::to_string(runs), fmt::format("at least {}", fewest_runs));
  return table;
}

TimeTable read_time_table(const std::filesystem::path& file,
                          const std::vector<std::string>& columns) {
  const auto found_in = [&](const TableHead& head) {
    std::vector<SeriesPlaces> found;
    for (const std::string& column : columns)
      for (const std::size_t place : places_of(head, column))
        found.push_back(
            {.summands = {place}, .name = column, .time_unit = "s", .unit = unit_of_name(column)});
    return found;
  };
  const auto has_series = [&](const TableHead& head) {
    return places_of(head, "time_s").size() == 1 && found_in(head).size() == 1;
  };
  TableReader reader(file);
  TableHead head = find_head(reader, has_series);
  if (!has_series(head))
    throw table_error(file, head.line, "header", head.text,
                      fmt::format("time_s and {}{}", columns.size() == 1 ? "" : "one of ",
                                  fmt::join(columns, ", ")));
  head.time = places_of(head, "time_s").front();
  return read_table(reader, head, found_in(head).front());
}

TimeTable read_time_columns(const std::filesystem::path& file, const TimeColumns& columns) {
  TableReader reader(file);
  TableHead head = find_head(reader, {columns.time, columns.value});
  head.time = column_place(reader, head, "time_column", columns.time);
  const std::size_t value = column_place(reader, head, "value_column", columns.value);
  const TableColumn& time = head.columns[head.time];
  const bool is_told = !time.unit.empty() || !unit_at_end(time.name, "s").empty();
  const std::string time_unit =
      agreed_unit(file, {"time_column", is_told ? "" : "s", "time", "s", columns.time}, time);
  ToldUnit told = columns.unit;
  told.column = columns.value;
  TimeTable table = read_table(reader, head,
                               {.summands = {value},
                                .name = columns.value,
                                .time_unit = time_unit,
                                .unit = agreed_unit(file, told, head.columns[value])});
  for (double& one : table.time) one *= si_value(time_unit, "s");
  return table;
}

}  // namespace slosh
