#include "reports/tests/pdf_sheets.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace slosh::reports {
namespace {

constexpr double sheet_height = 841.92;  // [pt], of A4
constexpr double margin = 0.94;          // the body ends above

std::string inflated(std::string_view stream) {
  std::string text;
  z_stream state{};
  if (inflateInit(&state) != Z_OK) throw std::runtime_error("zlib does not start");
  state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(stream.data()));
  state.avail_in = static_cast<uInt>(stream.size());
  std::array<char, 1 << 16> part;
  int status = Z_OK;
  while (status == Z_OK) {
    state.next_out = reinterpret_cast<Bytef*>(part.data());
    state.avail_out = static_cast<uInt>(part.size());
    status = inflate(&state, Z_NO_FLUSH);
    text.append(part.data(), part.size() - state.avail_out);
  }
  inflateEnd(&state);
  if (status != Z_STREAM_END) throw std::runtime_error("a stream of the PDF is broken");
  return text;
}

// The vertical part of a transformation: y becomes scale y + shift.
struct Vertical {
  double scale = 1, shift = 0;
  Vertical of(double by, double offset) const { return {scale * by, scale * offset + shift}; }
};

// Follows the transformations and notes where each text stands. Nothing on a page is turned but the
// labels of vertical axes, which lie between others.
PdfSheet sheet_of(const std::string& content) {
  PdfSheet sheet{0, false};
  std::vector<Vertical> saved;
  Vertical now;
  std::istringstream lines(content);
  for (std::string line; std::getline(lines, line);) {
    if (line == "q") saved.push_back(now);
    if (line == "Q" && !saved.empty()) {
      now = saved.back();
      saved.pop_back();
    }
    const bool moves = line.ends_with(" cm");
    if (!moves && !line.ends_with(" Tm")) continue;
    double a, b, c, d, e, f;
    std::istringstream(line) >> a >> b >> c >> d >> e >> f;
    if (moves) {
      now = now.of(d, f);
      continue;
    }
    const double down = 1 - (now.scale * f + now.shift) / sheet_height;
    if (down > margin)
      sheet.is_marked = true;
    else
      sheet.filled = std::max(sheet.filled, down);
  }
  return sheet;
}

// Returns the number that follows the word; 0 without it.
std::size_t number_after(std::string_view text, std::string_view word) {
  const std::size_t at = text.find(word);
  return at == text.npos ? 0 : std::stoul(std::string(text.substr(at + word.size(), 12)));
}

}  // namespace

std::vector<PdfSheet> pdf_sheets(const std::string& pdf) {
  std::vector<PdfSheet> sheets;
  const std::string opening = "<</Type /Page\n";
  for (std::size_t at = pdf.find(opening); at != pdf.npos; at = pdf.find(opening, at + 1)) {
    const std::size_t end = pdf.find("endobj", at);
    const std::size_t object =
        number_after(std::string_view(pdf).substr(at, end - at), "/Contents ");
    const std::size_t begin = pdf.find("\n" + std::to_string(object) + " 0 obj\n");
    const std::size_t stream = pdf.find("stream\n", begin);
    const std::string_view head = std::string_view(pdf).substr(begin, stream - begin);
    sheets.push_back(sheet_of(
        inflated(std::string_view(pdf).substr(stream + 7, number_after(head, "/Length ")))));
  }
  return sheets;
}

}  // namespace slosh::reports
