#include "openfoam_cases/write_case.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <regex>
#include <sstream>

#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/frame_motion.hpp"
#include "openfoam_cases/sloshing_tank.hpp"
#include "openfoam_cases/tests/motions.hpp"
#include "openfoam_cases/tests/small_tank.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::openfoam::write_case_test {
namespace {

namespace fs = std::filesystem;

// Returns the text that follows `key` in a dictionary, up to the semicolon.
std::string entry(const std::string& text, const std::string& key) {
  std::smatch match;
  return std::regex_search(text, match, std::regex("\\b" + key + "\\s+([^;]*);")) ? match[1].str()
                                                                                  : "no " + key;
}

// Returns the numbers between the outermost parentheses after `key`.
std::vector<double> list_after(std::string text, const std::string& key) {
  text = text.substr(text.find('(', text.find(key)));
  text = text.substr(0, text.find("\n)"));
  for (char& c : text) {
    if (c == '(' || c == ')') c = ' ';
  }
  std::istringstream in(text);
  return {std::istream_iterator<double>(in), {}};
}

class WrittenCase : public ::testing::Test {
 protected:
  void write(const SloshingTank& tank) { write_case(tank, template_directory, directory_.path()); }
  std::string file(const std::string& name) { return contents(directory_.path() / name); }
  TemporaryDirectory directory_;
};

TEST_F(WrittenCase, LeavesNoPlaceholderUnfilled) {
  write(small_tank());
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(directory_.path())) {
    if (!entry.is_regular_file()) continue;
    ++files;
    EXPECT_FALSE(holds(contents(entry.path()), "{{")) << entry.path();
  }
  EXPECT_EQ(files, 15);
}

TEST_F(WrittenCase, TakesItsNumbersFromTheTankToTheLastBit) {
  SloshingTank tank = small_tank();
  tank.length = 1.0 / 3;
  tank.gauges = {{"middle", tank.length / 2}};
  tank.liquid.density = std::nextafter(1000.0, 0);
  write(tank);
  EXPECT_EQ(list_after(file("system/blockMeshDict"), "vertices").at(3), tank.length);
  const std::string transport = file("constant/transportProperties");
  EXPECT_EQ(std::stod(entry(transport.substr(transport.find("\nliquid\n")), "rho")),
            tank.liquid.density);
  EXPECT_EQ(std::stod(entry(transport.substr(transport.find("\ngas\n")), "nu")),
            tank.gas.kinematic_viscosity);
  EXPECT_EQ(std::stod(entry(file("system/controlDict"), "endTime")), tank.duration);
  EXPECT_EQ(entry(file("0/U"), "internalField"), "uniform (-0.03 0 0)");
  EXPECT_EQ(entry(file("constant/g"), "value"), "(0 0 -9.81)");
}

TEST_F(WrittenCase, NamesItsProgram) {
  SloshingTank tank = small_tank();
  tank.program = Program::inter_iso_foam;
  write(tank);
  EXPECT_EQ(entry(file("system/controlDict"), "application"), "interIsoFoam");
  const TemporaryDirectory plain;
  write_case(small_tank(), template_directory, plain.path());
  EXPECT_EQ(entry(contents(plain.path() / "system/controlDict"), "application"), "interFoam");
  EXPECT_EQ(contents(plain.path() / "system/fvSolution"), file("system/fvSolution"))
      << "interIsoFoam has its own defaults";
}

TEST_F(WrittenCase, LimitsTheCourantNumberOfAllCellsAndOfTheInterface) {
  SloshingTank tank = small_tank();
  tank.courant_number = 0.4;
  tank.interface_courant_number = 0.25;
  write(tank);
  const std::string control = file("system/controlDict");
  EXPECT_EQ(entry(control, "maxCo"), "0.4");
  EXPECT_EQ(entry(control, "maxAlphaCo"), "0.25");
}

TEST_F(WrittenCase, SolvesTheEquationsOfAStepAsOftenAsAsked) {
  SloshingTank tank = small_tank();
  EXPECT_EQ(tank.outer_corrections, 1);
  tank.outer_corrections = 3;
  write(tank);
  EXPECT_EQ(entry(file("system/fvSolution"), "nOuterCorrectors"), "3");
}

TEST_F(WrittenCase, GivesCompressibleFluidsTheTanksDensitiesAtOneAtmosphere) {
  SloshingTank tank = small_tank();
  tank.program = Program::compressible_inter_foam;
  write(tank);
  const std::string liquid = file("constant/thermophysicalProperties.liquid"),
                    gas = file("constant/thermophysicalProperties.gas");
  const auto number_after = [](const std::string& text, const std::string& key) {
    return std::stod(text.substr(text.find(key + " ") + key.size()));
  };
  const double temperature = 293.15, pressure = 101325, R = number_after(liquid, "{ R");
  EXPECT_NEAR(number_after(liquid, "rho0") + pressure / (R * temperature), 998.2, 1e-9);
  EXPECT_NEAR(std::sqrt(R * temperature), 1482.3, 1e-6) << "the speed of sound";
  EXPECT_NEAR(pressure * number_after(gas, "molWeight") / (8314.47 * temperature), 1.2, 1e-12);
  EXPECT_EQ(entry(file("0/p_rgh"), "internalField"), "uniform 101325");
  EXPECT_EQ(entry(file("constant/hRef"), "value"), "0.357");
  EXPECT_FALSE(fs::exists(directory_.path() / "constant/transportProperties"));
}

