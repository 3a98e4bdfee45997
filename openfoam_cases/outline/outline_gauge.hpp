// Which faces of an outline a pressure gauge reads, and with which weights: the mean over its width
// of a pressure that is linear along each edge between the faces' centres, and extrapolated by at
// most half a face beside a corner. A hydrostatic pressure is thus read without error on every edge
// that has two faces. On an edge with one face alone the pressure is linear along the outline
// around a blunt corner, by up to 25 degrees, as on a polygon that stands for a circle; between
// sharper corners it is that of the face.
#pragma once

#include <vector>

#include "openfoam_cases/geometry/face_share.hpp"
#include "openfoam_cases/outline/cut_mesh.hpp"

namespace slosh::openfoam {

// Throws std::invalid_argument for a place [m] that is not on the outline, to 1e-6 of the tank's
// size, and for a width [m] that is negative or above half the outline.
std::vector<FaceShare> outline_face_shares(const CutMesh& mesh, Corner place, double width);

}  // namespace slosh::openfoam
