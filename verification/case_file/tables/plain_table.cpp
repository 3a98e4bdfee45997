#include "verification/case_file/tables/plain_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "verification/case/quantities.hpp"
#include "verification/input/tables/table_head.hpp"
#include "verification/input/units.hpp"

namespace slosh {
namespace {

// "s" of "t_s", "t [s]" and "t": the unit that the head gives, or else the SI unit.
bool gives_unit(const TableColumn& column, const std::string& si_unit) {
  const std::vector<std::string> known = unit_names(si_unit);
  return !column.unit.empty() || std::any_of(known.begin(), known.end(), [&](const auto& unit) {
    return column.name.ends_with("_" + unit);
  });
}

bool is_of_times(const TableColumn& column) {
  for (const char* name : {"t", "time", "Time", "t_s", "time_s"})
    if (column.name == name) return true;
  return false;
}

std::optional<std::size_t> time_column(const TableHead& head) {
  const auto found = std::find_if(head.columns.begin(), head.columns.end(), is_of_times);
  if (found == head.columns.end()) return {};
  return static_cast<std::size_t>(found - head.columns.begin());
}

}  // namespace

std::vector<SeriesSource> series_of_table(const std::filesystem::path& file,
                                          const CaseDefinition& definition) {
  TableReader reader(file);
  const TableHead head = find_head(
      reader, [](const TableHead& one) { return one.columns.size() > 1 && time_column(one); });
  const auto time = time_column(head);
  if (!time)
    throw table_error(file, head.line, "columns", head.text, "the column of times, t or time");
  const std::vector<std::string> known = compared_quantities(definition);
  std::vector<SeriesSource> all;
  for (std::size_t i = 0; i < head.columns.size(); ++i) {
    const TableColumn& column = head.columns[i];
    const bool is_named = std::find(known.begin(), known.end(), column.name) != known.end();
    // A column alone may have any name but that of a quantity which the case does not compare.
    const bool is_alone = head.columns.size() == 2 && !find_quantity(column.name);
    if (i == *time || !(is_named || is_alone)) continue;
    const std::string quantity = is_named ? column.name : known.front();
    all.push_back({.quantity = quantity,
                   .file = file,
                   .format = "csv",
                   .column = column.name,
                   .unit = gives_unit(column, unit_of(quantity)) ? "" : unit_of(quantity),
                   .time_column = head.columns[*time].name,
                   .time_unit = gives_unit(head.columns[*time], "s") ? "" : "s"});
  }
  if (all.empty())
    throw table_error(file, head.line, "columns", head.text,
                      fmt::format("beside the times one column, or columns with names of the "
                                  "case's quantities, {}",
                                  fmt::join(known, ", ")));
  return all;
}

}  // namespace slosh
