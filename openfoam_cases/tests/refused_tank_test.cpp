// What makes a tank impossible, and what is said of it.
#include <gtest/gtest.h>

#include "openfoam_cases/geometry/layers.hpp"
#include "openfoam_cases/outline/outline.hpp"
#include "openfoam_cases/tests/motions.hpp"
#include "openfoam_cases/tests/outlines.hpp"
#include "openfoam_cases/write_case.hpp"

namespace slosh::openfoam::refused_tank_test {
namespace {

using Wall = PressureGauge::Wall;

// The cells are of 0.05 m in a tank of 1 x 0.5 m.
SloshingTank room() {
  SloshingTank tank = still_tank();
  tank.length = 1;
  tank.height = 0.5;
  tank.gauges = {};
  return tank;
}

SloshingTank narrow_tank() {
  SloshingTank tank = still_tank();
  tank.gap = Gap{0.062, 4};
  tank.no_slip = true;
  return tank;
}

SloshingTank rolling_tank() {
  SloshingTank tank = small_tank();
  tank.roll = harmonic_roll(0.1, 2, 0.5, 0);
  return tank;
}

SloshingTank with_gauge(SloshingTank tank, const PressureGauge& gauge) {
  tank.pressure_gauges = {gauge};
  return tank;
}

SloshingTank with_plate(const PressureGauge& gauge) {
  SloshingTank tank = with_gauge(room(), gauge);
  tank.obstacles = {{0, 0.1, 0.1, 0.2}};
  return tank;
}

SloshingTank with_outline(const Polygon& outline) {
  SloshingTank tank = chamfered_tank();
  tank.outline = outline;
  return tank;
}

std::string refusal(const SloshingTank& tank) {
  const TemporaryDirectory directory;
  const std::string message = message_of<std::invalid_argument>(
      [&] { write_case(tank, template_directory, directory.path()); });
  EXPECT_EQ(std::filesystem::is_empty(directory.path()), !message.empty())
      << "a refused tank leaves nothing behind";
  return message;
}

struct Tank {
  const char* said;
  SloshingTank (*made)();
};
// A tank, and what is said of it where it is changed so.
#define TANK(tank, said, ...) \
  Tank {                      \
    said, [] {                \
      SloshingTank t = tank;  \
      __VA_ARGS__;            \
      return t;               \
    }                         \
  }

void expect_refusals(std::initializer_list<Tank> tanks) {
  for (const Tank& tank : tanks) EXPECT_TRUE(holds(refusal(tank.made()), tank.said));
}

TEST(RefusedTank, HasNumbersThatCannotBe) {
  expect_refusals({
      TANK(small_tank(), "OpenFOAM tank: fill_depth = 1.4: expected less than the height of 1.3 m",
           t.fill_depth = 1.4),
      TANK(small_tank(), "OpenFOAM tank: length = nan: expected a positive number of m",
           t.length = NAN),
      TANK(small_tank(), "gap_friction = -1", t.gap_friction = -1),
      TANK(small_tank(), "gap_friction = 1: expected zero", t.gap_friction = 1,
           t.liquid.kinematic_viscosity = 0),
      TANK(small_tank(),
           "OpenFOAM tank: gap_friction = 0.3: expected zero for compressibleInterFoam, which "
           "knows no friction of the gap walls",
           t.gap_friction = 0.3, t.program = Program::compressible_inter_foam),
      TANK(small_tank(), "gauge x", t.gauges[0].x = 1.2),
      TANK(small_tank(), "two gauges", t.gauges[0].name = "left"),
      TANK(small_tank(), "courant_number = 1.1: expected above 0 and at most 1",
           t.courant_number = 1.1),
      TANK(small_tank(), "interface_courant_number = nan", t.interface_courant_number = NAN),
      TANK(small_tank(), "outer_corrections = 0", t.outer_corrections = 0),
      TANK(small_tank(), "processes", t.processes = 21),
      TANK(small_tank(), "snapshot time = 1.01: expected above 0 and at most the duration of 1 s",
           t.snapshot_times = {0.5, 1.01}),
      TANK(small_tank(), "snapshot time = 0:", t.snapshot_times = {0}),
      TANK(small_tank(), "snapshot time = nan", t.snapshot_times = {NAN}),
  });
}

TEST(RefusedTank, HasAMotionThatIsNotFinite) {
  expect_refusals({
      TANK(
          small_tank(), "acceleration",
          t.acceleration = [](double time) { return time > 0.5 ? NAN : 0; }),
      TANK(rolling_tank(), "roll axis x = inf: expected a finite place in m",
           t.roll->axis_x = INFINITY),
      TANK(rolling_tank(), "roll axis z = nan", t.roll->axis_z = NAN),
      TANK(rolling_tank(), "rate = nan", t.roll->initial_relative_rate = NAN),
      TANK(
          rolling_tank(), "roll angle = nan",
          t.roll->angle = [](double time) { return time > 0.5 ? NAN : 0; }),
  });
}

TEST(RefusedTank, HasALiquidThatDoesNotFit) {
  expect_refusals({
      TANK(small_tank(), "column_width = 1.1", t.column_width = 1.1),
      TANK(small_tank(), "liquid volume", t.column_width = 0.11,
           t.obstacles = {{0, 0.22, 0, 0.52}}),
      TANK(small_tank(), "column_width = 0.5: expected a bottom", t.column_width = 0.5,
           t.obstacles = {{0, 1.1, 0, 0.13}}),
      TANK(still_tank(), "initial_wave mode = 0", (t.initial_wave = InitialWave{0, 0.01})),
      TANK(still_tank(), "no wave on a column", (t.initial_wave = InitialWave{1, 0.01}),
           t.column_width = 0.3),
      TANK(still_tank(), "no wave on a column", (t.initial_wave = InitialWave{1, 0.01}),
           t.obstacles = {{0.11, 0.33, 0, 0.13}}),
      TANK(still_tank(), "no wave on a column", (t.start_disturbance = InitialWave{1, 1e-4}),
           t.column_width = 0.3),
      TANK(still_tank(), "no wave on a column", (t.start_disturbance = InitialWave{1, 1e-4}),
           t.obstacles = {{0.11, 0.33, 0, 0.13}}),
      TANK(still_tank(), "start_disturbance amplitude",
           (t.start_disturbance = InitialWave{1, 1e-4}), (t.initial_wave = InitialWave{1, 0.01})),
  });
  for (const double amplitude : {0.357, -0.4, 2.0, std::nan("")}) {
    SloshingTank tank = still_tank();
    tank.initial_wave = InitialWave{1, amplitude};
    EXPECT_TRUE(holds(refusal(tank), "initial_wave amplitude = "));
  }
}

TEST(RefusedTank, HasObstaclesThatAreNoneOrLeaveNotOneRoom) {
  expect_refusals({
      TANK(small_tank(), "obstacle left = 0.1", t.obstacles = {{0.1, 0.22, 0, 0.13}}),
      TANK(small_tank(), "gauge x = 1.05: expected a place where the obstacles leave room",
           t.obstacles = {{0.99, 1.1, 0, 1.3}}),
      TANK(room(),
           "OpenFOAM tank: obstacle left = 0.21: expected a multiple of the cells' 0.05 m, to 0.01 "
           "of a cell (the nearest is 0.2 m)",
           t.obstacles = {{0.21, 0.4, 0, 0.1}}),
      TANK(room(), "obstacle top = 0.1006", t.obstacles = {{0.2, 0.4, 0, 0.1006}}),
      TANK(room(), "right = 1.1: expected between the tank's walls",
           t.obstacles = {{0.9, 1.1, 0, 0.1}}),
      TANK(room(), "bottom = -0.1", t.obstacles = {{0.2, 0.4, -0.1, 0.1}}),
      TANK(room(), "right = nan", t.obstacles = {{0.2, NAN, 0, 0.1}}),
      TANK(room(), "a cell or more beyond the left edge at 0.4 m",
           t.obstacles = {{0.4, 0.2, 0, 0.1}}),
      TANK(room(), "a cell or more above", t.obstacles = {{0.2, 0.4, 0.1, 0.1}}),
      TANK(room(), "fill the tank", t.obstacles = {{0, 1, 0, 0.5}}),
      TANK(room(), "rooms without a connection", t.obstacles = {{0.4, 0.5, 0, 0.5}}),
      // A corner is no connection.
      TANK(room(), "rooms", (t.obstacles = {{0.4, 0.5, 0, 0.2}, {0.5, 0.6, 0.2, 0.5}})),
  });
  SloshingTank shorter = room();
  shorter.obstacles = {{0, 0.5, 0, 0.5}};
  EXPECT_EQ(refusal(shorter), "");
}

TEST(RefusedTank, HasSensorsOffItsWallsOrOutside) {
  const auto probe_at = [](double x, double z) {
    SloshingTank tank = still_tank();
    tank.obstacles = {{0.33, 0.44, 0.26, 0.39}};
    tank.probes = {{"probe", x, z}};
    return refusal(tank);
  };
  for (const auto& [x, z] : {std::pair{-0.1, 0.1}, {1.2, 0.1}, {0.5, 1.4}, {0.4, 0.3}})
    EXPECT_TRUE(holds(probe_at(x, z), "OpenFOAM tank: probe "));
  expect_refusals({
      TANK(small_tank(), "two pressure gauges are named \"one\"",
           (t.pressure_gauges = {{"one", Wall::left, 0.1, 0}, {"one", Wall::right, 0.1, 0}})),
      TANK(with_gauge(room(), {"", Wall::right, 0.51, 0}),
           "OpenFOAM tank: pressure gauge position = 0.51: expected with half the width of 0 m to "
           "both sides between the wall's ends, 0 and 0.5 m"),
      TANK(with_gauge(room(), {"", Wall::right, 0.49, 0.03}), "position = 0.49"),
      TANK(with_gauge(room(), {"", Wall::bottom, 0.01, 0.03}), "position = 0.01"),
      TANK(with_gauge(room(), {"", Wall::bottom, NAN, 0}), "position = nan"),
      TANK(with_gauge(room(), {"", Wall::bottom, 0.5, -0.01}), "width = -0.01"),
      TANK(with_gauge(room(), {"", Wall::bottom, 0.5, NAN}), "width = nan"),
      TANK(with_plate({"", Wall::left, 0.15, 0}), "no obstacle covers"),
      TANK(with_plate({"", Wall::left, 0.22, 0.05}), "no obstacle covers"),
      TANK(with_gauge(still_tank(), {"", Wall::left, 0, 0, Corner{0, 0.1}}), "without an outline"),
      TANK(with_gauge(chamfered_tank(), {"", Wall::left, 0, 0, Corner{0.5, 0.1}}),
           "x = 0.5: expected with z = 0.1 a place"),
      TANK(with_gauge(chamfered_tank(), {"", Wall::bottom, 0.05, 0}), "on the tank's outline"),
      TANK(with_gauge(chamfered_tank(), {"", Wall::left, 0, -1, Corner{0.5, 0}}), "width = -1"),
      TANK(chamfered_tank(), "a place inside the tank's outline",
           (t.probes = {{"probe", 0.05, 0.05}})),
  });
  EXPECT_EQ(refusal(with_plate({"", Wall::bottom, 0.99, 0.02})), "") << "up to the corner";
  EXPECT_EQ(refusal(with_plate({"", Wall::left, 0.225, 0.05})), "") << "up to the obstacle";
}

TEST(RefusedTank, HasAnOutlineThatIsNoSimplePolygonOrWithWhatItCannotCarry) {
  expect_refusals({
      TANK(with_outline({{0, 0}, {1, 0.8}}),
           "OpenFOAM tank: outline corners = 2: expected three or more"),
      TANK(with_outline({{0, 0}, {0, 0.8}, {1, 0.8}, {1, 0}}), "corners counter-clockwise"),
      TANK(with_outline({{0, 0}, {1, 0.8}, {1, 0}, {0, 0.8}}), "cross or touch"),
      TANK(with_outline({{0, 0}, {1, 0}, {1, 0.8}, {0.5, 0}, {0, 0.8}}), "cross or touch"),
      TANK(with_outline({{0, 0}, {1, 0}, {1, 0}, {1, 0.8}, {0, 0.8}}), "edges that have a length"),
      TANK(with_outline({{0, 0}, {1, 0}, {1, NAN}, {0, 0.8}}), "corner z = nan"),
      TANK(with_outline({{0.1, 0}, {1, 0}, {1, 0.8}, {0.1, 0.8}}), "least x of the outline = 0.1"),
      TANK(with_outline({{0, 0}, {1, 0}, {1, 0.7}, {0, 0.7}}), "largest z of the outline = 0.7"),
      TANK(inclined_tank(), "it divides the cell in column 18, row",
           (t.outline = {{0, 0}, {0.498, 0}, {0.5, 0.5}, {0.502, 0}, {1, 0}, {1, 0.6}, {0, 0.6}})),
      TANK(lying_cylinder(), "at most half do", t.cells_x = t.cells_z = 4),
      TANK(chamfered_tank(), "obstacles: expected none in a tank with an outline",
           t.obstacles = {{0.5, 0.525, 0, 0.1}}),
      TANK(chamfered_tank(), "column_width = 0.3: expected none", t.column_width = 0.3),
      TANK(chamfered_tank(), "loaded wall \"left_bottom\": expected left, right, bottom or roof",
           t.loaded_walls = {"left_bottom"}),
      TANK(chamfered_tank(), "fill_depth = 0.8: expected less than the height", t.fill_depth = 0.8),
  });
  EXPECT_EQ(refusal(inclined_tank()), "");
}

TEST(RefusedTank, HasGradedCellsOrAGapThatCannotBe) {
  const char* const no_gap =
      "gap breadth = 0.062: expected no gap in three dimensions of a tank "
      "with an outline or obstacles";
  expect_refusals({
      TANK(still_tank(),
           "OpenFOAM tank: wall_cell = 0.015: expected none in a tank with an outline or "
           "obstacles, whose cells are uniform",
           t.wall_cell = 0.015, t.obstacles = {{0.11, 0.22, 0, 0.13}}),
      TANK(still_tank(), "wall_cell = 0.015: expected none", t.wall_cell = 0.015,
           (t.outline = {{0, 0}, {1.1, 0}, {1.1, 1.3}, {0, 1.3}})),
      TANK(still_tank(),
           "OpenFOAM tank: kinematic_viscosity = 0: expected above 0 m2/s for a liquid that "
           "sticks "
           "to the walls",
           t.no_slip = true, t.liquid.kinematic_viscosity = 0),
      TANK(room(),
           "OpenFOAM tank: wall_cell = 0.06: expected above 0 and at most the 0.05 m of cells_x = "
           "20 uniform cells",
           t.wall_cell = 0.06),
      TANK(room(), "wall_cell = 0: expected above 0", t.wall_cell = 0),
      TANK(room(), "wall_cell = nan", t.wall_cell = NAN),
      TANK(room(), "wall_cell = 0.001: expected at least 0.0", t.wall_cell = 0.001),
      TANK(room(),
           "m for cells_x = 20, as each cell is at most 1.2 times as thick as its neighbour",
           t.wall_cell = 0.001),
      TANK(narrow_tank(),
           "OpenFOAM tank: gap breadth = 0.062: expected walls to which the liquid sticks "
           "(no_slip) in three dimensions",
           t.no_slip = false),
      TANK(narrow_tank(),
           "OpenFOAM tank: gap_friction = 0.4: expected zero in three dimensions, where the mesh "
           "has a gap wall",
           t.gap_friction = 0.4),
      TANK(narrow_tank(), "loaded wall \"front\": expected left, right, bottom or roof",
           t.loaded_walls = {"front"}),
      TANK(narrow_tank(), "OpenFOAM tank: gap cells = 3: expected at least 4", t.gap->cells = 3),
      TANK(narrow_tank(), "OpenFOAM tank: gap breadth = 0: expected a positive number of m",
           t.gap->breadth = 0),
  });
  SloshingTank narrow = narrow_tank();
  narrow.obstacles = {{0.11, 0.22, 0, 0.13}};
  EXPECT_TRUE(holds(refusal(narrow), no_gap));
  narrow.obstacles = {};
  narrow.outline = {{0, 0}, {1.1, 0}, {1.1, 1.3}, {0, 1.3}};
  EXPECT_TRUE(holds(refusal(narrow), no_gap));
  narrow = narrow_tank();
  narrow.wall_cell = 0.001;
  EXPECT_EQ(
      message_of<std::invalid_argument>([&] { check_layers(narrow); }),
      "OpenFOAM tank: wall_cell = 0.001: expected at least 0.00207 m for 4 cells across 0.031 m, "
      "half of the gap, as each cell is at most 2 times as thick as its neighbour");
}

#undef TANK

}  // namespace
}  // namespace slosh::openfoam::refused_tank_test
