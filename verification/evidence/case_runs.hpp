// How the runs of a case ended, and what those that finished left.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/gate/gate.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

// What theory predicts with one input of the case at either end of its declared interval.
struct InputBounds {
  RunResult lower, upper;
};

struct CaseRuns {
  std::map<std::string, RunStatus> status;   // of every run that the case declares
  std::map<std::string, RunResult> results;  // of the finished ones and those out of their range
  // By run: what repeats of it took that had their core for themselves, in the order they were
  // made; none where the campaign asks for none.
  std::map<std::string, std::vector<RunCost>> timings = {};
  std::map<Input, InputBounds> input_bounds = {};  // input_uncertainty.hpp
};

bool has_series(const CaseRuns& runs, const std::string& run, const std::string& quantity);

// What judging a row on the quantity takes of a result: its name, its cost, its diagnostics, that
// series and potential flow's of fewer nodes.
RunResult judged_part(const RunResult& result, const std::string& quantity);

// That of the first record that has it; null where none is supplied.
const TimeSeries* series_of_record(const CaseDefinition& definition, const CaseRuns& runs,
                                   const std::string& quantity);

}  // namespace slosh
