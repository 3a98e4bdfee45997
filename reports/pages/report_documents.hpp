// The documents of a report: an HTML file for each page, and a page of figures alone.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "reports/drawing/draw_field.hpp"
#include "reports/drawing/draw_figure.hpp"
#include "reports/model/report_model.hpp"

namespace slosh::reports {

// The drawings of a report: one for each figure, for each field and for each page, in the report's
// order. The glance of a page that has none is empty.
struct Drawings {
  std::vector<DrawnFigure> figures;
  std::vector<DrawnField> fields;
  std::vector<DrawnFigure> glances = {};
};

// Maps every anchor of the report to the id of the page that it stands on. The report's own ids
// must be unique (write_report.hpp).
std::map<std::string, std::string> anchors_of(const Report& report);

// The rows that a page shows of a table: all where they have anchors, else at most 100.
std::size_t rows_on_page(const Table& table);

// The file of a table that is too long for its page: "tables/<id>.csv".
std::string table_file(const Table& table);

struct HtmlFile {
  std::string name;  // "index.html"
  std::string text;
};

// Returns index.html, then the others, each a self-contained file that links to the rest. The
// numbers of tables and figures begin at 1 on each page.
std::vector<HtmlFile> html_pages(const Report& report, const Drawings& drawings);

// Returns an HTML file that needs no network: a title, the figures with their titles and captions,
// and remarks below them. Throws ReportError as draw_figure() does.
std::string figure_page(const std::string& title, const std::vector<Figure>& figures,
                        const std::vector<std::string>& remarks,
                        const std::filesystem::path& scratch_directory);

}  // namespace slosh::reports
