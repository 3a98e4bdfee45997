// The gate: rows of a case against comparisons, and the exit status that they amount to.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/convergence/work_precision.hpp"
#include "verification/gate/three_way_verdict.hpp"
#include "verification/metrics/comparison.hpp"
#include "verification/results/run_failure.hpp"

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

struct ExitMeaning {
  int status;
  const char* meaning;
};

// The one list of them: --help ends with it, and a test holds the table of docs/commands.md to it.
inline constexpr ExitMeaning exit_meanings[] = {
    {exit_pass, "all gate rows hold"},
    {exit_violated, "a tolerance is violated"},
    {exit_usage, "usage or case-file error; a required package is missing, with --pdf chromium"},
    {exit_solver_failed, "a solver failed"},
    {exit_not_compared,
     "a reference is missing or out of its range, a result is unusable, or nothing was compared"},
    {exit_inconclusive,
     "a row is inconclusive: the uncertainty of its metric reaches across its tolerance "
     "(--inconclusive-exit N changes this status)"},
    {exit_build_failed, "the build failed"},
    {exit_interrupted, "interrupted"}};

// The word that a headline begins with: "PASS", "FAIL" (a tolerance is violated or a solver
// failed), "NOT COMPARED", "INCONCLUSIVE". Throws std::logic_error for a status that no verdict
// has.
std::string headline_word(int status);

enum class RunState {
  finished,
  failed,        // the solver failed: message says how
  missing,       // no result to use: message says why
  not_selected,  // left out by the user (--quick, --only, --tag)
  not_supplied,  // a record that its user does not have: message says where to get it
  out_of_range   // a reference outside its declared range: drawn, never gates
};

struct RunStatus {
  RunState state;
  std::string message;
  std::optional<RunFailure> failure = {};  // of a run that failed
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

// Whether the row was measured against its bound.
inline bool is_judged(Verdict verdict) {
  return verdict == Verdict::pass || verdict == Verdict::violated ||
         verdict == Verdict::inconclusive;
}

struct GateOutcome {
  GateRow row;
  Verdict verdict;
  Estimate value{};  // the metric, NaN where there is none
  // "0.8 % <= 1.5 %", of a regression row with " (regression)", or why nothing could be compared
  std::string message;
  // What the verdict on a limit or a range rests on; none of other rows.
  std::optional<ThreeWayOutcome> judgement = {};
};

// Gives the comparison of two runs for a quantity; throws ComparisonError or ResultError where
// there is none.
using FindComparison = std::function<const Comparison&(
    const std::string& candidate, const std::string& reference, const std::string& quantity)>;

// Gives a run's own series over the case's window, checked as cut_to_window() does: finite, and as
// long as the window; throws ComparisonError or ResultError where there is none.
using FindSeries = std::function<TimeSeries(const std::string& run, const std::string& quantity)>;
// Gives the whole of that series, as the run recorded it; throws likewise.
using FindHistory = std::function<TimeSeries(const std::string& run, const std::string& quantity)>;

// Gives the row's impact_metric() of a run; throws as that does, and ResultError where the run has
// no such series.
using MeasureImpacts = std::function<double(const std::string& run, const GateRow& row)>;

// Something that a row needs is not part of this form of the campaign: what() says what.
struct NotSelectedError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Gives what the row's error costs the candidate's family [s of one core], with the costs' interval
// behind cost_spread. Throws ComparisonError where a run that it rests on was not timed on a core
// of its own, twice or more, ResultError and ComparisonError where the candidate cannot be
// compared, and NotSelectedError where runs that are left out could have reached it.
using MeasureCost = std::function<CostAtError(const GateRow& row)>;

// Gives what makes a row's metric uncertain beside its own interval, which is added to its
// `statistics`.
using FindUncertainty = std::function<UncertaintyContributions(const GateRow& row)>;

// What a run that a row names stands for: itself, or the ensemble whose first member it is.
struct EnsembleOfRun {
  std::vector<std::string> members;
  bool exact = false;  // theory or a record: no disturbance decides it
};
using FindEnsemble = std::function<EnsembleOfRun(const std::string& run)>;

// What rows are judged by.
struct GateEvidence {
  FindComparison comparison;
  FindSeries series;  // for the metrics that need no reference
  MeasureImpacts impacts = {};
  FindUncertainty uncertainty = {};  // none: of nothing else
  MeasureCost cost = {};
  FindEnsemble ensemble = {};  // none: each run stands for itself
  FindHistory history = {};    // for the metric that looks at the start
};

// Of a row with a limit or a range, what its metric may be, in the row's unit.
AllowedRange allowed_by(const GateRow& row);

// A validation row of which the candidate's numerical uncertainty or the reference's is unknown
// does not pass: it is inconclusive, and its message names what is missing. A regression row may.
// A limit or a range passes where the whole 95 % interval about the metric lies within it, is
// violated where all of it lies outside, and is inconclusive otherwise; an improvement on another
// run, likewise, where the intervals leave open which is the better. NaN never passes. An impact
// that does not come and an error that is not reached are NaN, and violate; a row whose table of
// repeats is not supplied is not supplied.
GateOutcome evaluate(const GateRow& row, const std::map<std::string, RunStatus>& runs,
                     const GateEvidence& evidence);

// The worst of all: solver failed (3) over violated (1) over not compared (4) over inconclusive
// (5); no row evaluated at all is 4. A row that is not selected or not supplied counts for nothing.
int exit_status(const std::vector<GateOutcome>& outcomes);
int exit_status_of(const std::vector<Verdict>& verdicts);

// "pass", "violated", "inconclusive", "solver failed", "not compared", "not selected", "not
// supplied"
std::string verdict_name(Verdict verdict);
// "finished", "solver failed", "no result", "not selected", "not supplied", "out of range"
std::string state_name(RunState state);
// "amplitude_error", and of a cost the error too: "cost_to_reach 10 %"
std::string measured_name(const GateRow& row);
// "CANDIDATE against REFERENCE, MODE METRIC of QUANTITY", and ", below that of RUN" of a row that
// is to improve on a run
std::string row_name(const GateRow& row);
// "not reached (5.7 % at 85 s)": the smallest error that there is and its cost [unit]
std::string not_reached_text(const CostAtError& found, const std::string& unit);
// "1.5 %" of a share, whose unit is "1"; "0.034 Pa" of anything else
std::string in_unit(double value, const std::string& unit);

}  // namespace slosh
