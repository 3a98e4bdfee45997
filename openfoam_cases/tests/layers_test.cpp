#include "openfoam_cases/geometry/layers.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::layers_test {
namespace {

SloshingTank narrow_tank(int cells, std::optional<double> wall_cell = {}) {
  SloshingTank tank = still_tank();
  tank.gap = Gap{0.062, cells};
  tank.wall_cell = wall_cell;
  return tank;
}

TEST(Layers, AreOneOfAMetreInTwoDimensions) {
  const Layers layers(still_tank());
  EXPECT_FALSE(layers.is_half_gap());
  EXPECT_EQ(layers.count(), 1);
  EXPECT_EQ(layers.depth(), 1);
  EXPECT_EQ(layers.share(0), 1);
  EXPECT_EQ(layers.expansion(), 1);
  EXPECT_EQ(layers.measured_y(), 0.5);
}

TEST(Layers, FillHalfOfTheGapAndAreThinnestAtTheWall) {
  const Layers layers(narrow_tank(8));
  EXPECT_TRUE(layers.is_half_gap());
  EXPECT_DOUBLE_EQ(layers.depth(), 0.031);
  EXPECT_NEAR(layers.expansion(), 7, 1e-12);
  double sum = 0;
  for (int layer = 0; layer < layers.count(); ++layer) sum += layers.share(layer);
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_NEAR(layers.share(7) / layers.share(0), 7, 1e-12);
  EXPECT_NEAR(layers.measured_y(), 0.031 * (1 - layers.share(7) / 2), 1e-15);
}

TEST(Layers, BeginWithAGivenCellAtTheWall) {
  const Layers layers(narrow_tank(8, 0.0015));
  EXPECT_NEAR(layers.at_wall(), 0.0015, 1e-12);
  EXPECT_NEAR(layers.expansion(), std::pow(layers.share(1) / layers.share(0), 7), 1e-9);
  const Layers uniform(narrow_tank(8, 0.005));
  EXPECT_EQ(uniform.expansion(), 1);
  EXPECT_DOUBLE_EQ(uniform.at_wall(), 0.031 / 8);
}

TEST(Layers, AreRefusedWhereTheyWouldGrowTooFast) {
  const auto refused = [](const SloshingTank& tank) {
    return message_of<std::invalid_argument>([&] { check_layers(tank); });
  };
  EXPECT_EQ(refused(narrow_tank(4, 0.001)),
            "OpenFOAM tank: wall_cell = 0.001: expected at least 0.00207 m for 4 cells across "
            "0.031 m, half of the gap, as each cell is at most 2 times as thick as its neighbour");
  EXPECT_EQ(refused(narrow_tank(3)), "OpenFOAM tank: gap cells = 3: expected at least 4");
  SloshingTank flat = narrow_tank(4);
  flat.gap->breadth = 0;
  EXPECT_EQ(refused(flat), "OpenFOAM tank: gap breadth = 0: expected a positive number of m");
}

}  // namespace
}  // namespace slosh::openfoam::layers_test
