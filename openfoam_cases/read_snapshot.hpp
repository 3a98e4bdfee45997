// Reads the fields that a run wrote at a snapshot's time.
#pragma once

#include <filesystem>

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

// From the time directory nearest to `time` [s]: the solver meets it to a part of a time step, less
// well where samples are due beside it. Throws RunError where it is more than the largest step off,
// and for a field that is missing, of another number of cells or not
// finite.
FieldSnapshot read_snapshot(const SloshingTank& tank, const TankMesh& mesh,
                            const std::filesystem::path& case_directory, double time);

}  // namespace slosh::openfoam
