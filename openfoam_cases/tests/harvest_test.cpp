// Case directories as interFoam writes them, made by hand and then damaged.
#include "openfoam_cases/output/harvest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/sloshing_tank.hpp"
#include "openfoam_cases/tests/motions.hpp"
#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::harvest_test {
namespace {

namespace fs = std::filesystem;

// Two columns have different fillings, so that a wrong column or weight shows.
SloshingTank tank_with_one_gauge() {
  SloshingTank tank = small_tank();
  tank.length = 1;
  tank.height = 1;
  tank.fill_depth = 0.35;
  tank.gauges = {{"gauge", 0.95}};  // on the edge of columns 18 and 19
  return tank;
}

double left_filling(int sample) { return 0.35 + 1e-4 * sample; }
double right_filling(int sample) { return 0.35 + 3e-4 * sample; }

class Harvested : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ofstream log(directory_.path() / "log.interFoam");
    log << "Build  : OPENFOAM=1912 patch=200626\n";
    for (int step = 1; step <= 250; ++step) log << "Time = " << 0.004 * step << "\n";
    log << "End\n";
    write("column_18", "volFieldValue.dat", "# Cells             : 10\n", left_filling);
    write("column_19", "volFieldValue.dat", "# Cells             : 10\n", right_filling);
    write("liquid_volume", "volFieldValue.dat", "# Cells             : 200\n",
          [](int) { return 0.35; });
    write_vectors("wall_force", "force.dat");
    write_vectors("liquid_momentum", "volFieldValue.dat");
    write_gauge_cells(10);
  }

  fs::path series(const std::string& name, const std::string& file = "volFieldValue.dat") {
    return directory_.path() / "postProcessing" / name / "0" / file;
  }

  void write(const std::string& name, const std::string& file, const std::string& header,
             const std::function<double(int)>& value, int samples = 100) {
    fs::create_directories(series(name).parent_path());
    std::ofstream out(series(name, file));
    out.precision(12);
    out << header << "# Time              \tvolAverage(alpha.liquid)\n";
    for (int i = 1; i <= samples; ++i) out << 0.01 * i << "          \t" << value(i) << "\n";
  }

  // Rows have three vectors; the first three samples are those of an impulse.
  void write_vectors(const std::string& name, const std::string& file) {
    fs::create_directories(series(name).parent_path());
    std::ofstream out(series(name, file));
    out << "# Cells : 200\n# Time\n";
    const bool is_force = name == "wall_force";
    for (int i = 1; i <= 100; ++i) {
      const double value = is_force && i == 1 ? -1e5 : 10 * i;
      out << 0.01 * i << "\t(" << value << " " << 2 * i << " -3441)";
      if (is_force) out << "\t(" << value << " 0 -3441)\t(0 0 0)";
      out << "\n";
    }
  }

  // The gauge's column, 19, has a drop in the fourth cell from above in the 30th sample.
  void write_gauge_cells(int cells) {
    fs::create_directories(series("gauge_cells").parent_path());
    std::ofstream out(series("gauge_cells", "alpha.liquid"));
    out << "# Probe 0 (0.975 0.5 0.05)\n#       Time\n";
    for (int i = 1; i <= 100; ++i) {
      out << 0.01 * i;
      for (int cell = 0; cell < cells; ++cell) {
        const double share = std::clamp(right_filling(i) / 0.1 - cell, 0.0, 1.0);
        out << " " << (i == 30 && cell == 6 ? 0.8 : share);
      }
      out << "\n";
    }
  }

  // Returns the error with which the harvest refuses the directory as it is now.
  std::string refusal() {
    return message_of<RunError>([this] { harvest(tank_with_one_gauge(), directory_.path()); });
  }

  TemporaryDirectory directory_;
};

TEST_F(Harvested, GivesTheElevationBetweenTwoColumns) {
  const Harvest result = harvest(tank_with_one_gauge(), directory_.path());
  const History& elevation = result.elevation.at("gauge");
  ASSERT_EQ(elevation.time.size(), 101u);
  EXPECT_EQ(elevation.value[0], 0);
  for (int i = 1; i <= 100; ++i) {
    EXPECT_NEAR(elevation.time[i], 0.01 * i, 1e-12);
    EXPECT_NEAR(elevation.value[i], 2e-4 * i, 1e-12);
  }
  EXPECT_EQ(result.steps, 250);
  EXPECT_EQ(result.version, "1912");
  EXPECT_NEAR(result.relative_mass_loss, 0, 1e-12);
}

