#include "verification/input/tables/peak_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "verification/input/tables/table_head.hpp"

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

}  // namespace slosh
