#include "reports/pages/write_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "reports/model/report_files.hpp"
#include "reports/pages/check_report.hpp"
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

}  // namespace slosh::reports
