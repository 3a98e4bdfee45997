#include "verification/input/time_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>

namespace slosh {
namespace {

constexpr std::size_t least_rows = 4;  // what motion.hpp's spline and a comparison need

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == line.npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

TimeTable read_table(TableReader& reader, const TimeColumns& columns) {
  const std::string header = reader.line();
  const auto fields = fields_of(header);
  const auto place = [&](const std::string& column) {
    const auto found = std::find(fields.begin(), fields.end(), column);
    if (found == fields.end())
      reader.refuse("header", header,
                    fmt::format("the columns {} and {}", columns.time, columns.value));
    return static_cast<std::size_t>(found - fields.begin());
  };
  const std::size_t time = place(columns.time), value = place(columns.value);
  TimeTable table{columns.value, {}, {}};
  while (reader.next()) {
    const auto row = fields_of(reader.line());
    if (row.size() != fields.size())
      reader.refuse("row", reader.line(),
                    fmt::format("{} values with commas between them", fields.size()));
    reader.add_time(columns.time, row[time], "s", table.time);
    table.value.push_back(reader.number(columns.value, row[value], columns.value_unit));
  }
  if (table.time.size() < least_rows)
    reader.refuse("rows", std::to_string(table.time.size()),
                  fmt::format("at least {}", least_rows));
  return table;
}

}  // namespace

TimeTable read_time_table(const std::filesystem::path& file,
                          const std::vector<std::string>& columns) {
  TableReader reader(file);
  std::vector<std::string> headers;
  for (const std::string& column : columns) {
    headers.push_back("time_s," + column);
    if (reader.line() == headers.back())
      return read_table(reader, {"time_s", column, column.substr(column.find_last_of('_') + 1)});
  }
  reader.refuse(
      "header", reader.line(),
      fmt::format("{}{}", headers.size() == 1 ? "" : "one of ", fmt::join(headers, " | ")));
}

TimeTable read_time_columns(const std::filesystem::path& file, const TimeColumns& columns) {
  TableReader reader(file);
  return read_table(reader, columns);
}

}  // namespace slosh
