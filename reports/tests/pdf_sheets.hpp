// What lies where on the sheets of a PDF file that Chromium printed.
#pragma once

#include <string>
#include <vector>

namespace slosh::reports {

// As shares of the sheet's height, from its top.
struct PdfSheet {
  double filled;   // down to where the page's own text reaches
  bool is_marked;  // whether there is text in the margin below, as a page number
};

// Throws std::runtime_error for a stream that zlib cannot inflate.
std::vector<PdfSheet> pdf_sheets(const std::string& pdf);

}  // namespace slosh::reports
