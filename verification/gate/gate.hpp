// The gate judges the rows of a case and turns their verdicts into an exit status.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/gate/gate_evidence.hpp"
#include "verification/gate/three_way_verdict.hpp"
#include "verification/results/run_failure.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// The exit statuses of the tool and its launcher.
enum ExitStatus {
  exit_pass = 0,
  exit_violated = 1,
  exit_usage = 2,
  exit_solver_failed = 3,
  exit_not_compared = 4,
  exit_inconclusive = 5,
  exit_build_failed = 70,  // the launcher's
  exit_interrupted = 130
};

// Of --inconclusive-exit; shells give larger ones a meaning of their own.
inline constexpr int largest_exit = 125;

struct ExitMeaning {
  int status;
  const char* meaning;
};

// --help ends with this list, and a test holds the table of docs/commands.md to it.
inline constexpr ExitMeaning exit_meanings[] = {
    {exit_pass, "all gate rows hold"},
    {exit_violated, "a tolerance is violated"},
    {exit_usage, "usage or case-file error; a required package is missing"},
    {exit_solver_failed, "a solver failed"},
    {exit_not_compared,
     "a reference is missing or out of its range, a result is unusable, or nothing was compared"},
    {exit_inconclusive,
     "a row is inconclusive: the uncertainty of its metric reaches across its tolerance "
     "(--inconclusive-exit N changes this status); or the gate has lost a row of validation that "
     "its baseline has"},
    {exit_build_failed, "the build failed"},
    {exit_interrupted, "interrupted"}};

// The first word of a headline: "PASS", "FAIL" (a tolerance is violated or a solver failed), "NOT
// COMPARED", "INCONCLUSIVE". Throws std::logic_error for a status that no verdict has.
std::string headline_word(int status);

enum class RunState {
  finished,
  failed,        // the solver failed; the message says how
  missing,       // there is no usable result; the message says why
  not_selected,  // the user left the run out (--quick, --only, --tag)
  not_supplied,  // the user does not have this record; the message says where to get it
  out_of_range   // a reference outside its declared range: it is drawn and never gates
};

struct RunStatus {
  RunState state;
  std::string message;
  std::optional<RunFailure> failure = {};  // of a failed run
};

enum class Verdict {
  pass,
  violated,
  inconclusive,  // the uncertainty reaches across the bound (three_way_verdict.hpp)
  solver_failed,
  not_compared,
  not_selected,
  not_supplied
};

// Whether the verdict comes from the row's bound.
inline bool is_judged(Verdict verdict) {
  return verdict == Verdict::pass || verdict == Verdict::violated ||
         verdict == Verdict::inconclusive;
}

struct GateOutcome {
  GateRow row;
  Verdict verdict;
  Estimate value{};  // the metric; NaN where it was not measured
  // "0.8 % ≤ 1.5 %", followed by what the reference's samples do not tell of the candidate, for
  // which a row other than a regression does not pass but is inconclusive, and by " (regression)"
  // for a regression row; or why nothing could be compared.
  std::string message;
  // What the verdict on a limit or a range rests on; empty for other rows.
  std::optional<ThreeWayOutcome> judgement = {};
  // The runs that the verdict and its interval were measured with.
  std::set<std::string> measured_with = {};
  // The part of the message that a reader must know of a row that passes too, "; doubtful: ..."
  // and "; LARGER outside of that time: ...".
  std::string remarks = {};
  bool is_doubtful = false;  // the remarks say so of what it was measured with
};

// The range in which the metric of a row with a limit or a range must lie, in the row's unit. A
// p-value cannot exceed 1, so that an upper bound of 1 is infinite: no interval reaches across it.
AllowedRange allowed_by(const GateRow& row);

// "14 ± 4 %": the value of the row's metric with the half width on which the verdict rests. Of a
// p-value below its half width "at most 0.04 %".
std::string value_text(const GateRow& row, const Estimate& value);

// The range that the case's first row with a limit or a range on this metric allows, for the
// compared runs, their quantity and the mode, in the row's unit. Returns nullopt where the case has
// no such row.
std::optional<AllowedRange> tolerance_of(const CaseDefinition& definition,
                                         const Comparison& comparison, const std::string& mode,
                                         Metric metric);

// The verdict, and the message about `subject`, on all rows that need a run or a problem in this
// state. Returns nullopt where it has finished.
std::optional<std::pair<Verdict, std::string>> obstacle_of(const std::string& subject,
                                                           const RunStatus& status);

// A limit or a range passes where the whole 95 % interval about the metric lies within it, is
// violated where all of it lies outside, and is inconclusive otherwise. An improvement on another
// run is inconclusive where the intervals, which hold the numerical uncertainty of each, do not
// tell which run is better, and where the reference and the inputs may be off by as much as makes
// both runs as good. A validation row with unknown numerical uncertainty of its candidate or
// unknown uncertainty of its reference is inconclusive instead of passing, and its message names
// what is missing; a regression row may still pass. NaN never passes: an impact that does not occur
// and an error that is not reached are NaN and violate their rows. A row is not supplied where its
// table of repeats is not supplied.
GateOutcome evaluate(const GateRow& row, const std::map<std::string, RunStatus>& runs,
                     const GateEvidence& evidence);

// The worst outcome decides: solver failed (3), violated (1), not compared (4), inconclusive (5),
// in this order. The status is 4 where no row was evaluated. Rows that are not selected or not
// supplied do not count.
int exit_status(const std::vector<GateOutcome>& outcomes);
int exit_status_of(const std::vector<Verdict>& verdicts);

// "pass", "violated", "inconclusive", "solver failed", "not compared", "not selected", "not
// supplied"
std::string verdict_name(Verdict verdict);
// "finished", "solver failed", "no result", "not selected", "not supplied", "out of range"
std::string state_name(RunState state);
// "amplitude_error"; a cost also names its error: "cost_to_reach 10 %", and a metric of a part of
// the window that part: "outside_band from 0.43 to 0.5 s"
std::string measured_name(const GateRow& row);
// "CANDIDATE against REFERENCE, MODE METRIC of QUANTITY", followed by ", below that of RUN" for a
// row that demands an improvement on a run
std::string row_name(const GateRow& row);
// "1.5 %" for the unit "1"; "0.034 Pa" for any other
std::string in_unit(double value, const std::string& unit);

// "0.012 ± 0.003 m", "1.2 ± 0.3 %" for the unit "1"; the value alone where the estimate has no
// interval (interval_text.hpp).
std::string with_interval(const Estimate& estimate, const std::string& unit);

}  // namespace slosh
