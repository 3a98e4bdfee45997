#include "openfoam_cases/geometry/front_position.hpp"

#include "openfoam_cases/geometry/half_full.hpp"

namespace slosh::openfoam {

std::vector<int> bottom_columns(const TankMesh& mesh) {
  std::vector<int> columns;
  for (int column = 0; column < mesh.columns(); ++column) {
    if (mesh.is_free({column, 0})) columns.push_back(column);
  }
  return columns;
}

double front_position(const TankMesh& mesh, const std::vector<double>& fractions) {
  return last_half_full(bottom_columns(mesh), fractions).value_or(0) * mesh.cell_width();
}

}  // namespace slosh::openfoam
