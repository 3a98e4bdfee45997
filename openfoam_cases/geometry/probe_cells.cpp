#include "openfoam_cases/geometry/probe_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "openfoam_cases/errors.hpp"

namespace slosh::openfoam {
namespace {

struct Pair {
  int first;      // of two neighbouring centres
  double second;  // the weight of the other one
};

// `at` is in cells from the wall.
Pair between_centres(double at, int cells) {
  const int first = std::clamp(static_cast<int>(std::floor(at - 0.5)), 0, cells - 2);
  return {first, at - 0.5 - first};
}

}  // namespace

std::vector<CellShare> cell_shares(const TankMesh& mesh, double x, double z) {
  const double height = mesh.rows() * mesh.cell_height();
  require(x >= 0 && x <= mesh.length(), "probe x", x,
          fmt::format("between the walls, 0 and {} m", mesh.length()));
  require(z >= 0 && z <= height, "probe z", z,
          fmt::format("between the bottom and the roof, 0 and {} m", height));
  const double across = x / mesh.cell_width(), up = z / mesh.cell_height();
  const Cell own{std::min(static_cast<int>(across), mesh.columns() - 1),
                 std::min(static_cast<int>(up), mesh.rows() - 1)};
  require(mesh.is_free(own), "probe x", x, "a place outside the obstacles");
  const Pair column = between_centres(across, mesh.columns()),
             row = between_centres(up, mesh.rows());
  std::vector<CellShare> shares;
  double sum = 0;
  for (const int i : {0, 1}) {
    for (const int j : {0, 1}) {
      const Cell cell{column.first + i, row.first + j};
      if (!mesh.is_free(cell)) continue;
      const double weight =
          (i ? column.second : 1 - column.second) * (j ? row.second : 1 - row.second);
      shares.push_back({cell, weight});
      sum += weight;
    }
  }
  if (!(sum > 0.1)) return {{own, 1}};  // only a corner of the others is free
  for (CellShare& share : shares) share.weight /= sum;
  return shares;
}

}  // namespace slosh::openfoam
