// The runs of a case: how each of them ended, and the results of those that finished.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/gate/gate.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

// The predictions with one input of the case at either bound of its declared interval, and those of
// theory between them.
struct InputBounds {
  RunResult lower, upper;
  std::vector<RunResult> between = {};
  std::string own = {};  // the run that predicts the case as it is, by the same method
};

struct CaseRuns {
  std::map<std::string, RunStatus> status;   // of every run that the case declares
  std::map<std::string, RunResult> results;  // of the finished ones and those out of their range
  // By run: the costs of its repeats on a core of their own, in the order in which they were made;
  // empty where the campaign requests no timings.
  std::map<std::string, std::vector<RunCost>> timings = {};
  std::map<Input, InputBounds> input_bounds = {};   // input_uncertainty.hpp
  std::map<Input, std::string> not_predicted = {};  // why theory does not predict an input's bounds
};

// Whether the run has a result, and the result has the series.
bool has_series(const CaseRuns& runs, const std::string& run, const std::string& quantity);

// The part of a result that rows on the quantity are judged by: its name, its cost, its
// diagnostics, the quantity's series, the edges of its band and what a theory leaves beside it.
RunResult judged_part(const RunResult& result, const std::string& quantity);

// The series of the first record that has the quantity. Returns nullptr where none is supplied.
const TimeSeries* series_of_record(const CaseDefinition& definition, const CaseRuns& runs,
                                   const std::string& quantity);

// Adds the low-pass filtered pressures to each result (filtered_pressures.hpp), whose dry gauges it
// raises to the floor: older results have neither. Returns "RUN: why"
// for each series that could not be filtered.
std::vector<std::string> complete_results(const CaseDefinition& definition, CaseRuns& runs);

// The case's window, or the part of it that a record covers. A candidate must cover it all.
TimeWindow compared_window(const CaseDefinition& definition, const std::string& reference);

}  // namespace slosh
