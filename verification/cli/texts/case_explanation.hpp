// Explains a case in lines of at most 80 columns: the flow, the solvers and their costs, and the
// gate rows.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/results/result_file.hpp"
#include "verification/runs/expected_cost.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/runs/sph_step.hpp"
#include "verification/solvers/solver_runs.hpp"

namespace slosh {

// What is known about a run beyond its case file.
struct KnownRun {
  ExpectedCost cost{};
  std::optional<SphOutline> start = {};  // of an SPH run
  std::optional<SphStep> step = {};      // of an SPH run
};

// `known` has the names of runs as keys.
std::string explanation(const CaseDefinition& definition,
                        const std::map<std::string, KnownRun>& known);

// Returns the row in words: what is measured, and what it must be.
std::string row_text(const GateRow& row);

}  // namespace slosh
