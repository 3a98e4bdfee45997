// A case explained to its reader, in lines of at most 80 columns: what is solved, by what, what
// gates and what it costs.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/results/result_file.hpp"
#include "verification/runs/expected_cost.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/solvers/solver_runs.hpp"
#include "verification/solvers/sph_step.hpp"

namespace slosh {

// What is known of a run beyond its case file.
struct KnownRun {
  ExpectedCost cost{};
  std::optional<SphOutline> start = {};  // of an SPH run
  std::optional<SphStep> step = {};      // of an SPH run
};

// By run.
std::string explanation(const CaseDefinition& definition,
                        const std::map<std::string, KnownRun>& known);

// The row in words: what is measured, and what it must be.
std::string row_text(const GateRow& row);

}  // namespace slosh
