// Comma-separated values (RFC 4180, but for lines that end in "\n" alone), the same in any locale.
#pragma once

#include <string>
#include <vector>

namespace slosh::reports {

// A line with its end. A cell with a comma, a quote or a line break is quoted.
std::string csv_line(const std::vector<std::string>& cells);

// The shortest text that reads as the same number; empty of one that is none.
std::string csv_number(double value);

}  // namespace slosh::reports
