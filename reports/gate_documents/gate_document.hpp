// A gate's outcome as plain data, and its documents: JUnit XML for continuous integration, Markdown
// for a pull request, SARIF for annotations of the changed files, CSV for spreadsheets.
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
  std::string message;  // the finding, or why there is none
  std::string unit;
  double value = 0, uncertainty = 0;   // 95 %, in the unit; NaN where there is none
  std::optional<double> lower, upper;  // the tolerance, in the unit
  std::string moved;                   // since the baseline; empty without one
  std::string kind = {};               // "validation" or "regression"
  std::string uncertainties = {};      // "u_num 1 %, u_input 0 %, u_reference unknown"
  bool loosened = false;               // the tolerance, against the baseline's
  std::string file;                    // of the row, relative to its repository where that is known
  int line = 0;
};

struct GateDocument {
  std::string title, verdict;
  std::string tool_version;
  std::vector<GateEntry> entries;
  std::string basis = {};  // what the rows are based on; may be empty
};

// Returns the entries sorted by severity: solver failed, violated, not compared, inconclusive,
// loosened tolerances, the rest. Entries of equal severity keep their order.
std::vector<const GateEntry*> worst_first(const GateDocument& document);

// Returns JUnit XML: testsuites / testsuite (a group) / testcase, with value, uncertainty and
// tolerance as properties. Violated and inconclusive rows are failures; rows that were not compared
// or whose solver failed are errors.
std::string junit_xml(const GateDocument& document);

// Returns a table, worst first, of all rows except those that pass unchanged, which are counted.
std::string gate_markdown(const GateDocument& document);

// Returns SARIF 2.1.0: an error for each row that is violated, was not compared, or whose solver
// failed, and a warning for each row that is inconclusive or has a loosened tolerance. Each result
// is located at the row in its case file.
std::string gate_sarif(const GateDocument& document);

// Returns all rows in the given order as comma-separated values under a header line. Numbers are in
// the row's unit, and empty where they are NaN.
std::string gate_csv(const GateDocument& document);

}  // namespace slosh::reports
