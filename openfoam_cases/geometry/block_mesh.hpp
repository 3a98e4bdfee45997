// The tank's mesh in blockMesh's terms.
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
  std::string vertices;  // in lines of four
  std::vector<Hexahedron> hexahedra;
  std::string wall_faces;  // the tank's and the obstacles'
  std::string front_and_back_faces;
};

BlockMesh block_mesh(const TankMesh& mesh);

}  // namespace slosh::openfoam
