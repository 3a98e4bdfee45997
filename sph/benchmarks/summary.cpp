#include "sph/benchmarks/summary.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace slosh::sph {
namespace {

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace

void Summary::enter(const std::string& table, const std::string& row, const std::string& column,
                    double value, Keep keep) {
  auto found = std::find_if(tables_.begin(), tables_.end(),
                            [&](const Table& t) { return t.title == table; });
  if (found == tables_.end()) found = tables_.insert(tables_.end(), Table{table, {}, {}, {}});
  add_once(found->rows, row);
  add_once(found->columns, column);
  const auto [place, fresh] = found->values.insert({{row, column}, value});
  if (!fresh && (keep == Keep::smallest ? value < place->second : value > place->second))
    place->second = value;
}

void Summary::print() const {
  for (const Table& table : tables_) print(table);
}

void Summary::print(const Table& table) {
  fmt::print("\n{}\n{:38}", table.title, "");
  for (const std::string& column : table.columns) fmt::print(" {:>14}", column);
  for (const std::string& row : table.rows) {
    fmt::print("\n{:38}", row);
    for (const std::string& column : table.columns) {
      const auto value = table.values.find({row, column});
      fmt::print(" {:>14}",
                 value == table.values.end() ? "" : fmt::format("{:.4g}", value->second));
    }
  }
  fmt::print("\n");
}

}  // namespace slosh::sph
