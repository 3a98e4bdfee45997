// The expected cost of a run: the measured cost of an earlier run with the same key, or else the
// model's (cost_model.hpp), corrected by the cost of the solver's other runs on this machine.
#pragma once

#include <optional>
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
  // An estimate may be wrong by this factor either way; 0 where nothing is known, and the times and
  // the memory are then 0 too.
  double uncertainty = 1;
  std::optional<double> own_limit = {};  // [s] of wall time, where the case limits the run
};

// `key` is the run's (run_key.hpp).
ExpectedCost expected_cost(const CaseDefinition& definition, const RunDefinition& run,
                           const std::string& key, const ResultStore& store);

// Records the run's cost for later estimates of the same solver, unless the run ended before its
// time or is an external program's.
void learn_cost(const RunResult& result, const CaseDefinition& definition, const RunDefinition& run,
                const ResultStore& store);

// "1.4 core-seconds measured", "about 1.4 core-seconds, an estimate: 0.93 to 2.1".
std::string cost_text(const ExpectedCost& cost);

// Returns the wall time [s] beyond which a run is taken to hang.
double time_limit(const ExpectedCost& cost);

}  // namespace slosh
