// The expected cost of a run: the measured cost of an earlier run with the same key, or else that
// of the last run of its kind in the store, scaled by elements times steps, or else nothing.
#pragma once

#include <optional>
#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/results/result_file.hpp"
#include "verification/results/result_store.hpp"

namespace slosh {

// All numbers are 0 where nothing is known.
struct ExpectedCost {
  double processor_time = 0;  // [s], of all its processes
  double wall_time = 0;       // [s]
  double memory = 0;          // [byte], peak
  int cores = 1;
  bool measured = false;                 // by an earlier run with the same key
  std::optional<double> own_limit = {};  // [s] of wall time, where the case limits the run

  bool known() const { return processor_time > 0; }
};

// `key` is the run's (run_key.hpp).
ExpectedCost expected_cost(const CaseDefinition& definition, const RunDefinition& run,
                           const std::string& key, const ResultStore& store);

// Adds the run's cost to the store's costs.txt for runs of its kind (work_family() of
// solver_kinds.hpp), unless the run ended before its time or is an external program's. No error is
// raised where it cannot be written: the run itself has succeeded.
void record_cost(const RunResult& result, const CaseDefinition& definition,
                 const RunDefinition& run, const ResultStore& store);

// "1.4 core-seconds measured", "about 1.4 core-seconds, scaled from another run".
std::string cost_text(const ExpectedCost& cost);

// Returns the wall time [s] beyond which a run is taken to hang.
double time_limit(const ExpectedCost& cost);

}  // namespace slosh
