#include "reports/pages/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "reports/drawing/field_range.hpp"
#include "reports/fields/field_layout.hpp"
#include "reports/model/report_model.hpp"
#include "reports/pages/page_links.hpp"

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

void check_row_anchors(const Table& table, std::set<std::string>& taken) {
  if (!table.row_ids.empty() && table.row_ids.size() != table.rows.size()) {
    throw ReportError(fmt::format("table '{}': {} row_ids, expected {} as the rows, or none",
                                  table.id, table.row_ids.size(), table.rows.size()));
  }
  for (const std::string& id : table.row_ids) check_id("row", id, taken);
}

void check_reasons(const Table& table) {
  if (!table.reasons.empty() && table.reasons.size() != table.rows.size())
    throw ReportError(fmt::format("table '{}': {} reasons, expected {} as the rows, or none",
                                  table.id, table.reasons.size(), table.rows.size()));
}

void check_links(const Table& table, const std::map<std::string, std::string>& anchors) {
  if (table.links.empty()) return;
  const auto width = [](const auto& row) { return row.size(); };
  if (!std::ranges::equal(table.links, table.rows, {}, width, width))
    throw ReportError(
        fmt::format("table '{}': expected one link per cell, empty for none", table.id));
  for (const auto& row : table.links)
    for (const std::string& anchor : row)
      if (!anchor.empty() && !anchors.contains(anchor)) {
        throw ReportError(fmt::format(
            "table '{}': a link leads to '{}', which the report does not have", table.id, anchor));
      }
}

// Every section must stand on an existing page, and every page must have a section.
void check_pages(const Report& report) {
  std::set<std::string> pages{"index"}, used;  // the first page's file has this name
  for (const Page& page : report.pages) check_id("page", page.id, pages);
  for (const Section& section : report.sections) {
    if (!section.page.empty() && (section.page == "index" || !pages.contains(section.page))) {
      throw ReportError(
          fmt::format("section '{}' is on the page '{}', which the report does not have",
                      section.id, section.page));
    }
    used.insert(section.page);
  }
  std::string before;  // the page that an appendix continues, and its other appendices, precede it
  for (const Page& page : report.pages) {
    if (!used.contains(page.id))
      throw ReportError(fmt::format("page '{}' has no section", page.id));
    if (!page.continues.empty() && page.continues != before)
      throw ReportError(fmt::format("page '{}' continues '{}', expected the page before it",
                                    page.id, page.continues));
    if (page.continues.empty()) before = page.id;
  }
}

void check_curve(const Figure& figure, const Curve& curve) {
  const auto fits = [&](const std::vector<double>& values) {
    return values.empty() || values.size() == curve.y.size();
  };
  if (curve.x.size() != curve.y.size() || !fits(curve.y_error) || !fits(curve.x_error))
    throw ReportError(fmt::format(
        "figure '{}', curve '{}': {} x, {} y, {} y_error, {} x_error values, expected equally many",
        figure.id, curve.label, curve.x.size(), curve.y.size(), curve.y_error.size(),
        curve.x_error.size()));
  if (curve.lower.size() != curve.upper.size() || !fits(curve.lower))
    throw ReportError(fmt::format(
        "figure '{}', curve '{}': a ribbon of {} lower and {} upper values about {} y, expected "
        "equally many",
        figure.id, curve.label, curve.lower.size(), curve.upper.size(), curve.y.size()));
  if (!curve.lower.empty() && curve.ribbon.empty())
    throw ReportError(
        fmt::format("figure '{}', curve '{}': a ribbon without a name, expected what it shows",
                    figure.id, curve.label));
}

void check_range(const Figure& figure, const char* name, std::pair<double, double> range,
                 bool logarithmic) {
  const auto [lower, upper] = range;
  if (lower == upper) return;
  if (!(lower < upper) || !std::isfinite(lower) || !std::isfinite(upper) ||
      (logarithmic && lower <= 0)) {
    throw ReportError(fmt::format("figure '{}': {} {} to {}, expected increasing finite values{}",
                                  figure.id, name, lower, upper,
                                  logarithmic ? " above zero for a logarithmic axis" : ""));
  }
}

void check_figure(const Figure& figure) {
  for (const Curve& curve : figure.curves) check_curve(figure, curve);
  if (figure.equal_axes && (figure.log_x || figure.log_y))
    throw ReportError(
        fmt::format("figure '{}': equal axes, expected none of them logarithmic", figure.id));
  check_range(figure, "x_range", figure.x_range, figure.log_x);
  check_range(figure, "y_range", figure.y_range, figure.log_y);
}

