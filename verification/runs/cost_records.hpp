// A file of the store with the cost of each run beside the modelled one (cost_model.hpp), from
// which the machine's own factor follows. Each run has a line, "SOLVER MODELLED TAKEN" in seconds.
#pragma once

#include <optional>
#include <string>

#include "verification/results/result_store.hpp"

namespace slosh {

struct CostRecord {
  std::string solver;      // solver_name(), solver_kinds.hpp
  double modelled, taken;  // processor time [s]
};

// Adds the record. No error is raised where it cannot be written: the run itself has succeeded.
void record_cost(const CostRecord& record, const ResultStore& store);

// Returns the median ratio of the taken to the modelled time over this solver's last runs, or
// nullopt where no run that took long enough is recorded.
std::optional<double> machine_factor(const std::string& solver, const ResultStore& store);

}  // namespace slosh
