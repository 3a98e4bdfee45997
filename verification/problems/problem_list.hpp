// The problems, each made in the file of its name.
#pragma once

#include "verification/problems/problem.hpp"

namespace slosh {

Problem kernels_problem();
Problem manufactured_operators_problem();
Problem taylor_green_problem();
Problem oscillating_drop_problem();
Problem rigid_rotation_problem();
Problem uniform_translation_problem();
Problem wall_impulse_problem();
Problem mirror_symmetry_problem();
Problem courant_map_problem();
Problem viscosity_map_problem();
Problem gamma_map_problem();
Problem diffusion_map_problem();
Problem interval_coverage_problem();

}  // namespace slosh
