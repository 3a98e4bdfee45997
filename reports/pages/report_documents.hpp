// The documents of a report: an HTML file for each page, and a page of figures alone.
#pragma once

#include <filesystem>
#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "reports/pages/draw_report.hpp"

namespace slosh::reports {

// The sections as data of the HTML templates, in the report's order. The numbers of tables and
// figures begin at 1 on each page.
std::vector<kainjow::mustache::data> sections_data(const Report& report, const Drawings& drawings);

// The rows that a page shows of a table: all where they have anchors, else at most 100.
std::size_t rows_on_page(const Table& table);

// The file of a table that is too long for its page: "tables/<id>.csv".
std::string table_file(const Table& table);
std::string csv_of(const Table& table);

struct HtmlFile {
  std::string name;  // "index.html"
  std::string text;
};

// Returns index.html, then the others, each a self-contained file that links to the rest.
std::vector<HtmlFile> html_pages(const Report& report, const Drawings& drawings);

// Returns an HTML file that needs no network: a title, the figures with their titles and captions,
// and remarks below them. Throws ReportError as draw_figure() does.
std::string figure_page(const std::string& title, const std::vector<Figure>& figures,
                        const std::vector<std::string>& remarks,
                        const std::filesystem::path& scratch_directory);

}  // namespace slosh::reports