TEST_F(WrittenCase, SlowsTheLiquidDownInAPorousMediumWhereTheWallsCauseFriction) {
  SloshingTank tank = small_tank();
  tank.gap_friction = 0.3;
  write(tank);
  const double d = 0.3 / tank.liquid.kinematic_viscosity;
  EXPECT_EQ(list_after(file("constant/fvOptions"), "DarcyForchheimer"), std::vector(3, d));
  EXPECT_EQ(entry(file("constant/fvOptions"), "cellZone"), "tank");
  EXPECT_TRUE(holds(file("system/topoSetDict"), "box     (0 0 0) (1.1 1 1.3);"));
}

TEST_F(WrittenCase, HasNoPorousMediumOtherwise) {
  write(small_tank());
  EXPECT_FALSE(holds(file("constant/fvOptions"), "porous"));
  EXPECT_FALSE(holds(file("system/topoSetDict"), "tank;"));
}

TEST_F(WrittenCase, StartsWithTheExactVolumeForALevelInsideACell) {
  const SloshingTank tank = small_tank();  // the level is at 2.746 cells
  write(tank);
  const std::vector<double> fractions = list_after(file("0/alpha.liquid"), "nonuniform");
  ASSERT_EQ(fractions.size(), 200u);
  const double cell = tank.length / tank.cells_x * tank.height / tank.cells_z;
  EXPECT_NEAR(cell * std::accumulate(fractions.begin(), fractions.end(), 0.0),
              tank.length * tank.fill_depth, 1e-15);
  EXPECT_EQ(fractions[39], 1);
  EXPECT_NEAR(fractions[40], 0.357 / 0.13 - 2, 1e-14);
  EXPECT_EQ(fractions[60], 0);
}

TEST_F(WrittenCase, TabulatesTheAccelerationFinelyAndPastTheEnd) {
  const SloshingTank tank = small_tank();
  write(tank);
  const std::vector<double> rows = list_after(file("constant/acceleration"), "");
  ASSERT_EQ(rows.size() % 10, 0u);
  EXPECT_EQ(std::stoul(file("constant/acceleration")), rows.size() / 10);
  for (std::size_t row = 0; row < rows.size(); row += 10) {
    EXPECT_EQ(rows[row + 1], tank.acceleration(rows[row]));
  }
  EXPECT_EQ(rows[0], 0);
  EXPECT_LE(rows[10], tank.duration / 2000);
  EXPECT_GT(rows[rows.size() - 10], tank.duration);
}

TEST_F(WrittenCase, AveragesEachColumnThatAGaugeReads) {
  write(small_tank());
  const std::string control = file("system/controlDict"), zones = file("system/topoSetDict");
  for (const char* column : {"column_0", "column_1", "column_18", "column_19"}) {
    EXPECT_TRUE(holds(control, std::string(column) + "\n"));
    EXPECT_TRUE(holds(zones, std::string(column) + ";"));
  }
  EXPECT_FALSE(holds(control, "column_2\n"));
}

// The cells are in the mesh's order: below the step's top 18 in a row, above it 2 and 18.
TEST_F(WrittenCase, NumbersTheLiquidsCellsBlockByBlock) {
  SloshingTank tank = small_tank();
  tank.gauges = {};
  tank.obstacles = {{0, 0.11, 0, 0.26}};
  write(tank);
  const std::vector<double> fractions = list_after(file("0/alpha.liquid"), "nonuniform");
  ASSERT_EQ(fractions.size(), 196u);
  const double level = 0.357 / 0.13 - 2;
  for (int cell = 0; cell < 36; ++cell) EXPECT_EQ(fractions[cell], 1);
  for (int cell = 36; cell < 38; ++cell) EXPECT_NEAR(fractions[cell], level, 1e-14);
  for (int cell = 38; cell < 52; ++cell) EXPECT_EQ(fractions[cell], 0);
  for (int cell = 52; cell < 70; ++cell) EXPECT_NEAR(fractions[cell], level, 1e-14);
}

TEST_F(WrittenCase, ProbesTheLowestRowForTheFrontOfAColumn) {
  SloshingTank tank = small_tank();
  tank.column_width = 0.4;
  tank.obstacles = {{0.55, 0.66, 0, 0.13}};
  write(tank);
  const std::vector<double> places = list_after(file("system/controlDict"), "probeLocations");
  ASSERT_EQ(places.size(), 3 * 18u);
  EXPECT_NEAR(places[3], 0.0825, 1e-15);
  EXPECT_EQ(places[4], 0.5);
  EXPECT_EQ(places[5], 0.065);
}

