// What the gate's rows are judged by, as functions that the caller supplies: comparisons, series,
// impacts, costs, ensembles and uncertainties.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/convergence/work_precision.hpp"
#include "verification/gate/three_way_verdict.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

// Returns the comparison of two runs for a quantity. Throws ComparisonError or ResultError where
// the two cannot be compared.
using FindComparison = std::function<const Comparison&(
    const std::string& candidate, const std::string& reference, const std::string& quantity)>;

// Returns a run's series over the time that the row judges, checked as cut_to_window() does: it is
// finite and covers that time. Throws ComparisonError or ResultError where there is no such series.
using FindSeries = std::function<TimeSeries(const std::string& run, const std::string& quantity)>;
// Returns the values at which a quantity may rest, in its unit (quantities.hpp).
using FindRests = std::function<std::vector<double>(const std::string& quantity)>;
// Returns the whole of that series, as the run recorded it. Throws the same errors.
using FindHistory = std::function<TimeSeries(const std::string& run, const std::string& quantity)>;

// Returns the row's impact_metric() of a run. Throws what impact_metric() throws, and ResultError
// where the run has no such series.
using MeasureImpacts = std::function<double(const std::string& run, const GateRow& row)>;

// Returns the row's repeated_impact_metric() of an ensemble, a p-value corrected together with its
// family (holm_correction.hpp). Throws what that throws, and ResultError where a member has no such
// series.
using MeasureRepeats =
    std::function<Estimate(const std::vector<std::string>& members, const GateRow& row)>;

// Returns the row's field_metric() of its candidate against its reference. Throws what
// field_metric() throws, and ResultError where one of them has no result.
using MeasureFields = std::function<double(const GateRow& row)>;

// This form of the campaign leaves out something that a row needs; what() names it.
struct NotSelectedError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Returns the cost at which the candidate's family reaches the row's error [s of one core];
// `cost_spread` holds the interval of the costs. Throws ComparisonError where a run that it rests
// on was not timed twice or more on a core of its own, ResultError and ComparisonError where the
// candidate cannot be compared, and NotSelectedError where a run that is left out could have
// reached the error.
using MeasureCost = std::function<CostAtError(const GateRow& row)>;

// Returns the uncertainties of a row's metric beside the metric's own interval, which the gate adds
// to `time_series`.
using FindUncertainty = std::function<UncertaintyContributions(const GateRow& row)>;

// The runs that a run's name in a row stands for: the run itself, or all members of the ensemble
// whose first member it is.
struct EnsembleOfRun {
  std::vector<std::string> members;
  bool exact = false;       // theory or a record: repeats would not differ
  bool may_repeat = false;  // its table takes the key `repeats`
};
using FindEnsemble = std::function<EnsembleOfRun(const std::string& run)>;

// What a row's samples or runs leave open, for its message.
struct RowDoubts {
  std::string text;                // "; ..." for each
  bool keep_from_passing = false;  // a row other than a regression
  bool is_doubtful = false;        // the text says "doubtful" of one
};

// Returns what is doubtful of the row's runs: one that is not sound, or that may be kept though
// what it rests on has changed.
using DoubtRuns = std::function<RowDoubts(const GateRow& row)>;

struct GateEvidence {
  FindComparison comparison;
  FindSeries series;  // for the metrics of the candidate alone
  MeasureImpacts impacts = {};
  FindUncertainty uncertainty = {};  // empty: no uncertainty beside the metric's own interval
  MeasureCost cost = {};
  FindEnsemble ensemble = {};  // empty: each run stands for itself
  FindHistory history = {};    // for the metrics of the start
  MeasureFields fields = {};
  MeasureRepeats repeats = {};
  DoubtRuns doubts_of_runs = {};
  double sample_interval = 0;  // [s], of the case's series
  TimeWindow judged = {};      // the time over which the row is judged; empty: of each series all
  FindHistory readings = {};   // as `history`; of a filtered pressure those before its filter
  FindRests rests = {};        // of the candidate's quantity
};

}  // namespace slosh
