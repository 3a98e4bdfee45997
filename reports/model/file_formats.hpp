// Comma-separated values, Base64, and what complete PNG and GIF files look like.
#pragma once

#include <string>
#include <vector>

namespace slosh::reports {

// A line of comma-separated values (RFC 4180, except that lines end in "\n" alone) with its line
// end, the same in any locale. A cell with a comma, a quote or a line break is quoted.
std::string csv_line(const std::vector<std::string>& cells);

// The shortest text that reads as the same number; empty for NaN.
std::string csv_number(double value);

// The bytes as text (RFC 4648, section 4).
std::string base64(const std::string& bytes);

// Whether the bytes have the signature and the last chunk of every PNG file (PNG specification,
// 5.2 and 11.2.5).
bool is_whole_png(const std::string& bytes);

// Whether the bytes have the signature and the trailer of every GIF file (GIF89a specification, 17
// and 27).
bool is_whole_gif(const std::string& bytes);

}  // namespace slosh::reports
