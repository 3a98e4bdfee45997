#include "reports/pages/page_links.hpp"

namespace slosh::reports {

std::string page_file(const std::string& page_id) {
  return (page_id.empty() ? "index" : page_id) + ".html";
}

std::map<std::string, std::string> anchors_of(const Report& report) {
  std::map<std::string, std::string> pages;
  for (const Section& section : report.sections) {
    pages["section-" + section.id] = section.page;
    for (const Figure& figure : section.figures) pages["figure-" + figure.id] = section.page;
    for (const FieldFigure& figure : section.fields) pages["figure-" + figure.id] = section.page;
    for (const Table& table : section.tables) {
      pages["table-" + table.id] = section.page;
      for (const std::string& row : table.row_ids) pages["row-" + row] = section.page;
    }
  }
  return pages;
}

std::string PageLinks::to_anchor(const std::string& anchor, const std::string& from_page) const {
  const std::string& page = pages_.at(anchor);
  return (page == from_page ? "" : page_file(page)) + "#" + anchor;
}

}  // namespace slosh::reports
