#include "openfoam_cases/outline/facing.hpp"

#include <cmath>
#include <set>

namespace slosh::openfoam {
namespace {

struct Facing {
  std::string side, level;
  double area_x, area_z;  // [m2 per metre], to the right and up
};

// The tank lies to the left of a face, from its begin to its end.
Facing facing_of(const CutMesh& mesh, const WallFace& face) {
  const Corner &begin = mesh.points()[face.begin], &end = mesh.points()[face.end];
  const double x = end.z - begin.z, z = begin.x - end.x, none = 1e-6 * std::hypot(x, z);
  return {x < -none  ? "left"
          : x > none ? "right"
                     : "",
          z < -none  ? "bottom"
          : z > none ? "roof"
                     : "",
          x, z};
}

}  // namespace

std::string patch_of(const CutMesh& mesh, const WallFace& face) {
  const Facing facing = facing_of(mesh, face);
  return facing.side + (facing.side.empty() || facing.level.empty() ? "" : "_") + facing.level;
}

std::vector<std::string> patches_of(const CutMesh& mesh, const std::string& wall) {
  std::set<std::string> patches;
  for (const WallFace& face : mesh.walls()) {
    const Facing facing = facing_of(mesh, face);
    if (facing.side == wall || facing.level == wall) patches.insert(patch_of(mesh, face));
  }
  return {patches.begin(), patches.end()};
}

double area_towards(const CutMesh& mesh, const std::string& wall) {
  double area = 0;
  for (const WallFace& face : mesh.walls()) {
    const Facing facing = facing_of(mesh, face);
    if (facing.side == wall) area += std::abs(facing.area_x);
    if (facing.level == wall) area += std::abs(facing.area_z);
  }
  return area;
}

}  // namespace slosh::openfoam
