#include "verification/case_file/time_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <optional>

namespace slosh {
namespace {

constexpr std::size_t least_rows = 4;  // what motion.hpp's spline and a comparison need

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

std::optional<double> finite_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == line.npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file), stream_(file) {
    next();  // the header; of an empty file an empty one
  }

  const std::string& header() const { return line_; }

  [[noreturn]] void refuse(std::string_view key, std::string_view value,
                           std::string_view expected) const {
    throw table_error(file_, std::max(line_number_, 1), key, value, expected);
  }

  TimeTable table(const TimeColumns& columns) {
    const auto fields = fields_of(header());
    const auto place = [&](const std::string& column) {
      const auto found = std::find(fields.begin(), fields.end(), column);
      if (found == fields.end())
        refuse("header", header(),
               fmt::format("the columns {} and {}", columns.time, columns.value));
      return static_cast<std::size_t>(found - fields.begin());
    };
    const std::size_t time = place(columns.time), value = place(columns.value);
    const std::size_t count = fields.size();
    TimeTable table{columns.value, {}, {}};
    while (next()) {
      const auto row = fields_of(line_);
      if (row.size() != count)
        refuse("row", line_, fmt::format("{} values with commas between them", count));
      add_time(columns.time, row[time], table.time);
      table.value.push_back(number(columns.value, row[value], columns.value_unit));
    }
    if (table.time.size() < least_rows)
      refuse("rows", std::to_string(table.time.size()), fmt::format("at least {}", least_rows));
    return table;
  }

 private:
  bool next() {
    if (!std::getline(stream_, line_)) {
      if (stream_.bad()) refuse("rows", "cut off", "a file that can be read to its end");
      return false;
    }
    ++line_number_;
    if (line_.ends_with('\r')) line_.pop_back();
    return true;
  }

  void add_time(std::string_view column, std::string_view text, std::vector<double>& times) const {
    const double time = number(column, text, "s");
    if (!times.empty() && time <= times.back()) {
      refuse(column, text, fmt::format("a number above the last row's {}, in s", times.back()));
    }
    times.push_back(time);
  }

  double number(std::string_view column, std::string_view text, std::string_view unit) const {
    const std::optional<double> value = finite_number(text);
    if (!value) refuse(column, text, fmt::format("a number, in {}", unit));
    return *value;
  }

  std::filesystem::path file_;
  std::ifstream stream_;
  std::string line_;
  int line_number_ = 0;
};

}  // namespace

TimeTable read_time_table(const std::filesystem::path& file,
                          const std::vector<std::string>& columns) {
  Reader reader(file);
  std::vector<std::string> headers;
  for (const std::string& column : columns) {
    headers.push_back("time_s," + column);
    if (reader.header() == headers.back())
      return reader.table({"time_s", column, column.substr(column.find_last_of('_') + 1)});
  }
  reader.refuse(
      "header", reader.header(),
      fmt::format("{}{}", headers.size() == 1 ? "" : "one of ", fmt::join(headers, " | ")));
}

TimeTable read_time_columns(const std::filesystem::path& file, const TimeColumns& columns) {
  return Reader(file).table(columns);
}

CaseFileError table_error(const std::filesystem::path& file, int line, std::string_view key,
                          std::string_view value, std::string_view expected) {
  return CaseFileError(
      fmt::format("{}:{}: {} = {}: expected {}", file.string(), line, key, value, expected));
}

}  // namespace slosh
