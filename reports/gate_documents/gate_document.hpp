// A gate's outcome as plain data, for the machines and people that decide on a change: JUnit for
// continuous integration, Markdown for a pull request, SARIF for the view of the changed files.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace slosh::reports {

enum class GateOutcomeKind { pass, inconclusive, violated, not_compared, solver_failed, skipped };

// "solver failed", "violated", "not compared", "inconclusive", "pass", "skipped"
std::string outcome_word(GateOutcomeKind outcome);

struct GateEntry {
  GateOutcomeKind outcome;
  std::string group;    // the case
  std::string name;     // unique in its group
  std::string message;  // what was found, or why nothing was
  std::string unit;
  double value = 0, uncertainty = 0;   // 95 %, in the unit; NaN where there is none
  std::optional<double> lower, upper;  // the tolerance, in the unit
  std::string moved;                   // since the baseline; empty without one
  std::string kind = {};               // "validation" or "regression"
  std::string uncertainties = {};      // "u_num 1 %, u_input 0 %, u_reference unknown"
  bool loosened = false;               // the tolerance, against the baseline's
  std::string file;                    // of the row, relative to the source tree where it is in it
  int line = 0;
};

struct GateDocument {
  std::string title, verdict;
  std::string tool_version;
  std::vector<GateEntry> entries;
  std::string basis = {};  // what the rows rest on; empty: nothing is told of it
};

// Worst first: solver failed, violated, not compared, inconclusive, loosened tolerances, the rest;
// in the order given where alike.
std::vector<const GateEntry*> worst_first(const GateDocument& document);

// testsuites / testsuite (a group) / testcase, with value, uncertainty and tolerance as properties;
// failure, error and skipped apart: violated and inconclusive rows are failures of these types,
// rows that were not compared or whose solver failed are errors of these types.
std::string junit_xml(const GateDocument& document);

// A table, worst first, of all that does not simply pass unmoved; the rest is counted.
std::string gate_markdown(const GateDocument& document);

// SARIF 2.1.0: a result for each row that is violated, was not compared, whose solver failed, that
// is inconclusive (warning) or has a loosened tolerance (warning), at the row's place in its case
// file.
std::string gate_sarif(const GateDocument& document);

// Every row, in the order given, as comma-separated values under a line of heads; numbers in the
// row's unit, empty where there is none.
std::string gate_csv(const GateDocument& document);

}  // namespace slosh::reports
