// Fields on graded cells as fields on uniform ones: what draws and compares fields takes cells of
// one size.
#pragma once

#include <vector>

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

// Returns a field's means over as many uniform cells as the mesh has graded ones, both row by row
// from the bottom. The sum over all cells, times their areas, stays the same.
std::vector<double> means_over_uniform_cells(const TankMesh& mesh,
                                             const std::vector<double>& field);

}  // namespace slosh::openfoam