// The roll's axis is the origin of the mesh, and everything in the mesh shifts with it.
TEST_F(WrittenCase, PutsTheOriginOnTheRollsAxis) {
  SloshingTank tank = small_tank();
  tank.roll = harmonic_roll(0.1, 2, 0.25, -0.5);
  tank.pressure_gauges = {{"right", PressureGauge::Wall::right, 0.065, 0}};
  tank.column_width = 0.4;
  write(tank);
  const std::vector<double> vertices = list_after(file("system/blockMeshDict"), "vertices");
  EXPECT_EQ(vertices[0], -0.25);
  EXPECT_EQ(vertices[2], 0.5);
  EXPECT_NEAR(vertices[18], 1.1 - 0.25, 1e-15);
  EXPECT_NEAR(vertices[20], 1.3 + 0.5, 1e-15);
  EXPECT_TRUE(holds(file("system/fvSolution"), "pRefPoint           (0.3275"));
  EXPECT_TRUE(holds(file("system/topoSetDict"), "box     (-0.23625 0 0.5) (-0.20875 1 1.8);"));
  const std::string control = file("system/controlDict");
  const auto places = [&](const char* object) {
    return list_after(control.substr(control.find(object)), "probeLocations");
  };
  EXPECT_NEAR(places("bottom_row")[0], 0.0275 - 0.25, 1e-15);
  EXPECT_NEAR(places("bottom_row")[2], 0.065 + 0.5, 1e-15);
  EXPECT_NEAR(places("gauge_cells")[0], 0.0275 - 0.25, 1e-15);
  ASSERT_EQ(places("gauge_cells").size(), 2 * 10 * 3u);
  ASSERT_EQ(places("wall_pressure").size(), 2 * 3u);
  EXPECT_NEAR(places("wall_pressure")[0], 1.1 - 0.25, 1e-15);
  EXPECT_NEAR(places("wall_pressure")[2], 0.065 + 0.5, 1e-15);
  EXPECT_FALSE(holds(control, "liquid_momentum"));
}

TEST_F(WrittenCase, TabulatesTheRoll) {
  SloshingTank tank = small_tank();
  tank.roll = harmonic_roll(0.1, 2, 0.25, -0.5);
  write(tank);
  const std::vector<double> rows = list_after(file("constant/acceleration"), "");
  ASSERT_EQ(rows.size() % 10, 0u);
  for (std::size_t row = 0; row < rows.size(); row += 10) {
    const FrameMotion motion = frame_motion(tank, rows[row]);
    EXPECT_EQ(rows[row + 1], motion.acceleration_x);
    EXPECT_EQ(rows[row + 3], motion.acceleration_z);
    EXPECT_EQ(rows[row + 5], motion.omega_y);
    EXPECT_EQ(rows[row + 8], motion.omega_y_derivative);
    for (const int zero : {2, 4, 6, 7, 9}) EXPECT_EQ(rows[row + zero], 0);
  }
}

TEST_F(WrittenCase, StartsARollAtRestInTheEarthsFrameCellByCell) {
  SloshingTank tank = small_tank();
  tank.roll = harmonic_roll(0.1, 2, 0.25, -0.5);
  tank.roll->initial_relative_rate = -0.2;
  write(tank);
  const std::vector<double> field = list_after(file("0/U"), "nonuniform");
  ASSERT_EQ(field.size(), 200 * 3u);
  const Velocity last = initial_velocity(tank, TankMesh(tank), {19, 9});
  EXPECT_EQ(field[3 * 199], last.x);
  EXPECT_EQ(field[3 * 199 + 2], last.z);
  const std::string control = file("system/controlDict");
  EXPECT_NEAR(std::stod(entry(control, "deltaT")), 0.01 * std::stod(entry(control, "maxDeltaT")),
              1e-12);
}

TEST_F(WrittenCase, WritesTheFieldsOnceAtEachSnapshotsTime) {
  SloshingTank tank = small_tank();
  tank.snapshot_times = {0.25, 0.8};
  write(tank);
  std::string control = file("system/controlDict");
  control = control.substr(control.find("snapshot_1"));
  EXPECT_EQ(entry(control, "objects"), "(alpha.liquid U p)");
  EXPECT_EQ(std::stod(entry(control, "writeInterval")), 0.8);
  EXPECT_GT(std::stod(entry(control, "timeEnd")), 0.8);
  EXPECT_LT(std::stod(entry(control, "timeEnd")), 1.6);
}

TEST_F(WrittenCase, RefusesADirectoryWithAnEarlierRunInIt) {
  write(small_tank());
  EXPECT_TRUE(
      holds(message_of<std::invalid_argument>([this] { write(small_tank()); }), "not empty"));
}

TEST_F(WrittenCase, RefusesATemplateThatNamesWhatNothingDefines) {
  TemporaryDirectory templates;
  std::ofstream(templates.path() / "dictionary") << "length {{lenght}};\n";
  const std::string message =
      message_of<RunError>([&] { write_case(small_tank(), templates.path(), directory_.path()); });
  EXPECT_TRUE(holds(message, "lenght"));
  EXPECT_TRUE(holds(message, "dictionary"));
}

}  // namespace
}  // namespace slosh::openfoam::write_case_test
