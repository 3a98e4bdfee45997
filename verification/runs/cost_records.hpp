// What runs took against what the model (cost_model.hpp) had said of them, in a file of the store:
// the machine's own factor, which no model knows. A line a run, "SOLVER MODELLED TAKEN" in seconds.
#pragma once

#include <optional>
#include <string>

#include "verification/results/result_store.hpp"

namespace slosh {

struct CostRecord {
  std::string solver;      // solver_name(), run_case.hpp
  double modelled, taken;  // processor time [s]
};

// Adds it; one that cannot be written is left out, for no run fails because nobody learns of it.
void record_cost(const CostRecord& record, const ResultStore& store);

// By how much this solver's last runs took longer than the model says: the median; nothing where
// none is recorded that took long enough to tell.
std::optional<double> machine_factor(const std::string& solver, const ResultStore& store);

}  // namespace slosh
