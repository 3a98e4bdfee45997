// What a run is expected to take: what one that asked the same took, or else a rule of thumb.
#pragma once

#include <string>

#include "verification/case_file/case_definition.hpp"
#include "verification/engine/result_store.hpp"

namespace slosh {

struct ExpectedCost {
  double processor_time;  // [s], of all its processes
  double wall_time;       // [s]
  double memory;          // [byte], peak
  int cores = 1;
  bool measured = false;  // by an earlier run
};

// `key` is the run's (run_key.hpp).
ExpectedCost expected_cost(const CaseDefinition& definition, const RunDefinition& run,
                           const std::string& key, const ResultStore& store);

// [s]: beyond it a run hangs.
double time_limit(const ExpectedCost& cost);

}  // namespace slosh
