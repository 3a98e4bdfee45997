// The pages on which the anchors of a report stand, and the links to them.
#pragma once

#include <map>
#include <string>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

// Returns "index.html" for the first page, whose id is empty, and "<id>.html" for the others.
std::string page_file(const std::string& page_id);

// Maps every anchor of the report to the id of the page that it stands on. The report's own ids
// must be unique (check_report.hpp).
std::map<std::string, std::string> anchors_of(const Report& report);

// Writes the addresses of anchors for a page.
class PageLinks {
 public:
  explicit PageLinks(const Report& report) : pages_(anchors_of(report)) {}

  // Returns "#row-surge-3" on the same page, "surge.html#row-surge-3" from another page. The anchor
  // must be one of the report's.
  std::string to_anchor(const std::string& anchor, const std::string& from_page) const;

 private:
  std::map<std::string, std::string> pages_;
};

}  // namespace slosh::reports
