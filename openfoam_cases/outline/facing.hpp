// Which walls the faces of an outline make up: "left", "right", "bottom" and "roof" are the faces
// whose outward normal points that way. A face of an inclined side is part of two of them, whose
// names its patch joins: "left_bottom". It bears a horizontal force for the one and a vertical one
// for the other.
#pragma once

#include <string>
#include <vector>

#include "openfoam_cases/outline/cut_mesh.hpp"

namespace slosh::openfoam {

// Returns the name of a face's patch.
std::string patch_of(const CutMesh& mesh, const WallFace& face);

// Returns the names of the patches that a wall is made of.
std::vector<std::string> patches_of(const CutMesh& mesh, const std::string& wall);

// Returns the sum of the areas [m2 per metre] that the faces of a wall turn towards its side.
double area_towards(const CutMesh& mesh, const std::string& wall);

}  // namespace slosh::openfoam
