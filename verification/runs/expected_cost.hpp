// What a run is expected to take: what one that asked the same took, or else what the model says
// (cost_model.hpp), corrected by what other runs of the solver took on this machine.
#pragma once

#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/results/result_file.hpp"
#include "verification/results/result_store.hpp"

namespace slosh {

struct ExpectedCost {
  double processor_time;  // [s], of all its processes
  double wall_time;       // [s]
  double memory;          // [byte], peak
  int cores = 1;
  bool measured = false;  // by an earlier run
  // An estimate may be wrong by this factor either way; 0 where nothing is known.
  double uncertainty = 1;
};

// `key` is the run's (run_key.hpp).
ExpectedCost expected_cost(const CaseDefinition& definition, const RunDefinition& run,
                           const std::string& key, const ResultStore& store);

// Lets the next estimates of the solver know what this run took. A run that ended before its time,
// or an external program's, tells nothing.
void learn_cost(const RunResult& result, const CaseDefinition& definition, const RunDefinition& run,
                const ResultStore& store);

// "1.4 core-seconds measured", "about 1.4 core-seconds, an estimate: 0.93 to 2.1".
std::string cost_text(const ExpectedCost& cost);

// [s]: beyond it a run hangs.
double time_limit(const ExpectedCost& cost);

}  // namespace slosh
