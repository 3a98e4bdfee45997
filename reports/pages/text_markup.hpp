// The report's plain text as HTML and as Markdown: everything escaped, `backticks` shown as code.
#pragma once

#include <string>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

std::string html_text(const std::string& text);

// One line of GitHub-flavoured Markdown, safe in a paragraph and in a table's cell.
std::string markdown_text(const std::string& text);

// What a cell of a table says about a check.
enum class CellVerdict { none, good, bad, unsure, neutral };

// "pass", "confirmed" are good; "FAIL", "violated", "refuted", "solver failed", "not compared", "no
// result" are bad; "inconclusive" is unsure; "not selected", "not supplied", "not decidable", "out
// of range", "skipped" are neutral; in any case, alone or before ": ". All else says nothing.
CellVerdict cell_verdict(const std::string& cell);

// A sign to stand before the cell's text, so that colour is not alone: "✓", "✗", "?", "–", or
// nothing.
std::string verdict_sign(CellVerdict verdict);

// Whether the cell reads as a number, with or without sign, unit or uncertainty: aligned right.
bool is_numeric(const std::string& cell);

struct OutcomeSign {
  std::string sign, word;  // "✗" and "Not compared"
};
OutcomeSign outcome_sign(Outcome outcome);

}  // namespace slosh::reports
