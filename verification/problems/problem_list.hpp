// The list of all problems.
#pragma once

#include <string>
#include <vector>

#include "verification/case/campaign_definition.hpp"
#include "verification/problems/problem.hpp"

namespace slosh {

// Returns all problems in the order of the report.
const std::vector<Problem>& all_problems();

// Throws std::invalid_argument with the nearest name where no problem has the name.
const Problem& find_problem(const std::string& name);

// Returns the problems' names and measures, for the reader of campaign files.
std::vector<KnownProblem> known_problems();

// Each problem, with its statement and measures.
Problem taylor_green_problem();
Problem oscillating_drop_problem();
Problem rigid_rotation_problem();
Problem courant_map_problem();
Problem viscosity_map_problem();
Problem gamma_map_problem();
Problem diffusion_map_problem();
Problem lattice_buckling_problem();
Problem lattice_resistance_problem();
Problem interval_coverage_problem();

}  // namespace slosh
