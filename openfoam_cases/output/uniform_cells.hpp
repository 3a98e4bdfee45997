// Fields on graded cells as fields on uniform ones: what draws and compares fields takes cells of
// one size.
#pragma once

#include "openfoam_cases/output/read_snapshot.hpp"

namespace slosh::openfoam {

// Replaces the snapshot's fields on the mesh's graded cells by their means over as many uniform
// cells, row by row from the bottom. A sum over all cells, times their areas, stays the same.
void take_uniform_cells(const TankMesh& mesh, FieldSnapshot& snapshot);

}  // namespace slosh::openfoam
