// A gate's outcome as plain data, for the machines and people that decide on a change: JUnit for
// continuous integration, Markdown for a pull request, SARIF for the view of the changed files.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace slosh::reports {

// failure: a tolerance is violated; error: nothing could be judged.
enum class GateOutcomeKind { pass, inconclusive, failure, error, skipped };

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

// Worst first: errors, failures, inconclusive rows, loosened tolerances, the rest; in the order
// given where alike.
std::vector<const GateEntry*> worst_first(const GateDocument& document);

// testsuites / testsuite (a group) / testcase, with value, uncertainty and tolerance as properties;
// failure, error and skipped apart. An inconclusive row is a failure of the type "inconclusive".
std::string junit_xml(const GateDocument& document);

// A table, worst first, of all that does not simply pass unmoved; the rest is counted.
std::string gate_markdown(const GateDocument& document);

// SARIF 2.1.0: a result for each row that fails, cannot be judged, is inconclusive (warning) or has
// a loosened tolerance (warning), at the row's place in its case file.
std::string gate_sarif(const GateDocument& document);

}  // namespace slosh::reports
