// Turns the report's plain text into HTML and Markdown. Everything is escaped; text between
// `backticks` is shown as code.
#pragma once

#include <string>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

std::string html_text(const std::string& text);

// Returns one line of GitHub-flavoured Markdown for a paragraph or a table's cell.
std::string markdown_text(const std::string& text);

// The verdict on a check in a cell of a table.
enum class CellVerdict { none, good, bad, unsure, neutral };

// "pass", "confirmed" are good; "FAIL", "violated", "refuted", "solver failed", "not compared", "no
// result" are bad; "inconclusive" is unsure; "not selected", "not supplied", "not decidable", "out
// of range", "skipped" are neutral. The words stand alone or before ": ", in upper or lower case.
// Any other cell has no verdict.
CellVerdict cell_verdict(const std::string& cell);

// Returns a sign to put before the cell's text, so that the verdict does not depend on colour
// alone: "✓", "✗", "?", "–", or nothing.
std::string verdict_sign(CellVerdict verdict);

// Whether the cell is a number, with or without sign, unit or uncertainty. Such cells are aligned
// right.
bool is_numeric(const std::string& cell);

struct OutcomeSign {
  std::string sign, word;  // "✗" and "Not compared"
};
OutcomeSign outcome_sign(Outcome outcome);

}  // namespace slosh::reports
