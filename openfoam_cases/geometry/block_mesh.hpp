// The tank's mesh as entries of blockMeshDict.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

struct BlockMesh {
  struct Hexahedron {
    std::string corners;
    int cells_x, cells_z;
    std::string grading_x, grading_z;  // "1" for uniform cells
  };
  std::string vertices;  // four in a line
  std::vector<Hexahedron> hexahedra;
  std::string wall_faces;  // of the tank and the obstacles
  // The same by what they belong to: "left", "right", "bottom", "roof", "obstacles", and "front"
  // where the mesh has half of a gap.
  std::map<std::string, std::string> faces_of;
  // Without friction: those in front and at the back, or the plane of symmetry of half a gap.
  std::string side_faces;
};

BlockMesh block_mesh(const TankMesh& mesh);

}  // namespace slosh::openfoam
