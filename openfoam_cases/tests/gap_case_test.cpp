// The time step of a case, and that of a narrow tank in three dimensions.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "openfoam_cases/output/read_snapshot.hpp"
#include "openfoam_cases/tests/small_tank.hpp"
#include "openfoam_cases/time_step.hpp"
#include "openfoam_cases/write_case.hpp"

namespace slosh::openfoam::gap_case_test {
namespace {

TEST(TimeStep, IsAHundredthOfTheFirstModesInverseFrequencyOrOfTheWavesOwn) {
  SloshingTank tank = still_tank();
  const auto omega = [&](int mode) {
    const double k = mode * std::numbers::pi / tank.length;
    return std::sqrt(tank.gravity * k * std::tanh(k * tank.fill_depth));
  };
  EXPECT_DOUBLE_EQ(max_time_step(tank), 0.01 / omega(1));
  tank.initial_wave = InitialWave{3, 0.01};
  EXPECT_DOUBLE_EQ(max_time_step(tank), 0.01 / omega(3));
}

// After n corrections the error is reduced by (d / (1 + d))^n, d = 2 nu dt (1/dx^2 + 1/dz^2).
TEST(PressureCorrections, AreTwoOfWaterAndMoreTheMoreViscousTheLiquidIs) {
  SloshingTank tank = still_tank();
  EXPECT_EQ(pressure_corrections(tank), 2);
  tank.liquid.kinematic_viscosity = 0;
  EXPECT_EQ(pressure_corrections(tank), 2);
  const double per_length = tank.cells_x / tank.length, per_height = tank.cells_z / tank.height;
  const double unit =
      1 / (2 * max_time_step(tank) * (per_length * per_length + per_height * per_height));  // d = 1
  tank.liquid.kinematic_viscosity = unit;
  EXPECT_EQ(pressure_corrections(tank), 9);  // 2^-9 < 0.002 < 2^-8
  tank.liquid.kinematic_viscosity = unit / 9;
  EXPECT_EQ(pressure_corrections(tank), 3);  // 0.1^3 < 0.002 < 0.1^2
}

// The case of a narrow tank in three dimensions, and what is read from its results.

SloshingTank narrow_tank() {
  SloshingTank tank = still_tank();
  tank.gap = Gap{0.062, 4};
  tank.no_slip = true;
  return tank;
}

TEST(GapCase, HasAWallInFrontAndAPlaneOfSymmetryInTheMiddle) {
  const TemporaryDirectory directory;
  write_case(narrow_tank(), template_directory, directory.path());
  const std::string mesh = contents(directory.path() / "system/blockMeshDict");
  EXPECT_TRUE(holds(mesh, "(1.1 0.031 0) (0 0.031 0)"));
  EXPECT_TRUE(holds(mesh, "(20 4 10) simpleGrading (1 "));
  EXPECT_TRUE(holds(mesh,
                    "type wall;\n        faces ((0 4 7 3) (1 2 6 5) (0 3 2 1) (4 5 6 7) "
                    "(0 1 5 4));"));
  EXPECT_TRUE(holds(mesh,
                    "middleOfGap\n    {\n        type symmetryPlane;\n        faces "
                    "((3 7 6 2));"));
  for (const char* field : {"U", "p_rgh", "alpha.liquid", "phi"})
    EXPECT_TRUE(
        holds(contents(directory.path() / "0" / field), "middleOfGap { type symmetryPlane;"))
        << field;
  EXPECT_FALSE(holds(mesh, "empty"));
}

TEST(GapCase, StartsWithTheSameLiquidInEachLayer) {
  const TemporaryDirectory directory;
  write_case(narrow_tank(), template_directory, directory.path());
  const std::string field = contents(directory.path() / "0/alpha.liquid");
  // Two full rows of 20 cells in four layers each, and the row of the level.
  std::string expected = "nonuniform List<scalar> 800\n(\n";
  for (int cell = 0; cell < 160; ++cell) expected += "1\n";
  EXPECT_TRUE(holds(field, expected + "0.746"));
}

TEST(GapCase, MeasuresInTheLayerBesideThePlaneOfSymmetry) {
  SloshingTank tank = narrow_tank();
  tank.pressure_gauges = {{"left", PressureGauge::Wall::left, 0.195, 0}};
  tank.probes = {{"probe", 0.3, 0.1}};
  const TemporaryDirectory directory;
  write_case(tank, template_directory, directory.path());
  const std::string control = contents(directory.path() / "system/controlDict");
  const std::string y = " " + std::to_string(TankMesh(tank).layers().measured_y()).substr(0, 6);
  EXPECT_TRUE(holds(control, "(0" + y));
  EXPECT_FALSE(holds(control, " 0.5 "));
  EXPECT_TRUE(holds(contents(directory.path() / "system/topoSetDict"), " 0.031 1.3)"));
}

TEST(GapCase, CorrectsThePressureMoreOftenTheThinnerTheLayersAre) {
  SloshingTank tank = narrow_tank();
  tank.liquid.kinematic_viscosity = 5e-5;
  const int coarse = pressure_corrections(tank);
  tank.gap->cells = 16;
  EXPECT_GT(pressure_corrections(tank), coarse);
}

// The field's values are 100 row + 10 layer + column.
TEST(GapCase, GivesTheFieldsInTheMiddleOfTheGap) {
  SloshingTank tank = narrow_tank();
  tank.cells_x = 3;
  tank.cells_z = 2;
  const TemporaryDirectory directory;
  const auto write = [&](const char* name, auto value) {
    std::filesystem::create_directories(directory.path() / "0.5");
    std::ofstream file(directory.path() / "0.5" / name);
    file << "internalField   nonuniform List<scalar>\n24\n(\n";
    for (int row = 0; row < 2; ++row)
      for (int layer = 0; layer < 4; ++layer)
        for (int column = 0; column < 3; ++column) file << value(row, layer, column) << '\n';
    file << ")\n;\n";
  };
  write("p", [](int row, int layer, int column) { return 100 * row + 10 * layer + column; });
  write("U", [](int row, int layer, int column) {
    return "(" + std::to_string(100 * row + 10 * layer + column) + " 7 -1)";
  });
  write("alpha.liquid", [](int row, int, int) { return 1 - row; });
  const TankMesh mesh(tank);
  const FieldSnapshot fields = read_snapshot(tank, mesh, directory.path(), 0.5);
  EXPECT_EQ(fields.velocity_x, (std::vector<double>{30, 31, 32, 130, 131, 132}));
  EXPECT_EQ(fields.velocity_z, std::vector<double>(6, -1));
  EXPECT_EQ(fields.liquid_share, (std::vector<double>{1, 1, 1, 0, 0, 0}));
  double gas = 101;  // its mean: that of the columns, and of the layers by their thickness
  for (int layer = 0; layer < 4; ++layer) gas += 10 * layer * mesh.layers().share(layer);
  for (int cell = 0; cell < 6; ++cell)
    EXPECT_NEAR(fields.pressure[cell], fields.velocity_x[cell] - gas, 1e-12);
  EXPECT_NEAR(fields.area[0], 1.1 * 1.3 / 6, 1e-12);
}

}  // namespace
}  // namespace slosh::openfoam::gap_case_test
