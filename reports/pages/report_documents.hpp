// The documents of a report: an HTML file for each page, one HTML document of all pages for
// printing, Markdown, and a page of figures alone.
#pragma once

#include <filesystem>
#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "reports/drawing/draw_figure.hpp"
#include "reports/fields/draw_field.hpp"
#include "reports/model/report_model.hpp"
#include "reports/pages/page_links.hpp"

namespace slosh::reports {

// The drawings of a report: one for each figure, for each field and for each page, in the report's
// order. That of a page without a glance is empty.
struct Drawings {
  std::vector<DrawnFigure> figures;
  std::vector<DrawnField> fields;
  std::vector<DrawnFigure> glances = {};
};

// The sections as data of the HTML templates, in the report's order. Tables and figures are
// numbered through the whole report. A section's heading has level 2, or 3 where the whole report
// is one document.
std::vector<kainjow::mustache::data> sections_data(const Report& report, const Drawings& drawings,
                                                   Layout layout);

struct HtmlFile {
  std::string name;  // "index.html"
  std::string text;
};

// Every HTML file of a report contains this; it tells a report's pages from other files.
inline constexpr const char* page_mark = "<meta name=\"generator\" content=\"Slosh report\">";

// Returns index.html, then the others, each a self-contained file that links to the rest.
std::vector<HtmlFile> html_pages(const Report& report, const Drawings& drawings);

// Returns all pages one after the other in one document.
std::string whole_document(const Report& report, const Drawings& drawings);

// Returns the report as GitHub-flavoured Markdown. Its figures are linked as figures/<id>.svg, its
// fields as figures/<id>.png.
std::string markdown_page(const Report& report);

// Returns an HTML file that needs no network: a title, the figures with their titles and captions,
// and remarks below them. Throws ReportError as draw_figure() does.
std::string figure_page(const std::string& title, const std::vector<Figure>& figures,
                        const std::vector<std::string>& remarks,
                        const std::filesystem::path& scratch_directory);

}  // namespace slosh::reports
