#include "openfoam_cases/geometry/front_position.hpp"

#include <algorithm>
#include <cassert>

namespace slosh::openfoam {

std::vector<int> bottom_columns(const TankMesh& mesh) {
  std::vector<int> columns;
  for (int column = 0; column < mesh.columns(); ++column) {
    if (mesh.is_free({column, 0})) columns.push_back(column);
  }
  return columns;
}

double front_position(const TankMesh& mesh, const std::vector<double>& fractions) {
  const std::vector<int> columns = bottom_columns(mesh);
  assert(fractions.size() == columns.size());
  for (std::size_t i = columns.size(); i-- > 0;) {
    const double share = fractions[i];
    if (!(share >= 0.5)) continue;
    const bool before_wall = i + 1 == columns.size() || columns[i + 1] != columns[i] + 1;
    const double in_cell =
        before_wall ? std::min(share, 1.0) : 0.5 + (share - 0.5) / (share - fractions[i + 1]);
    return (columns[i] + in_cell) * mesh.cell_width();
  }
  return 0;
}

}  // namespace slosh::openfoam
