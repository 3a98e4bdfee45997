// The gate: rows of a case against comparisons, and the exit status that they amount to.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "verification/case_file/case_definition.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

// The tool's exit statuses; the README lists them.
enum ExitStatus {
  exit_pass = 0,
  exit_violated = 1,
  exit_usage = 2,
  exit_solver_failed = 3,
  exit_not_compared = 4,
  exit_interrupted = 130
};

enum class RunState {
  finished,
  failed,        // the solver failed: message says how
  missing,       // no result to use: message says why
  not_selected,  // not part of this campaign's form (--quick)
  not_supplied,  // a record that its user does not have: message says where to get it
  out_of_range   // a reference outside its declared range: drawn, never gates
};

struct RunStatus {
  RunState state;
  std::string message;
};

enum class Verdict { pass, violated, solver_failed, not_compared, not_selected, not_supplied };

struct GateOutcome {
  GateRow row;
  Verdict verdict;
  Estimate value{};     // the metric, NaN where there is none
  std::string message;  // "0.8 % <= 1.5 %", or why nothing could be compared
};

// Gives the comparison of two runs for a quantity; throws ComparisonError or ResultError where
// there is none.
using FindComparison = std::function<const Comparison&(
    const std::string& candidate, const std::string& reference, const std::string& quantity)>;

// Gives a run's own series over the case's window, checked as cut_to_window() does: finite, and as
// long as the window; throws ComparisonError or ResultError where there is none.
using FindSeries = std::function<TimeSeries(const std::string& run, const std::string& quantity)>;

// Gives the row's impact_metric() of a run; throws as that does, and ResultError where the run has
// no such series.
using MeasureImpacts = std::function<double(const std::string& run, const GateRow& row)>;

// What rows are judged by.
struct GateEvidence {
  FindComparison comparison;
  FindSeries series;  // for the metrics that need no reference
  MeasureImpacts impacts = {};
};

// NaN never passes: every limit is tested as !(|value| <= limit). An impact that does not come is
// NaN, and violates; a row whose table of repeats is not supplied is not supplied.
GateOutcome evaluate(const GateRow& row, const std::map<std::string, RunStatus>& runs,
                     const GateEvidence& evidence);

// The worst of all: solver failed (3) over violated (1) over not compared (4); no row evaluated at
// all is 4. A row that is not selected or not supplied counts for nothing.
int exit_status(const std::vector<GateOutcome>& outcomes);
int exit_status_of(const std::vector<Verdict>& verdicts);

// "pass", "violated", "solver failed", "not compared", "not selected", "not supplied"
std::string verdict_name(Verdict verdict);
// "finished", "solver failed", "no result", "not selected", "not supplied", "out of range"
std::string state_name(RunState state);
std::string metric_name(Metric metric);  // as in the case file
std::string metric_unit(Metric metric, const std::string& quantity_unit);

}  // namespace slosh
