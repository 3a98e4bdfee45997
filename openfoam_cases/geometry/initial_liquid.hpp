// Where the liquid stands at the start: level from wall to wall, under a wave, or as a column at
// the left wall. Cells on its edges hold their exact share of it, so that its volume is exact.
#pragma once

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

// How much of a cell's rectangle the liquid covers, 0 to 1; an obstacle's cells count like others.
double liquid_share(const SloshingTank& tank, Cell cell);

// Per metre of width [m2], what obstacles displace left out.
double initial_volume(const SloshingTank& tank, const TankMesh& mesh);

// The liquid's depth in a column of cells [m], what obstacles displace left out.
double initial_depth(const SloshingTank& tank, const TankMesh& mesh, int column);

}  // namespace slosh::openfoam
