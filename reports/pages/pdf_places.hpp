// Where the anchors of a printed document stand.
#pragma once

#include <map>
#include <string>

namespace slosh::reports {

// Returns the page, counted from 1, of each anchor that a link of the document leads to. `pdf` is
// the text of a file that Chromium printed.
std::map<std::string, int> pdf_places(const std::string& pdf);

}  // namespace slosh::reports
