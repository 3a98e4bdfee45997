#include "verification/input/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace slosh {

TableReader::TableReader(const std::filesystem::path& file) : file_(file), stream_(file) { next(); }

bool TableReader::next() {
  if (!std::getline(stream_, line_)) {
    if (stream_.bad()) refuse("rows", "cut off", "a file that can be read to its end");
    return false;
  }
  ++line_number_;
  if (line_.ends_with('\r')) line_.pop_back();
  return true;
}

double TableReader::number(std::string_view column, std::string_view text,
                           std::string_view unit) const {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    refuse(column, text, fmt::format("a number, in {}", unit));
  return value;
}

void TableReader::add_time(std::string_view column, std::string_view text, std::string_view unit,
                           std::vector<double>& times) const {
  const double time = number(column, text, unit);
  if (!times.empty() && time <= times.back())
    refuse(column, text,
           fmt::format("a number above the last row's {}, in {}", times.back(), unit));
  times.push_back(time);
}

void TableReader::refuse(std::string_view key, std::string_view value,
                         std::string_view expected) const {
  throw table_error(file_, std::max(line_number_, 1), key, value, expected);
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

CaseFileError table_error(const std::filesystem::path& file, int line, std::string_view key,
                          std::string_view value, std::string_view expected) {
  return CaseFileError(
      fmt::format("{}:{}: {} = {}: expected {}", file.string(), line, key, value, expected));
}

}  // namespace slosh
