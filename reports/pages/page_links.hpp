// The pages on which the anchors of a report stand, and the links to them.
#pragma once

#include <map>
#include <string>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

// The layout of a report in HTML.
enum class Layout {
  pages,  // one file for each page
  whole   // all pages in one document
};

// Returns "index.html" for the first page, whose id is empty, and "<id>.html" for the others.
std::string page_file(const std::string& page_id);

// Maps every anchor of the report to the id of the page that it stands on. The report's own ids
// must be unique (check_report.hpp).
std::map<std::string, std::string> anchors_of(const Report& report);

// Writes the addresses of anchors for a page or for the whole document.
class PageLinks {
 public:
  PageLinks(const Report& report, Layout layout) : pages_(anchors_of(report)), layout_(layout) {}

  // Returns "#row-surge-3" on the same page or in the whole document, "surge.html#row-surge-3" from
  // another page. The anchor must be one of the report's.
  std::string to_anchor(const std::string& anchor, const std::string& from_page) const;

  // Returns "surge.html", or "#page-surge" in the whole document.
  std::string to_page(const std::string& page_id) const;

 private:
  std::map<std::string, std::string> pages_;
  Layout layout_;
};

}  // namespace slosh::reports
