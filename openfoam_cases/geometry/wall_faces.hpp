// Which of a wall's faces a pressure gauge reads, with which weights: the mean over the gauge's
// width of the pressure that is linear between the faces' centres, and extrapolated by at most half
// a cell beside a corner or an obstacle. So a hydrostatic pressure is read without an error at any
// position and width.
#pragma once

#include <vector>

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

struct FaceShare {
  double x, z;    // the face's centre [m] from the tank's bottom left corner
  double weight;  // the weights of a gauge's faces add up to 1
};

// Throws std::invalid_argument for a gauge that reaches beyond its wall's ends, or over a part of
// the wall that an obstacle covers.
std::vector<FaceShare> face_shares(const TankMesh& mesh, const PressureGauge& gauge);

}  // namespace slosh::openfoam
