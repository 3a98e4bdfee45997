#include "verification/case_file/time_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>

namespace slosh {
namespace {

constexpr std::string_view time_column = "time_s,";
constexpr std::size_t least_rows = 4;  // what motion.hpp's spline and a comparison need

std::optional<double> finite_number(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file), stream_(file) {}

  TimeTable table(const std::vector<std::string>& columns) {
    read_header(columns);
    while (next()) add_row();
    if (table_.time.size() < least_rows) {
      refuse("rows", std::to_string(table_.time.size()), fmt::format("at least {}", least_rows));
    }
    return table_;
  }

 private:
  bool next() {
    if (!std::getline(stream_, line_)) return false;
    ++line_number_;
    if (line_.ends_with('\r')) line_.pop_back();
    return true;
  }

  void read_header(const std::vector<std::string>& columns) {
    std::vector<std::string> headers;
    for (const std::string& column : columns) headers.push_back(std::string(time_column) + column);
    if (!next() || std::find(headers.begin(), headers.end(), line_) == headers.end()) {
      refuse("header", line_,
             fmt::format("{}{}", headers.size() == 1 ? "" : "one of ", fmt::join(headers, " | ")));
    }
    table_.column = line_.substr(time_column.size());
  }

  void add_row() {
    const std::size_t comma = line_.find(',');
    if (comma == std::string::npos) refuse("row", line_, "two numbers and a comma between them");
    const std::string_view line = line_;
    const double time = number("time_s", line.substr(0, comma));
    if (!table_.time.empty() && time <= table_.time.back()) {
      refuse("time_s", line.substr(0, comma),
             fmt::format("a number above the last row's {}, in s", table_.time.back()));
    }
    table_.time.push_back(time);
    table_.value.push_back(number(table_.column, line.substr(comma + 1)));
  }

  double number(std::string_view column, std::string_view text) const {
    const std::optional<double> value = finite_number(text);
    if (!value) {
      refuse(column, text,
             fmt::format("a number, in {}", column.substr(column.find_last_of('_') + 1)));
    }
    return *value;
  }

  [[noreturn]] void refuse(std::string_view key, std::string_view value,
                           std::string_view expected) const {
    throw table_error(file_, std::max(line_number_, 1), key, value, expected);
  }

  std::filesystem::path file_;
  std::ifstream stream_;
  std::string line_;
  int line_number_ = 0;
  TimeTable table_;
};

}  // namespace

TimeTable read_time_table(const std::filesystem::path& file,
                          const std::vector<std::string>& columns) {
  return Reader(file).table(columns);
}

CaseFileError table_error(const std::filesystem::path& file, int line, std::string_view key,
                          std::string_view value, std::string_view expected) {
  return CaseFileError(
      fmt::format("{}:{}: {} = {}: expected {}", file.string(), line, key, value, expected));
}

}  // namespace slosh
