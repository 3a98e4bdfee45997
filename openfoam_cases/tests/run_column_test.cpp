// A dam break in the installed interFoam.
#include <gtest/gtest.h>

#include <array>

#include "openfoam_cases/output/harvest.hpp"
#include "openfoam_cases/tests/run_fixture.hpp"

namespace slosh::openfoam::run_column_test {
namespace {

// The column of Martin & Moyce 1952, figure 3, is 2.25 in wide and twice as high, in a tank that
// the front crosses during the run.
SloshingTank dam() {
  constexpr double width = 0.05715;
  SloshingTank tank = still_tank();
  tank.length = 6 * width;
  tank.height = 3 * width;
  tank.fill_depth = 2 * width;
  tank.column_width = width;
  tank.duration = 0.25;
  tank.gauges = {{"column", 0.5 * width}, {"dry", 4 * width}};
  tank.cells_x = 60;
  tank.cells_z = 30;
  return tank;
}

double value_at(const History& history, double time) {
  const auto after = std::lower_bound(history.time.begin(), history.time.end(), time);
  const auto i = std::max<std::ptrdiff_t>(after - history.time.begin(), 1);
  return std::lerp(history.value[i - 1], history.value[i],
                   (time - history.time[i - 1]) / (history.time[i] - history.time[i - 1]));
}

using RunColumn = RunCase;

TEST_F(RunColumn, KeepsItsVolumeFromTheFirstStepOn) {
  SloshingTank tank = dam();
  tank.column_width = 0.0591, tank.fill_depth = 0.1103;  // not on faces of cells
  tank.duration = 0.1;
  const Harvest result = run(tank);
  for (const double volume : result.liquid_volume.value) {
    EXPECT_NEAR(volume / (0.0591 * 0.1103), 1, 1e-9);
  }
}

// An ideal front moves along a dry bottom at 2 sqrt(g h) from the start (Ritter 1892). A real front
// does not, since a column must first convert its fall into speed. The experiment's front is late
// by 0.27 of its unit of time, 14 ms, at all three points, as with a diaphragm that takes time to
// open. The test therefore compares the speed, which is 4 % higher here (5 % at 120 x 60), with
// free slip on the walls.
TEST_F(RunColumn, RunsItsFrontBetweenTheExperimentsAndTheIdealOne) {
  const SloshingTank tank = dam();
  const double width = *tank.column_width;
  const Harvest result = run(tank);
  const History& front = result.front_position;
  ASSERT_EQ(front.time.size(), 26u);
  EXPECT_NEAR(front.value[0], width, 1e-15);
  for (std::size_t i = 1; i < front.time.size(); ++i) {
    EXPECT_GE(front.value[i], front.value[i - 1] - 1e-3 * width) << front.time[i];
    EXPECT_LE(front.value[i], width + 2 * std::sqrt(9.81 * tank.fill_depth) * front.time[i]);
  }
  EXPECT_NEAR(front.value.back(), tank.length, 0.01 * tank.length);
  // t sqrt(2 g / a) and x / a as PySPH (db_exp_data.py) digitised the figure.
  const std::array<std::array<double, 2>, 3> experiment{
      {{1.997, 2.292}, {2.547, 2.995}, {3.345, 4.134}}};
  std::array<double, 3> found;
  for (std::size_t i = 0; i < experiment.size(); ++i) {
    const double time = experiment[i][0] / std::sqrt(2 * tank.gravity / width);
    found[i] = value_at(front, time) / width;
    EXPECT_GT(found[i], experiment[i][1]);
    EXPECT_LT(found[i], 1.2 * experiment[i][1]);
  }
  EXPECT_NEAR((found[2] - found[0]) / (experiment[2][1] - experiment[0][1]), 1, 0.07);
  EXPECT_EQ(result.elevation.at("column").value[0], 0);
  EXPECT_LT(result.elevation.at("column").value.back(), -0.5 * tank.fill_depth);
  EXPECT_EQ(result.elevation.at("dry").value[0], -tank.fill_depth);
  EXPECT_GT(result.elevation.at("dry").value.back(), -tank.fill_depth);
}

}  // namespace
}  // namespace slosh::openfoam::run_column_test
