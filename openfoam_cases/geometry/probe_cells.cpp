#include "openfoam_cases/geometry/probe_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "openfoam_cases/errors.hpp"

namespace slosh::openfoam {
namespace {

struct Pair {
  int first;      // of two neighbouring centres
  double second;  // the weight of the other one
};

Pair between_centres(const CellFaces& faces, double place) {
  const double at = faces.centres_to(place);
  const int first = std::clamp(static_cast<int>(std::floor(at)), 0, faces.cells() - 2);
  return {first, at - first};
}

// The cells around a probe, with the distances of their centres.
struct Around {
  std::vector<CellShare> shares;               // with the weights 1 / distance^2 of the squares
  std::vector<std::array<double, 3>> terms;    // 1 and the place relative to the probe's
  std::array<std::array<double, 3>, 3> sum{};  // of weight * term * term
};

Around cells_around(const TankMesh& mesh, Corner place, Cell own, int reach) {
  const double scale = std::min(mesh.cell_width(), mesh.cell_height());
  Around around;
  for (int row = own.row - reach; row <= own.row + reach; ++row) {
    for (int column = own.column - reach; column <= own.column + reach; ++column) {
      if (!mesh.is_free({column, row})) continue;
      const Corner centre = mesh.centre({column, row});
      const std::array<double, 3> term{1, (centre.x - place.x) / scale,
                                       (centre.z - place.z) / scale};
      // A hundredth keeps the weight finite where the probe is at a centre.
      const double weight = 1 / (term[1] * term[1] + term[2] * term[2] + 0.01);
      around.shares.push_back({{column, row}, weight});
      around.terms.push_back(term);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) around.sum[i][j] += weight * term[i] * term[j];
    }
  }
  return around;
}

// Returns the weights of the plane's value at the probe: those that minimise the sum of
// (weight * distance)^2 among all that read a linear field without error. They are the first row of
// the sum's inverse, by cofactors, times the terms. Cells in one line leave the plane undetermined;
// cells further away then count too, and if they do not help the probe reads its nearest cell.
std::vector<CellShare> plane_shares(const TankMesh& mesh, Corner place, Cell own) {
  constexpr double in_line = 1e-6;  // far above round-off, far below any plane in these meshes
  for (const int reach : {1, 2}) {
    Around around = cells_around(mesh, place, own, reach);
    const auto& s = around.sum;
    const std::array<double, 3> cofactors{s[1][1] * s[2][2] - s[1][2] * s[2][1],
                                          s[1][2] * s[2][0] - s[1][0] * s[2][2],
                                          s[1][0] * s[2][1] - s[1][1] * s[2][0]};
    const double determinant =
        s[0][0] * cofactors[0] + s[0][1] * cofactors[1] + s[0][2] * cofactors[2];
    if (!(determinant > in_line * s[0][0] * s[1][1] * s[2][2])) continue;
    for (std::size_t k = 0; k < around.shares.size(); ++k) {
      const std::array<double, 3>& term = around.terms[k];
      around.shares[k].weight *=
          (cofactors[0] + cofactors[1] * term[1] + cofactors[2] * term[2]) / determinant;
    }
    return around.shares;
  }
  const Around around = cells_around(mesh, place, own, 2);
  const auto nearest =
      std::max_element(around.shares.begin(), around.shares.end(),
                       [](const CellShare& a, const CellShare& b) { return a.weight < b.weight; });
  require(nearest != around.shares.end(), "probe x", place.x, "a place within two cells of one");
  return {{nearest->cell, 1}};
}

bool is_whole(const TankMesh& mesh, Cell cell) {
  return mesh.is_free(cell) && mesh.whole_cells(cell) == 1;
}

}  // namespace

std::vector<CellShare> cell_shares(const TankMesh& mesh, double x, double z) {
  const double height = mesh.rows() * mesh.cell_height();
  require(x >= 0 && x <= mesh.length(), "probe x", x,
          fmt::format("between the walls, 0 and {} m", mesh.length()));
  require(z >= 0 && z <= height, "probe z", z,
          fmt::format("between the bottom and the roof, 0 and {} m", height));
  const Cell own{std::min(static_cast<int>(mesh.across().cells_to(x)), mesh.columns() - 1),
                 std::min(static_cast<int>(mesh.up().cells_to(z)), mesh.rows() - 1)};
  if (mesh.cut())
    require(is_inside(mesh.cut()->outline(), {x, z}), "probe x", x,
            fmt::format("with z = {} m a place inside the tank's outline", z));
  else
    require(mesh.is_free(own), "probe x", x, "a place outside the obstacles");
  const Pair column = between_centres(mesh.across(), x), row = between_centres(mesh.up(), z);
  if (mesh.cut()) {
    bool all_whole = true;
    for (const int i : {0, 1})
      for (const int j : {0, 1})
        all_whole = all_whole && is_whole(mesh, {column.first + i, row.first + j});
    if (!all_whole) return plane_shares(mesh, {x, z}, own);
  }
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