void check_panel(const FieldFigure& figure, const FieldPanel& panel) {
  const auto refuse = [&](const std::string& why) {
    throw ReportError(fmt::format("figure '{}', panel '{}': {}", figure.id, panel.label, why));
  };
  if (panel.x.size() != panel.z.size() || panel.x.size() != panel.value.size()) {
    refuse(fmt::format("{} x, {} z, {} values, expected equally many", panel.x.size(),
                       panel.z.size(), panel.value.size()));
  }
  const std::size_t arrows = panel.arrow_x.size();
  if (panel.arrow_z.size() != arrows || panel.arrow_u.size() != arrows ||
      panel.arrow_w.size() != arrows) {
    refuse(fmt::format("{} arrow_x, {} arrow_z, {} arrow_u, {} arrow_w, expected equally many",
                       arrows, panel.arrow_z.size(), panel.arrow_u.size(), panel.arrow_w.size()));
  }
  for (const auto& [name, value] :
       {std::pair{"tank_length", panel.tank_length}, std::pair{"tank_height", panel.tank_height},
        std::pair{"point_width", panel.point_width},
        std::pair{"point_height", panel.point_height}}) {
    if (!(value > 0) || !std::isfinite(value))
      refuse(fmt::format("{} {}, expected a finite length above zero [m]", name, value));
  }
  if (panel.outline.size() == 1 || panel.outline.size() == 2)
    refuse(fmt::format("an outline of {} corners, expected none or three and more",
                       panel.outline.size()));
  for (const TankCorner& corner : panel.outline)
    if (!std::isfinite(corner.x) || !std::isfinite(corner.z))
      refuse(fmt::format("corner ({}, {}), expected finite lengths [m]", corner.x, corner.z));
  for (const auto& [name, value] :
       {std::pair{"angle", panel.angle}, std::pair{"axis_x", panel.axis_x},
        std::pair{"axis_z", panel.axis_z}}) {
    if (!std::isfinite(value)) refuse(fmt::format("{} {}, expected a finite value", name, value));
  }
}

void check_field(const FieldFigure& figure) {
  if (figure.panels.empty()) throw ReportError(fmt::format("figure '{}': no panels", figure.id));
  if (figure.columns < 1) {
    throw ReportError(
        fmt::format("figure '{}': columns {}, expected 1 or more", figure.id, figure.columns));
  }
  const std::size_t in_a_row =
      std::min(static_cast<std::size_t>(figure.columns), figure.panels.size());
  if (in_a_row > static_cast<std::size_t>(most_columns())) {
    throw ReportError(fmt::format("figure '{}': {} panels in a row, expected at most {}", figure.id,
                                  in_a_row, most_columns()));
  }
  if (figure.is_animation && figure.panels.size() % static_cast<std::size_t>(figure.columns) != 0)
    throw ReportError(
        fmt::format("figure '{}': an animation of {} panels in rows of {}, expected "
                    "whole rows",
                    figure.id, figure.panels.size(), figure.columns));
  if (!(figure.arrow_scale >= 0) || !std::isfinite(figure.arrow_scale)) {
    throw ReportError(
        fmt::format("figure '{}': arrow_scale {}, expected 0 (automatic) or metres "
                    "per metre a second above it",
                    figure.id, figure.arrow_scale));
  }
  const auto [lower, upper] = figure.value_range;
  if (lower != upper && !is_range(lower, upper)) {
    throw ReportError(
        fmt::format("figure '{}': value_range {} to {}, expected increasing finite "
                    "values, or equal ones for an automatic range",
                    figure.id, lower, upper));
  }
  for (const FieldPanel& panel : figure.panels) check_panel(figure, panel);
}

}  // namespace

void check_report(const Report& report) {
  check_pages(report);
  std::set<std::string> sections, tables, rows, figures;
  for (const Section& section : report.sections) {
    check_id("section", section.id, sections);
    for (const Table& table : section.tables) {
      check_id("table", table.id, tables);
      check_table(table);
      check_row_anchors(table, rows);
      check_reasons(table);
    }
    for (const Figure& figure : section.figures) {
      check_id("figure", figure.id, figures);
      check_figure(figure);
    }
    for (const FieldFigure& figure : section.fields) {
      check_id("figure", figure.id, figures);
      check_field(figure);
    }
  }
  for (const Page& page : report.pages) {
    if (!page.glance) continue;
    check_id("figure", page.glance->id, figures);
    check_figure(*page.glance);
  }
  const std::map<std::string, std::string> anchors = anchors_of(report);
  for (const Section& section : report.sections)
    for (const Table& table : section.tables) check_links(table, anchors);
  const Link& decides = report.decision.row;
  if (!decides.text.empty() && !anchors.contains(decides.anchor))
    throw ReportError(
        fmt::format("decided by '{}', which the report does not have", decides.anchor));
  try {
    [[maybe_unused]] const auto parsed = nlohmann::json::parse(report.results_json);
  } catch (const nlohmann::json::parse_error& error) {
    throw ReportError(fmt::format("results_json is not JSON: {}", error.what()));
  }
}

}  // namespace slosh::reports
