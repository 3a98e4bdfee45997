// How a gauge of the case becomes a series of interFoam's own files.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "verification/import/import_series.hpp"
#include "verification/peers/tests/handed.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::written_case_test {
namespace {

// In the test's mesh of 20 x 12 cells of 50 mm.
std::string with_gauge_at(const std::string& x, const std::string& more = "") {
  return replaced(moving(surges), "x_m = 0.95", "x_m = " + x) + more;
}

SeriesSource first_series(const Handed& handed) { return handed.run().series.front(); }

const std::string baffle =
    "[[obstacle]]\nname = \"baffle\"\nleft_m = 0.5\nright_m = 0.55\nbottom_m = 0\ntop_m = 0.1\n";

TEST(OpenFoamCase, ReadsAGaugeInTheMiddleOfAColumnAsThatColumnsFilling) {
  Handed handed(with_gauge_at("0.925"));
  const SeriesSource source = first_series(handed.to("openfoam"));
  EXPECT_EQ(source.quantity, "elevation@right");
  EXPECT_EQ(source.file, "postProcessing/column_18/0/volFieldValue.dat");
  EXPECT_EQ(source.format, "openfoam_field_value");
  EXPECT_NEAR(source.scale, 0.6, 1e-12);
  EXPECT_NEAR(source.offset, -0.35, 1e-12);
  EXPECT_FALSE(holds(handed.file("README.md"), "its place"));
}

TEST(OpenFoamCase, SaysHowFarAGaugeIsFromTheColumnThatIsRead) {
  Handed handed(with_gauge_at("0.94"));
  EXPECT_EQ(first_series(handed.to("openfoam")).file,
            "postProcessing/column_18/0/volFieldValue.dat");
  EXPECT_TRUE(holds(handed.file("README.md"), "`elevation@right` is read 0.015 m to the left of"));
}

TEST(OpenFoamCase, CountsAnObstacleUnderAGaugeAndRefusesOneThatHangs) {
  Handed handed(with_gauge_at("0.525", baffle));
  const SeriesSource source = first_series(handed.to("openfoam"));
  EXPECT_NEAR(source.scale, 0.5, 1e-12);
  EXPECT_NEAR(source.offset, 0.1 - 0.35, 1e-12);
  Handed hanging(with_gauge_at(
      "0.525",
      replaced(replaced(baffle, "bottom_m = 0\n", "bottom_m = 0.4\n"), "0.1\n", "0.45\n")));
  const std::string message = message_of<CaseFileError>([&] { hanging.to("openfoam"); });
  EXPECT_TRUE(holds(message, "gauge: expected gauges in whose column"));
}

TEST(OpenFoamCase, NamesAllFilesOfTheCaseAsInputsOfTheRun) {
  Handed handed(with_gauge_at("0.925"));
  const ExternalRun run = handed.to("openfoam").run();
  const auto is_input = [&](const char* file) {
    return std::find(run.inputs.begin(), run.inputs.end(), handed.directory() / file) !=
           run.inputs.end();
  };
  for (const char* file :
       {"0/alpha.liquid", "constant/acceleration", "system/controlDict", "Allrun"})
    EXPECT_TRUE(is_input(file)) << file;
}

// The cases for other codes that are tables or the file of a driver, read again.

namespace fs = std::filesystem;

const std::string all_kinds = R"([[obstacle]]
name = "baffle"
left_m = 0.5
right_m = 0.6
bottom_m = 0.0
top_m = 0.1
[[pressure_gauge]]
name = "P"
wall = "right"
position_m = 0.15
width_m = 0.02
[[probe]]
name = "middle"
x_m = 0.3
z_m = 0.2
)";

TEST(CsvCase, HoldsTheGeometryCounterClockwise) {
  Handed handed(plain_case + all_kinds);
  const auto table = handed.to("csv").table("geometry.csv");
  using Texts = std::vector<std::string>;
  EXPECT_EQ(table.at("part"),
            (Texts{"tank", "tank", "tank", "tank", "liquid", "liquid", "liquid", "liquid",
                   "obstacle_baffle", "obstacle_baffle", "obstacle_baffle", "obstacle_baffle"}));
  EXPECT_EQ(table.at("x_m"),
            (Texts{"0", "1", "1", "0", "0", "1", "1", "0", "0.5", "0.6", "0.6", "0.5"}));
  EXPECT_EQ(table.at("z_m"),
            (Texts{"0", "0", "0.6", "0.6", "0", "0", "0.35", "0.35", "0", "0", "0.1", "0.1"}));
}

TEST(CsvCase, HoldsTheCornersOfATankThatIsNoRectangle) {
  Handed handed(replaced(replaced(plain_case, "length_m = 1.0\nheight_m = 0.6",
                                  "outline_m = [[0, 0], [1, 0], [1, 0.7], [0, 0.7], [0, 0.1]]"),
                         "solver = \"potential\"",
                         "solver = \"interfoam\"\ncells_x = 20\ncells_z = 12") +
                "[[pressure_gauge]]\nname = \"P\"\nx_m = 1\nz_m = 0.25\n");
  const auto table = handed.to("csv").table("geometry.csv");
  using Texts = std::vector<std::string>;
  EXPECT_EQ(table.at("part"), (Texts{"tank", "tank", "tank", "tank", "tank", "liquid", "liquid",
                                     "liquid", "liquid", "liquid"}));
  EXPECT_EQ(table.at("x_m"), (Texts{"0", "1", "1", "0", "0", "0", "1", "1", "0", "0"}));
  EXPECT_EQ(table.at("z_m"),
            (Texts{"0", "0", "0.7", "0.7", "0.1", "0", "0", "0.35", "0.35", "0.1"}));
  const auto gauges = handed.table("gauges.csv");
  EXPECT_EQ(gauges.at("x_m").back(), "1");
  EXPECT_EQ(gauges.at("z_m").back(), "0.25");
  EXPECT_FALSE(fs::exists(handed.directory() / "tank.json"));
}

