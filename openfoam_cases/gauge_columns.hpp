// Which columns of cells a wave gauge reads, and with which weights.
#pragma once

#include <string>
#include <vector>

#include "openfoam_cases/surging_tank.hpp"

namespace slosh::openfoam {

// The gauge's value is (1 - right_weight) * column[left] + right_weight * column[left + 1]: linear
// between the columns' centres, and extrapolated by at most half a cell beside a wall.
struct GaugeColumns {
  int left;
  double right_weight;
};

GaugeColumns gauge_columns(const SurgingTank& tank, double x);

// Every column that the tank's gauges read, ascending, each once.
std::vector<int> columns_read(const SurgingTank& tank);

// The name of a column's cell zone and of the function object that averages it.
std::string column_name(int index);

}  // namespace slosh::openfoam
