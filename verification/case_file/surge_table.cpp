#include "verification/case_file/surge_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "verification/case_file/case_file_error.hpp"

namespace slosh {
namespace {

constexpr std::string_view header = "time_s,displacement_m";
constexpr std::size_t least_rows = 4;  // what motion.hpp's spline needs

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
  explicit Reader(const std::filesystem::path& file) : stream_(file) { table_.file = file; }

  TableSurge table(double duration) {
    if (!next() || line_ != header) refuse("header", line_, header);
    while (next()) add_row();
    if (table_.time.size() < least_rows) {
      refuse("rows", std::to_string(table_.time.size()), fmt::format("at least {}", least_rows));
    }
    if (table_.time.back() < duration) {
      refuse("time_s", fmt::format("{}", table_.time.back()),
             fmt::format("a last time of at least the case's duration ({}), in s", duration));
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

  void add_row() {
    const std::size_t comma = line_.find(',');
    if (comma == std::string::npos) refuse("row", line_, "two numbers and a comma between them");
    const std::string_view line = line_;
    const double time = number("time_s", line.substr(0, comma), "a number, in s");
    if (table_.time.empty() && time != 0)
      refuse("time_s", line.substr(0, comma), "0 in the first row, in s");
    if (!table_.time.empty() && time <= table_.time.back()) {
      refuse("time_s", line.substr(0, comma),
             fmt::format("a number above the last row's {}, in s", table_.time.back()));
    }
    table_.time.push_back(time);
    table_.displacement.push_back(
        number("displacement_m", line.substr(comma + 1), "a number, in m"));
  }

  double number(std::string_view column, std::string_view text, std::string_view expected) const {
    const std::optional<double> value = finite_number(text);
    if (!value) refuse(column, text, expected);
    return *value;
  }

  [[noreturn]] void refuse(std::string_view key, std::string_view value,
                           std::string_view expected) const {
    throw CaseFileError(fmt::format("{}:{}: {} = {}: expected {}", table_.file.string(),
                                    std::max(line_number_, 1), key, value, expected));
  }

  std::ifstream stream_;
  std::string line_;
  int line_number_ = 0;
  TableSurge table_;
};

}  // namespace

TableSurge read_surge_table(const std::filesystem::path& file, double duration) {
  return Reader(file).table(duration);
}

}  // namespace slosh