TEST(CsvCase, HoldsASensorInTheRoof) {
  Handed handed(plain_case +
                "[[pressure_gauge]]\nname = \"P\"\nwall = \"roof\"\nposition_m = 0.3\n");
  const auto gauges = handed.to("csv").table("gauges.csv");
  EXPECT_EQ(gauges.at("x_m").back(), "0.3");
  EXPECT_EQ(gauges.at("z_m").back(), "0.6");
}

TEST(CsvCase, HoldsTheInitialWaveAsTheLiquidsPolygon) {
  Handed handed(plain_case + "[initial_wave]\nmode = 2\namplitude_m = 0.01\n");
  const auto x = handed.to("csv").numbers("geometry.csv", "x_m"),
             z = handed.numbers("geometry.csv", "z_m");
  ASSERT_EQ(x.size(), 4u + 203u);
  for (std::size_t i = 6; i < x.size(); ++i)  // after the tank and the liquid's bottom
    EXPECT_NEAR(z[i], 0.35 + 0.01 * std::cos(2 * std::numbers::pi * x[i]), 1e-15);
}

TEST(CsvCase, HoldsGaugesAndNumbersWithTheirUnits) {
  Handed handed(moving(surges) + all_kinds);
  const auto gauges = handed.to("csv").table("gauges.csv");
  using Texts = std::vector<std::string>;
  EXPECT_EQ(gauges.at("kind"), (Texts{"surface", "wall_pressure", "probe"}));
  EXPECT_EQ(gauges.at("name"), (Texts{"right", "P", "middle"}));
  EXPECT_EQ(gauges.at("x_m"), (Texts{"0.95", "1", "0.3"}));
  EXPECT_EQ(gauges.at("z_m"), (Texts{"", "0.15", "0.2"}));
  EXPECT_EQ(gauges.at("width_m"), (Texts{"", "0.02", ""}));
  const auto table = handed.table("numbers.csv");
  std::map<std::string, std::string> numbers;
  for (std::size_t i = 0; i < table.at("name").size(); ++i)
    numbers[table.at("name")[i]] = table.at("value")[i] + " " + table.at("unit")[i];
  EXPECT_EQ(numbers.at("tank_length"), "1 m");
  EXPECT_EQ(numbers.at("fill_depth"), "0.35 m");
  EXPECT_EQ(numbers.at("gravity"), "9.81 m/s2");
  EXPECT_EQ(numbers.at("initial_velocity_x"), "-0.034 m/s");
  EXPECT_EQ(numbers.at("sample_interval"), "0.02 s");
  EXPECT_FALSE(fs::exists(handed.directory() / "tank.json"));  // it has no place for obstacles
}

TEST(CsvCase, HoldsTheMotionOfAnIndependentFormulaForTheImporter) {
  Handed handed("walls_rolling");
  handed.to("csv");
  const auto time = handed.numbers("motion.csv", "time_s"),
             roll = handed.numbers("motion.csv", "roll_rad"),
             gravity = handed.numbers("tank_frame.csv", "gravity_x_m_s2");
  ASSERT_EQ(time.size(), 20001u);
  const double amplitude = 3 * std::numbers::pi / 180, period = 2 * std::numbers::pi / 4;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double s = std::min(1.0, time[i] / period);  // the ramp is the quintic smoothstep
    const double exact = amplitude * (6 * std::pow(s, 5) - 15 * std::pow(s, 4) + 10 * s * s * s) *
                         std::sin(4 * time[i]);
    EXPECT_NEAR(roll[i], exact, 1e-12);
    EXPECT_NEAR(gravity[i], -9.81 * std::sin(exact), 1e-11);
  }
  const TimeSeries read = import_series({.quantity = "elevation@left",
                                         .file = handed.directory() / "motion.csv",
                                         .format = "csv",
                                         .column = "roll_rad",
                                         .unit = "m",
                                         .time_column = "time_s",
                                         .time_unit = "s"});
  EXPECT_EQ(read.value, roll);
}

TEST(CsvCase, TakesAProgramBackByARunOfTheCase) {
  Handed handed(moving(surges));
  const ExternalRun run = handed.to("csv").run();
  EXPECT_EQ(run.command.front(), (handed.directory() / "my_program").string());
  EXPECT_EQ(run.series.front().quantity, "elevation@right");
  EXPECT_EQ(run.series.front().time_column, "time");
  EXPECT_EQ(nlohmann::json::parse(handed.file("tank.json")).at("fill_depth_m"), 0.35);
}

TEST(PySphCase, HoldsTheDriverItsFileAndItsRun) {
  Handed handed(moving(surges));
  const ExternalRun run = handed.to("pysph").run();
  EXPECT_EQ(run.method, "pysph_delta_sph");
  EXPECT_EQ(run.particle_spacing, 0.05);
  EXPECT_EQ(nlohmann::json::parse(handed.file("tank.json")).at("gauges").at(0).at("x_m"), 0.95);
  EXPECT_EQ(handed.file("pysph_tank.py"),
            read_bytes(SLOSH_SOURCE_DIR "/verification/peers/pysph_tank.py"));
  const auto executable = fs::status(handed.directory() / "run.sh").permissions();
  EXPECT_NE(executable & fs::perms::owner_exec, fs::perms::none);
}

}  // namespace
}  // namespace slosh::written_case_test
