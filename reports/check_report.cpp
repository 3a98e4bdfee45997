#include "reports/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "reports/write_report.hpp"

namespace slosh::reports {
namespace {

void check_id(const char* kind, const std::string& id, std::set<std::string>& taken) {
  const bool fit = !id.empty() && std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  });
  if (!fit)
    throw ReportError(fmt::format("{} id '{}': expected letters, digits, '-' and '_'", kind, id));
  if (!taken.insert(id).second)
    throw ReportError(fmt::format("{} id '{}' is used twice", kind, id));
}

void check_table(const Table& table) {
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (table.rows[i].size() != table.header.size()) {
      throw ReportError(fmt::format("table '{}', row {}: {} cells, expected {} as in the header",
                                    table.id, i + 1, table.rows[i].size(), table.header.size()));
    }
  }
}

void check_figure(const Figure& figure) {
  for (const Curve& curve : figure.curves) {
    const bool bars_fit = curve.y_error.empty() || curve.y_error.size() == curve.y.size();
    if (curve.x.size() != curve.y.size() || !bars_fit) {
      throw ReportError(fmt::format(
          "figure '{}', curve '{}': {} x, {} y, {} y_error values, expected equally many",
          figure.id, curve.label, curve.x.size(), curve.y.size(), curve.y_error.size()));
    }
  }
  const auto [lower, upper] = figure.x_range;
  if (lower == upper) return;
  if (!(lower < upper) || !std::isfinite(lower) || !std::isfinite(upper) ||
      (figure.log_x && lower <= 0)) {
    throw ReportError(
        fmt::format("figure '{}': x_range {} to {}, expected increasing finite values{}", figure.id,
                    lower, upper, figure.log_x ? " above zero for a logarithmic axis" : ""));
  }
}

}  // namespace

void check_report(const Report& report) {
  std::set<std::string> sections, tables, figures;
  for (const Section& section : report.sections) {
    check_id("section", section.id, sections);
    for (const Table& table : section.tables) {
      check_id("table", table.id, tables);
      check_table(table);
    }
    for (const Figure& figure : section.figures) {
      check_id("figure", figure.id, figures);
      check_figure(figure);
    }
  }
  try {
    [[maybe_unused]] const auto parsed = nlohmann::json::parse(report.results_json);
  } catch (const nlohmann::json::parse_error& error) {
    throw ReportError(fmt::format("results_json is not JSON: {}", error.what()));
  }
}

}  // namespace slosh::reports