// The first three steps are at 4, 8 and 12 ms, so that one sample, at 10 ms, lies within them.
TEST_F(Harvested, DropsTheForceOfTheFirstThreeSteps) {
  const History force = harvest(tank_with_one_gauge(), directory_.path()).force_x;
  ASSERT_EQ(force.time.size(), 99u);
  EXPECT_NEAR(force.time.front(), 0.02, 1e-12);
  EXPECT_EQ(force.value.front(), 20);
  EXPECT_EQ(force.value.back(), 1000);
}

TEST_F(Harvested, GivesTheMomentumInTheEarthsFrame) {
  SloshingTank tank = tank_with_one_gauge();
  tank.velocity = [](double time) { return 3 * time; };
  const Harvest result = harvest(tank, directory_.path());
  ASSERT_EQ(result.momentum_x.time.size(), 100u);
  const double mass = tank.liquid.density * 0.35;
  EXPECT_NEAR(result.momentum_x.value[49], tank.liquid.density * 500 + mass * 1.5, 1e-6);
  EXPECT_NEAR(result.momentum_z.value[49], tank.liquid.density * -3441, 1e-6);
  EXPECT_TRUE(result.moment.time.empty());
}

// The drop's cell is 0.8 full and the next empty: the surface is 0.375 of a cell above its centre
// at 0.65 m.
TEST_F(Harvested, GivesTheHighestSurfaceFromTheStartOn) {
  const History highest =
      harvest(tank_with_one_gauge(), directory_.path()).highest_surface.at("gauge");
  ASSERT_EQ(highest.time.size(), 101u);
  EXPECT_NEAR(highest.value[0], 0, 0.009);
  EXPECT_NEAR(highest.value[30], 0.6875 - 0.35, 1e-12);
  EXPECT_NEAR(highest.value[31], 0.0093, 0.009);
}

// A tank that rolls has a moment, which is clockwise in OpenFOAM, and no momentum.
TEST_F(Harvested, GivesTheMomentOfATankThatRolls) {
  SloshingTank tank = tank_with_one_gauge();
  tank.roll = harmonic_roll(0.1, 2, 0.5, 0);
  write_vectors("wall_force", "moment.dat");
  const Harvest result = harvest(tank, directory_.path());
  ASSERT_EQ(result.moment.time.size(), 99u);
  EXPECT_EQ(result.moment.value.front(), -4);
  EXPECT_EQ(result.force_z.value.front(), -3441);
  EXPECT_TRUE(result.momentum_x.time.empty());
  EXPECT_TRUE(result.momentum_z.time.empty());
}

// Two gauges are in the middle between two faces each, and the gas's pressure varies.
class HarvestedPressure : public Harvested {
 protected:
  void SetUp() override {
    Harvested::SetUp();
    write("gas_pressure", "volFieldValue.dat", "# Cells : 200\n", gas);
    write_faces(4);
  }

  static double gas(int sample) { return sample < 50 ? 0 : 300; }

  void write_faces(int faces, int first = 1) {
    fs::create_directories(series("wall_pressure").parent_path());
    std::ofstream out(series("wall_pressure", "p"));
    for (int i = first; i <= 100; ++i) {
      out << 0.01 * i;
      for (int face = 0; face < faces; ++face) out << " " << 100 * face + i + gas(i);
      out << "\n";
    }
  }

  Harvest harvest_pressure() {
    SloshingTank tank = tank_with_one_gauge();
    tank.pressure_gauges = {{"left", PressureGauge::Wall::left, 0.2, 0},
                            {"bottom", PressureGauge::Wall::bottom, 0.5, 0}};
    return harvest(tank, directory_.path());
  }

  std::string pressure_refusal() {
    return message_of<RunError>([this] { harvest_pressure(); });
  }
};

TEST_F(HarvestedPressure, IsTheFacesMeanLessTheGass) {
  const auto pressure = harvest_pressure().wall_pressure;
  ASSERT_EQ(pressure.at("left").time.size(), 99u) << "without the first three steps";
  for (int i = 2; i <= 100; ++i) {
    EXPECT_NEAR(pressure.at("left").value[i - 2], 50 + i, 1e-9);
    EXPECT_NEAR(pressure.at("bottom").value[i - 2], 250 + i, 1e-9);
  }
}

TEST_F(HarvestedPressure, IsRefusedWithoutAFaceASampleOrTheGas) {
  write_faces(3);
  EXPECT_TRUE(holds(pressure_refusal(), "expected 5 finite numbers"));
  write_faces(4, 4);
  EXPECT_TRUE(holds(pressure_refusal(), "a sample at 0.04 s follows one at 0 s"));
  write_faces(4);
  write("gas_pressure", "volFieldValue.dat", "# Cells : 199\n", gas);
  EXPECT_TRUE(holds(pressure_refusal(), "expected 200"));
  fs::remove(series("gas_pressure"));
  EXPECT_TRUE(holds(pressure_refusal(), "missing"));
}

