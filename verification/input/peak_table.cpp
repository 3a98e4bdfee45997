#include "verification/input/peak_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "verification/input/time_table.hpp"

namespace slosh {
namespace {

constexpr double pascal_per_mbar = 100;
constexpr std::size_t fewest_runs = 2;  // needed for a scatter

using Row = std::array<double, 4>;

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::optional<double> finite_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::optional<Row> row_of(const std::string& line) {
  const std::vector<std::string> words = words_of(line);
  Row row{};
  if (words.size() != row.size()) return std::nullopt;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::optional<double> number = finite_number(words[i]);
    if (!number) return std::nullopt;
    row[i] = *number;
  }
  return row;
}

bool names_mbar(std::string line) {
  std::transform(line.begin(), line.end(), line.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return line.find("mbar") != std::string::npos;
}

}  // namespace

PeakTable read_peak_table(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  int number = 0;
  const auto refuse = [&](const char* key, std::string_view value, std::string_view expected) {
    throw table_error(file, std::max(number, 1), key, value, expected);
  };
  const auto next = [&] {
    if (!std::getline(stream, line)) {
      if (stream.bad()) refuse("rows", "cut off", "a file that can be read to its end");
      return false;
    }
    ++number;
    if (line.ends_with('\r')) line.pop_back();
    return true;
  };
  if (!next()) refuse("title", "", "a file that can be read and holds a table of peaks");
  if (!names_mbar(line)) refuse("title", line, "a title that names the unit, mbar");
  if (!next() || words_of(line).empty() || row_of(line))
    refuse("header", line, "the names of the columns");

  PeakTable table;
  while (next()) {
    if (words_of(line).empty()) continue;
    const std::optional<Row> row = row_of(line);
    if (!row) refuse("row", line, "four numbers, in mbar");
    for (std::size_t i = 0; i < row->size(); ++i)
      table.impacts[i].push_back(pascal_per_mbar * (*row)[i]);
  }
  const std::size_t runs = table.impacts.front().size();
  if (runs < fewest_runs)
    refuse("rows", std::to_string(runs), fmt::format("at least {}", fewest_runs));
  return table;
}

}  // namespace slosh
