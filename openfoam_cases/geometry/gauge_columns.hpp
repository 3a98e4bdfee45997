// Which columns of cells a wave gauge reads, with which weights, and what their filling means.
#pragma once

#include <string>
#include <vector>

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

// The gauge's value is (1 - right_weight) * level[left] + right_weight * level[right]: linear
// between the columns' centres, and extrapolated by at most half a cell beside a wall or an
// obstacle's side. Between two obstacles' sides one column wide the gauge reads that one: left is
// right.
struct GaugeColumns {
  int left, right;
  double right_weight;
};

// The column that holds x [m]; the right one on the edge of two.
int nearest_column(const TankMesh& mesh, double x);

// A gauge on an obstacle's side reads what is to the right of it.
GaugeColumns gauge_columns(const TankMesh& mesh, double x);

// Every column that the tank's gauges read, ascending, each once.
std::vector<int> columns_read(const SloshingTank& tank, const TankMesh& mesh);

// The name of a column's cell zone and of the function object that averages it.
std::string column_name(int index);

// The height [m] that liquid of this depth [m] reaches in a column when it is poured in: obstacles
// below its surface lift it. Over a dry obstacle that stands on the bottom it is the obstacle's
// top, under one that the surface meets from below the obstacle's underside.
double surface_level(const TankMesh& mesh, int column, double depth);

}  // namespace slosh::openfoam