// The column's front moves by a cell every ten samples.
class HarvestedColumn : public Harvested {
 protected:
  void SetUp() override {
    Harvested::SetUp();
    write("liquid_volume", "volFieldValue.dat", "", [](int) { return 0.1 * 0.35; });
    write_bottom_row(20);
  }

  void write_bottom_row(int cells) {
    fs::create_directories(series("bottom_row").parent_path());
    std::ofstream out(series("bottom_row", "alpha.liquid"));
    out << "# Probe 0 (0.025 0.5 0.05)\n#       Time\n";
    for (int i = 1; i <= 100; ++i) {
      out << 0.01 * i;
      for (int cell = 0; cell < cells; ++cell) {
        out << " " << std::clamp(2 + 0.1 * i - cell, 0.0, 1.0);
      }
      out << "\n";
    }
  }

  Harvest harvest_column() {
    SloshingTank tank = tank_with_one_gauge();
    tank.column_width = 0.1;
    return harvest(tank, directory_.path());
  }
};

TEST_F(HarvestedColumn, GivesTheFrontFromTheColumnsEdgeOn) {
  const History front = harvest_column().front_position;
  ASSERT_EQ(front.time.size(), 101u);
  EXPECT_NEAR(front.value[0], 0.1, 1e-14);
  EXPECT_NEAR(front.value[50], 0.35, 1e-12);
  EXPECT_NEAR(front.value[100], 0.6, 1e-12);
}

TEST_F(HarvestedColumn, StartsWithADryGaugeBeyondTheColumn) {
  EXPECT_EQ(harvest_column().elevation.at("gauge").value[0], -0.35);
}

TEST_F(HarvestedColumn, IsRefusedWithoutItsBottomRow) {
  write_bottom_row(19);
  EXPECT_TRUE(
      holds(message_of<RunError>([this] { harvest_column(); }), "expected 21 finite numbers"));
  fs::remove(series("bottom_row", "alpha.liquid"));
  EXPECT_TRUE(holds(message_of<RunError>([this] { harvest_column(); }), "missing"));
}

TEST_F(Harvested, GivesNoFrontOfALiquidThatFillsTheTank) {
  EXPECT_TRUE(harvest(tank_with_one_gauge(), directory_.path()).front_position.time.empty());
}

TEST_F(Harvested, RefusesWhatIsDamaged) {
  const auto refuse = [this](const char* said, const std::function<void()>& damage) {
    damage();
    const std::string message = refusal();
    EXPECT_TRUE(holds(message, said)) << said << ", got: ";
    fs::remove_all(directory_.path() / "postProcessing");
    SetUp();
    EXPECT_EQ(refusal(), "");
  };
  refuse("nan", [&] {
    write("column_19", "volFieldValue.dat", "# Cells : 10\n",
          [](int i) { return i == 57 ? std::nan("") : 0.35; });
    EXPECT_TRUE(holds(refusal(), "column_19"));
  });
  refuse("ends at 0.99 s, expected 1 s",
         [&] { write("column_18", "volFieldValue.dat", "# Cells : 10\n", left_filling, 99); });
  refuse("liquid_volume",
         [&] { write("liquid_volume", "volFieldValue.dat", "", left_filling, 0); });
  refuse("expected 10 finite numbers", [&] {
    const fs::path file = series("wall_force", "force.dat");
    fs::resize_file(file, fs::file_size(file) - 9);
  });
  refuse("a sample at 0.51 s follows one at 0.49 s", [&] {
    std::string text = contents(series("column_18"));
    const auto hole = text.find("\n0.5 ");
    text.erase(hole, text.find("\n0.51 ") - hole);
    std::ofstream(series("column_18")) << text;
  });
  refuse("missing", [&] { fs::remove(series("wall_force", "force.dat")); });
  refuse("a column of 20 cells, expected 10", [&] {
    write("column_18", "volFieldValue.dat", "# Cells             : 20\n", left_filling);
  });
  refuse("volume has changed", [&] {
    write("liquid_volume", "volFieldValue.dat", "", [](int i) { return 0.35 * (1 - 2e-6 * i); });
  });
  refuse("no line \"End\"",
         [&] { std::ofstream(directory_.path() / "log.interFoam") << "Time = 0.5\n"; });
  refuse("expected 11 finite numbers", [&] { write_gauge_cells(9); });
}

}  // namespace
}  // namespace slosh::openfoam::harvest_test
