// The tank's mesh as entries of blockMeshDict.
#pragma once

#include <string>
#include <vector>

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

struct BlockMesh {
  struct Hexahedron {
    std::string corners;
    int cells_x, cells_z;
  };
  std::string vertices;  // four in a line
  std::vector<Hexahedron> hexahedra;
  std::string wall_faces;  // of the tank and the obstacles
  std::string front_and_back_faces;
};

BlockMesh block_mesh(const TankMesh& mesh);

}  // namespace slosh::openfoam
