#include "reports/pages/write_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "reports/drawing/field_parts.hpp"
#include "reports/model/report_files.hpp"
#include "reports/model/report_model.hpp"
#include "reports/pages/report_documents.hpp"
#include "reports/templates.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/own_files.hpp"
#include "verification/files/protected_inputs.hpp"

namespace slosh::reports {
namespace {

namespace fs = std::filesystem;

// Draws each figure once and writes it to the directory as <id>.svg, or as <id>.png for a field and
// <id>.gif for an animation. A field takes seconds, a figure a tenth of a second: the long ones are
// drawn first.
Drawings draw_report(const Report& report, const WriteOptions& options, const fs::path& scratch,
                     const fs::path& directory) {
  Drawings drawings;
  std::vector<std::function<void()>> fields, figures;
  const auto draw = [&](const Figure& figure, DrawnFigure& drawn) {
    figures.emplace_back([&] {
      drawn = draw_figure(figure, scratch, options.gnuplot);
      write_text(directory / (figure.id + ".svg"), svg_element(figure, drawn, SvgPlace::own_file));
    });
  };
  std::size_t field_count = 0, figure_count = 0;
  for (const Section& section : report.sections) {
    field_count += section.fields.size();
    figure_count += section.figures.size();
  }
  drawings.fields.resize(field_count);
  drawings.figures.resize(figure_count);
  drawings.glances.resize(report.pages.size());
  auto drawn_field = drawings.fields.begin();
  auto drawn_figure = drawings.figures.begin();
  for (const Section& section : report.sections) {
    for (const Figure& figure : section.figures) draw(figure, *drawn_figure++);
    for (const FieldFigure& figure : section.fields)
      fields.emplace_back([&, &drawn = *drawn_field++] {
        drawn = draw_field(figure, scratch, options.gnuplot);
        write_text(directory / picture_file(figure), drawn.picture);
      });
  }
  for (std::size_t i = 0; i < report.pages.size(); ++i)
    if (report.pages[i].glance) draw(*report.pages[i].glance, drawings.glances[i]);
  std::ranges::move(figures, std::back_inserter(fields));
  side_by_side(fields.size(), options.threads, [&](std::size_t i) { fields[i](); });
  return drawings;
}

void write_files(const Report& report, const Drawings& drawings, const fs::path& directory) {
  for (const HtmlFile& file : html_pages(report, drawings))
    write_text(directory / file.name, file.text);
  for (const Section& section : report.sections)
    for (const Table& table : section.tables)
      if (rows_on_page(table) < table.rows.size()) {
        fs::create_directories(directory / "tables");
        std::string text = csv_line(table.header);
        for (const auto& row : table.rows) text += csv_line(row);
        write_text(directory / table_file(table), text);
      }
  write_text(directory / "results.json", report.results_json);
  write_text(directory / "results.schema.json", results_schema);
}

std::vector<fs::path> files_in(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    if (!fs::is_directory(entry.symlink_status()))
      files.push_back(entry.path().lexically_relative(directory));
  std::sort(files.begin(), files.end());
  return files;
}

// Replaces the pages one by one, so that a user's files beside them stay where they are. The first
// page and the data, which tell the verdict, come last.
void replace_pages(const fs::path& complete, const fs::path& target) {
  const std::vector<fs::path> files = files_in(complete);
  const std::set<fs::path> last{"index.html", "results.json"};
  for (const bool is_last : {false, true})
    for (const fs::path& file : files)
      if (last.contains(file) == is_last) {
        const fs::path place = target / file, directory = place.parent_path();
        if (fs::is_regular_file(fs::symlink_status(directory))) make_room(directory);
        replace_own(place, read_bytes(complete / file));
      }
  for (const fs::path& old : files_in(target))
    if (!std::binary_search(files.begin(), files.end(), old) && old.filename() != ".slosh" &&
        !foreign_at(target / old))
      fs::remove(target / old);
}

}  // namespace

Report with_legible_figures(Report report) {
  for (Section& section : report.sections)
    for (Figure& figure : section.figures) {
      const std::size_t count = figure.curves.size();
      if (count <= most_curves) continue;
      figure.curves.resize(most_curves);
      figure.caption += fmt::format("{}The first {} of {} curves are drawn.",
                                    figure.caption.empty() ? "" : " ", most_curves, count);
    }
  return report;
}

void write_report(const Report& given, const fs::path& directory, const WriteOptions& options) try {
  check_report(given);
  const Report report = with_legible_figures(given);
  // The path is made absolute and loses a trailing slash, so that the temporary directory is beside
  // the target.
  fs::path target = fs::absolute(directory).lexically_normal();
  if (!target.has_filename()) target = target.parent_path();
  require_no_input(target);
  require_room(target / "index.html");
  if (fs::exists(target) && !fs::is_directory(target)) make_room(target);
  fs::create_directories(target.parent_path());
  const TemporaryDirectory temporary(target.string() + ".writing-");
  const fs::path complete = temporary.path() / "report";
  const fs::path scratch = temporary.path() / "drawing";
  fs::create_directory(scratch);
  fs::create_directories(complete / "figures");
  const Drawings drawings = draw_report(report, options, scratch, complete / "figures");
  write_files(report, drawings, complete);
  replace_pages(complete, target);
} catch (const fs::filesystem_error& error) {
  throw ReportError(
      fmt::format("cannot write the report {}: {}", directory.string(), error.what()));
}

namespace {

// Throws ReportError unless the condition holds of the part: "figure 'cost'", "page 'waves'".
void require(bool holds, const std::string& part, const std::string& expectation) {
  if (!holds) throw ReportError(part + ": expected " + expectation);
}

std::string named(const char* kind, const std::string& id) {
  return std::string(kind) + " '" + id + "'";
}

void check_id(const char* kind, const std::string& id, std::set<std::string>& taken) {
  const bool fit = !id.empty() && std::ranges::all_of(id, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  });
  require(fit, named(kind, id), "an id of letters, digits, '-' and '_'");
  require(taken.insert(id).second, named(kind, id), "an id that nothing else has");
}

void check_table(const Table& table, std::set<std::string>& row_ids) {
  const std::string name = named("table", table.id);
  for (const auto& row : table.rows)
    require(row.size() == table.header.size(), name, "as many cells in each row as in the header");
  require(table.row_ids.empty() || table.row_ids.size() == table.rows.size(), name,
          "as many row_ids as rows, or none");
  require(table.reasons.empty() || table.reasons.size() == table.rows.size(), name,
          "as many reasons as rows, or none");
  for (const std::string& id : table.row_ids) check_id("row", id, row_ids);
}

void check_links(const Table& table, const std::map<std::string, std::string>& anchors) {
  if (table.links.empty()) return;
  const auto width = [](const auto& row) { return row.size(); };
  require(std::ranges::equal(table.links, table.rows, {}, width, width), named("table", table.id),
          "one link per cell, empty for none");
  for (const auto& row : table.links)
    for (const std::string& anchor : row)
      require(anchor.empty() || anchors.contains(anchor), named("table", table.id),
              "links to anchors of the report, not to '" + anchor + "'");
}

// Every section must stand on an existing page, every page must have a section, and an appendix
// must follow the page that it continues, or another appendix of that.
void check_pages(const Report& report) {
  std::set<std::string> pages{"index"}, used;  // the first page's file has this name
  for (const Page& page : report.pages) check_id("page", page.id, pages);
  for (const Section& section : report.sections) {
    require(section.page.empty() || (section.page != "index" && pages.contains(section.page)),
            named("section", section.id), "a page of the report, not '" + section.page + "'");
    used.insert(section.page);
  }
  std::string before;
  for (const Page& page : report.pages) {
    require(used.contains(page.id), named("page", page.id), "a section");
    require(page.continues.empty() || page.continues == before, named("page", page.id),
            "the page '" + page.continues + "' before it, which it continues");
    if (page.continues.empty()) before = page.id;
  }
}

void check_curve(const Figure& figure, const Curve& curve) {
  const std::string name = fmt::format("figure '{}', curve '{}'", figure.id, curve.label);
  const auto fits = [&](const std::vector<double>& values) {
    return values.empty() || values.size() == curve.y.size();
  };
  require(curve.x.size() == curve.y.size() && fits(curve.y_error) && fits(curve.x_error), name,
          "equally many x, y, y_error and x_error");
  require(curve.lower.size() == curve.upper.size() && fits(curve.lower), name,
          "a ribbon of as many lower and upper values as there are y");
  require(curve.lower.empty() || !curve.ribbon.empty(), name, "a name of the ribbon");
}

void check_figure(const Figure& figure) {
  const std::string name = named("figure", figure.id);
  for (const Curve& curve : figure.curves) check_curve(figure, curve);
  require(!figure.equal_axes || (!figure.log_x && !figure.log_y), name,
          "no logarithmic axis where the axes are equal");
  for (const auto& [range, logarithmic] :
       {std::pair{figure.x_range, figure.log_x}, {figure.y_range, figure.log_y}}) {
    const auto [lower, upper] = range;
    require(lower == upper || (lower < upper && std::isfinite(lower) && std::isfinite(upper) &&
                               !(logarithmic && lower <= 0)),
            name, "ranges of increasing finite values, above zero on a logarithmic axis");
  }
}

void check_panel(const FieldFigure& figure, const FieldPanel& panel) {
  const std::string name = fmt::format("figure '{}', panel '{}'", figure.id, panel.label);
  const std::size_t places = panel.x.size(), arrows = panel.arrow_x.size();
  require(panel.z.size() == places && panel.value.size() == places, name,
          "equally many x, z and values");
  require(panel.arrow_z.size() == arrows && panel.arrow_u.size() == arrows &&
              panel.arrow_w.size() == arrows,
          name, "equally many arrow_x, arrow_z, arrow_u and arrow_w");
  for (const double length :
       {panel.tank_length, panel.tank_height, panel.point_width, panel.point_height})
    require(length > 0 && std::isfinite(length), name, "finite lengths above zero [m]");
  require(panel.outline.empty() || panel.outline.size() >= 3, name,
          "an outline of no corners, or of three and more");
  for (const TankCorner& corner : panel.outline)
    require(std::isfinite(corner.x) && std::isfinite(corner.z), name, "finite corners [m]");
  require(std::isfinite(panel.angle) && std::isfinite(panel.axis_x) && std::isfinite(panel.axis_z),
          name, "a finite angle and axis");
}

void check_field(const FieldFigure& figure) {
  const std::string name = named("figure", figure.id);
  require(!figure.panels.empty() && figure.columns > 0, name, "a panel and a column");
  const auto columns = static_cast<std::size_t>(figure.columns);
  require(std::min(columns, figure.panels.size()) <= static_cast<std::size_t>(most_columns()), name,
          fmt::format("at most {} panels in a row", most_columns()));
  require(!figure.is_animation || figure.panels.size() % columns == 0, name,
          "an animation of whole rows");
  require(figure.arrow_scale >= 0 && std::isfinite(figure.arrow_scale), name,
          "an arrow_scale of 0 (automatic) or of metres per metre a second");
  const auto [lower, upper] = figure.value_range;
  require(lower == upper || is_range(lower, upper), name,
          "a value_range of increasing finite values, or of equal ones (automatic)");
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
      check_table(table, rows);
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
  require(decides.text.empty() || anchors.contains(decides.anchor), "the decision",
          "an anchor of the report, not '" + decides.anchor + "'");
  require(nlohmann::json::accept(report.results_json), "results_json", "JSON");
}

}  // namespace slosh::reports
