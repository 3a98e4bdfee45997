#include "reports/pages/text_markup.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <kainjow/mustache.hpp>
#include <regex>
#include <set>
#include <string_view>
#include <vector>

#include "verification/files/foreign/legible_text.hpp"

namespace slosh::reports {
namespace {

struct Piece {
  std::string text;
  bool is_code;
};

// A pair of backticks encloses code. An unpaired backtick is text.
std::vector<Piece> pieces(const std::string& shown) {
  const std::string text = legible(shown);
  std::vector<Piece> found;
  std::size_t position = 0;
  while (true) {
    const auto open = text.find('`', position);
    const auto close = open == std::string::npos ? open : text.find('`', open + 1);
    if (close == std::string::npos) break;
    found.push_back({text.substr(position, open - position), false});
    found.push_back({text.substr(open + 1, close - open - 1), true});
    position = close + 1;
  }
  found.push_back({text.substr(position), false});
  return found;
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  }
  return text;
}

std::string backslashed(const std::string& text, std::string_view special) {
  std::string escaped;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

// Escapes HTML tags as entities, since some Markdown readers ignore a backslash before them.
std::string markdown_escaped(const std::string& text) {
  std::string escaped = backslashed(text, R"(\`*_[]#|~$)");
  boost::replace_all(escaped, "&", "&amp;");
  boost::replace_all(escaped, "<", "&lt;");
  boost::replace_all(escaped, ">", "&gt;");
  return escaped;
}

// Markdown has no escapes inside code: code that would need them is written as text, except "|",
// which would end a table's cell.
std::string markdown_code(const std::string& code) {
  if (code.empty() || code.find_first_of("<>&\\") != std::string::npos)
    return markdown_escaped("`" + code + "`");
  return fmt::format("`{}`", backslashed(code, "|"));
}

// Allows a line break after each underscore, so that a long name does not widen a table's column.
std::string breakable(const std::string& html) {
  return boost::replace_all_copy(html, "_", "_<wbr>");
}

}  // namespace

std::string html_text(const std::string& text) {
  std::string html;
  for (const auto& [part, is_code] : pieces(text)) {
    const std::string escaped = kainjow::mustache::html_escape(part);
    html += is_code ? fmt::format("<code>{}</code>", escaped) : breakable(escaped);
  }
  return html;
}

std::string markdown_text(const std::string& text) {
  // These characters start a list only at the start of a line.
  static const std::regex list_number(R"(^(\d+)([.)]\s))");
  std::string markdown;
  for (const auto& [part, is_code] : pieces(one_line(text))) {
    markdown += is_code ? markdown_code(part) : markdown_escaped(part);
  }
  if (!markdown.empty() && (markdown[0] == '-' || markdown[0] == '+'))
    markdown = fmt::format("\\{}", markdown);
  return std::regex_replace(markdown, list_number, "$1\\$2");
}

CellVerdict cell_verdict(const std::string& cell) {
  static const std::set<std::string> good{"pass", "passed", "confirmed", "validated",
                                          "limits kept"};
  static const std::set<std::string> bad{"fail",          "failed",       "violated", "refuted",
                                         "solver failed", "not compared", "no result"};
  static const std::set<std::string> neutral{"not selected",  "not supplied",
                                             "not decidable", "out of range",
                                             "skipped",       "watched, not validated"};
  const std::string word = boost::to_lower_copy(boost::trim_copy(cell.substr(0, cell.find(": "))));
  if (good.contains(word)) return CellVerdict::good;
  if (bad.contains(word)) return CellVerdict::bad;
  if (word == "inconclusive") return CellVerdict::unsure;
  return neutral.contains(word) ? CellVerdict::neutral : CellVerdict::none;
}

// Both in the order of the enumeration.
std::string verdict_sign(CellVerdict verdict) {
  static constexpr const char* signs[]{"", "✓", "✗", "?", "–"};
  return signs[static_cast<std::size_t>(verdict)];
}

OutcomeSign outcome_sign(Outcome outcome) {
  static const OutcomeSign signs[]{{"✓", "Pass"},
                                   {"–", "Watched, not validated"},
                                   {"?", "Inconclusive"},
                                   {"✗", "Not compared"},
                                   {"✗", "Fail"}};
  return signs[static_cast<std::size_t>(outcome)];
}

bool is_numeric(const std::string& cell) {
  // -1.25e-3, +3.1 %, 12 ± 0.4 mm, -, nan: a number first, then at most a short unit or an
  // uncertainty.
  static const std::regex number(
      R"(\s*(?:[-+<>≤≥~±−]|<=|>=)*\s*\d[\d.,]*(?:e[-+]?\d+)?(?:\s*(?:±|\+/-)\s*[\d.,]+(?:e[-+]?\d+)?)?\s*\S{0,6}\s*|\s*[-–—]\s*|\s*nan\s*|\s*)",
      std::regex::icase);
  return cell.size() < 64 && std::regex_match(cell, number);
}

}  // namespace slosh::reports
