// A gate's outcome as plain data, and its documents: JUnit XML for continuous integration, Markdown
// for a pull request.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/gate/gate.hpp"

namespace slosh::reports {

struct GateEntry {
  Verdict verdict;      // rows that are not selected or not supplied are skipped
  std::string group;    // the case
  std::string name;     // of a row, or "run NAME"; unique in its group
  std::string message;  // the finding, or why there is none
  std::string unit;
  double value = 0, uncertainty = 0;   // 95 %, in the unit; NaN where there is none
  std::optional<double> lower, upper;  // the tolerance, in the unit
  std::string moved;                   // since the baseline; empty without one
  std::string kind = {};               // "validation" or "regression"
  std::string uncertainties = {};      // "u_num 1 %, u_input 0 %, u_reference unknown"
  bool loosened = false;               // the tolerance, against the baseline's
  bool lost = false;                   // of validation in the baseline, and not in the campaign
  std::string file;                    // of the row, relative to its repository where that is known
  int line = 0;
  std::string remarks = {};  // what the message says that a reader must know of a row that passes
};

struct GateDocument {
  std::string title, verdict;
  std::vector<GateEntry> entries;
  Table standings = {};    // a line for each case; may be without a row
  std::string basis = {};  // how many rows hold and what they are based on; may be empty
  std::string speed = {};  // of the codes at equal error; may be empty
  int exit_status = 0;     // that of the process
  // Whether inconclusive rows leave the exit status at 0: JUnit then calls them skipped.
  bool inconclusive_passes = false;
  // By group: what a reader must know beside its verdicts, "doubtful: CASE: ...".
  std::map<std::string, std::vector<std::string>> doubts = {};
};

// Returns the entries sorted by severity: solver failed, violated, not compared, inconclusive or
// lost, loosened tolerances, the rest. Entries of equal severity keep their order.
std::vector<const GateEntry*> worst_first(const GateDocument& document);

// Returns JUnit XML: testsuites / testsuite (a group) / testcase, with value, uncertainty and
// tolerance as properties, and a group's doubts as properties of its suite. Violated, inconclusive
// and lost rows are failures; rows that were not compared or whose solver failed are errors. It
// ends as gate_markdown() does.
std::string junit_xml(const GateDocument& document);

// Returns the verdict, the table of the cases, and a table, worst first, of all rows except those
// that pass unchanged and those that are skipped, which are counted. It ends with a comment that
// holds the exit status.
std::string gate_markdown(const GateDocument& document);

// The comment at the end of both, and the exit status in it; nullopt for another text.
std::string status_comment(const GateDocument& document);
std::optional<int> exit_status_in(const std::string& text);

}  // namespace slosh::reports
