// Which of a wall's faces a pressure gauge reads, and with which weights. The gauge gives the mean
// over its width of a pressure that is linear between the faces' centres, and extrapolated by at
// most half a cell beside a corner or an obstacle. A hydrostatic pressure is thus read without
// error at any position and width. In a tank with an outline a gauge on a wall is one at that place
// of the outline (outline_gauge.hpp).
#pragma once

#include <vector>

#include "openfoam_cases/geometry/face_share.hpp"
#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

// Throws std::invalid_argument for a gauge that reaches beyond the ends of its wall or covers a
// part of the wall where an obstacle is, and for one at a place of the outline (PressureGauge::at)
// where there is no outline.
std::vector<FaceShare> face_shares(const TankMesh& mesh, const PressureGauge& gauge);

}  // namespace slosh::openfoam
