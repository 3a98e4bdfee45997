// The report as HTML: a self-contained file for each page, and one document of all for printing.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "reports/pages/html_sections.hpp"

namespace slosh::reports {

struct HtmlFile {
  std::string name;  // "index.html"
  std::string text;
};

// Every file that is written here says so: whoever replaces a report knows its pages by it.
inline constexpr const char* page_mark = "<meta name=\"generator\" content=\"Slosh report\">";

// index.html, then the others, each a file of its own that links to the rest.
std::vector<HtmlFile> html_pages(const Report& report, const Drawings& drawings);

// All pages one after the other.
std::string whole_document(const Report& report, const Drawings& drawings);

}  // namespace slosh::reports
