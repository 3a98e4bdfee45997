// Which columns of cells a wave gauge reads, with which weights, and which surface level their
// filling gives.
//
// In a tank with an outline a column's level is the height to which its liquid fills the column's
// cut cells, which is the level itself where that is horizontal, also over an inclined floor. It
// stands for the middle of the level's chord in the column at rest. A gauge whose column has no
// such chord, as the level at rest is below its floor or above its roof, reads that column alone.
#pragma once

#include <string>
#include <vector>

#include "openfoam_cases/geometry/tank_mesh.hpp"

namespace slosh::openfoam {

// The gauge's value is (1 - right_weight) * level[left] + right_weight * level[right]. It is linear
// between the columns' centres, and extrapolated by at most half a cell beside a wall or an
// obstacle's side. In a gap one column wide between two obstacles left equals right.
struct GaugeColumns {
  int left, right;
  double right_weight;
};

// Returns the column that contains x [m]; on the edge of two columns the right one. In a tank with
// an outline it is the nearest one that has cells.
int nearest_column(const TankMesh& mesh, double x);

// Returns the columns that a gauge at x [m] reads. A gauge on an obstacle's side reads those to the
// right of it.
GaugeColumns gauge_columns(const TankMesh& mesh, double x);

// Returns the columns that the tank's gauges read, ascending and without duplicates.
std::vector<int> columns_read(const SloshingTank& tank, const TankMesh& mesh);

// Returns the name of a column's cell zone and of the function object that averages over it.
std::string column_name(int index);

// Returns the height [m] that liquid of this depth [m] reaches when it is poured into a column,
// where obstacles below its surface raise it. With an outline the depth is the liquid's area over
// the width of a whole cell. Over a dry obstacle on the bottom the height is the
// obstacle's top; where the surface reaches an obstacle from below it is the obstacle's underside.
double surface_level(const TankMesh& mesh, int column, double depth);

}  // namespace slosh::openfoam
