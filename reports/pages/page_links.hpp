// Where the anchors of a report stand, and how a page leads to them.
#pragma once

#include <map>
#include <string>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

// How a report is laid out in HTML.
enum class Layout {
  pages,  // each page a file
  whole   // all pages in one document
};

// "index.html" of the first page, whose id is empty; "<id>.html" of the others.
std::string page_file(const std::string& page_id);

// Every anchor of the report and the id of the page that it stands on. The report's own ids are
// assumed to be unique (check_report.hpp).
std::map<std::string, std::string> anchors_of(const Report& report);

// Addresses of anchors, as a page or the whole document writes them.
class PageLinks {
 public:
  PageLinks(const Report& report, Layout layout) : pages_(anchors_of(report)), layout_(layout) {}

  // "#row-surge-3" on the same page or in the whole document, "surge.html#row-surge-3" from
  // another. The anchor is one of the report's.
  std::string to_anchor(const std::string& anchor, const std::string& from_page) const;

  // "surge.html", or "#page-surge" in the whole document.
  std::string to_page(const std::string& page_id) const;

 private:
  std::map<std::string, std::string> pages_;
  Layout layout_;
};

}  // namespace slosh::reports
