#include "openfoam_cases/gauge_columns.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace slosh::openfoam {

GaugeColumns gauge_columns(const SurgingTank& tank, double x) {
  const double column = x / tank.length * tank.cells_x - 0.5;  // in columns, from the first centre
  const int left = std::clamp(static_cast<int>(std::floor(column)), 0, tank.cells_x - 2);
  return {left, column - left};
}

std::vector<int> columns_read(const SurgingTank& tank) {
  std::set<int> columns;
  for (const Gauge& gauge : tank.gauges) {
    const int left = gauge_columns(tank, gauge.x).left;
    columns.insert({left, left + 1});
  }
  return {columns.begin(), columns.end()};
}

std::string column_name(int index) { return "column_" + std::to_string(index); }

}  // namespace slosh::openfoam
