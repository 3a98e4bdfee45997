// The amount that a run computes, as far as it is known beforehand.
#pragma once

#include "verification/case/case_definition.hpp"

namespace slosh {

struct RunEffort {
  double steps = 0;              // in time; for potential flow and theory the samples
  double elements = 0;           // particles, cells, nodes or modes
  int outer_corrections = 0;     // how often a step of OpenFOAM solves its equations
  int pressure_corrections = 0;  // pressure equations in each of these solutions
};

// Violent flow shortens the steps and takes more of them; potential flow that leaves its range
// takes fewer. Both numbers are 0 for an external program, of which nothing is known, and for a
// record.
RunEffort run_effort(const CaseDefinition& definition, const RunDefinition& run);

}  // namespace slosh
