#include <gtest/gtest.h>

#include <numeric>
#include <regex>
#include <sstream>

#include "openfoam_cases/sloshing_tank.hpp"
#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam {
namespace {

namespace fs = std::filesystem;

// The text that follows `key` in a dictionary, up to the semicolon.
std::string entry(const std::string& text, const std::string& key) {
  std::smatch match;
  return std::regex_search(text, match, std::regex("\\b" + key + "\\s+([^;]*);")) ? match[1].str()
                                                                                  : "no " + key;
}

// The numbers between the outermost parentheses after `key`.
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
    EXPECT_EQ(contents(entry.path()).find("{{"), std::string::npos) << entry.path();
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
    EXPECT_NE(control.find(std::string(column) + "\n"), std::string::npos);
    EXPECT_NE(zones.find(std::string(column) + ";"), std::string::npos);
  }
  EXPECT_EQ(control.find("column_2\n"), std::string::npos);
}

// The order of the cells is the mesh's: below the step's top 18 cells a row, then 2 and 18.
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

TEST_F(WrittenCase, RefusesATankThatCannotBe) {
  const auto refused = [this](auto change) {
    SloshingTank tank = small_tank();
    change(tank);
    return message_of<std::invalid_argument>([&] { write(tank); });
  };
  EXPECT_EQ(refused([](SloshingTank& t) { t.fill_depth = 1.4; }),
            "OpenFOAM tank: fill_depth = 1.4: expected less than the height of 1.3 m");
  EXPECT_EQ(refused([](SloshingTank& t) { t.length = std::nan(""); }),
            "OpenFOAM tank: length = nan: expected a positive number of m");
  EXPECT_NE(refused([](SloshingTank& t) { t.gauges[0].x = 1.2; }).find("gauge x"),
            std::string::npos);
  EXPECT_NE(refused([](SloshingTank& t) { t.gauges[0].name = "left"; }).find("two gauges"),
            std::string::npos);
  EXPECT_NE(refused([](SloshingTank& t) { t.processes = 21; }).find("processes"),
            std::string::npos);
  EXPECT_NE(refused([](SloshingTank& t) {
              t.acceleration = [](double time) { return time > 0.5 ? NAN : 0; };
            }).find("acceleration"),
            std::string::npos);
  EXPECT_NE(refused([](SloshingTank& t) { t.column_width = 1.1; }).find("column_width = 1.1"),
            std::string::npos);
  EXPECT_NE(refused([](SloshingTank& t) {
              t.obstacles = {{0.1, 0.22, 0, 0.13}};
            }).find("obstacle left = 0.1"),
            std::string::npos);
  EXPECT_NE(refused([](SloshingTank& t) {
              t.obstacles = {{0.99, 1.1, 0, 1.3}};
            }).find("gauge x = 1.05: expected a place where the obstacles leave room"),
            std::string::npos);
  EXPECT_NE(refused([](SloshingTank& t) {
              t.column_width = 0.11, t.obstacles = {{0, 0.22, 0, 0.52}};
            }).find("liquid volume"),
            std::string::npos);
  EXPECT_NE(refused([](SloshingTank& t) {
              t.column_width = 0.5, t.obstacles = {{0, 1.1, 0, 0.13}};
            }).find("column_width = 0.5: expected a bottom"),
            std::string::npos);
  EXPECT_TRUE(fs::is_empty(directory_.path())) << "a refused tank leaves nothing behind";
}

TEST_F(WrittenCase, RefusesADirectoryWithAnEarlierRunInIt) {
  write(small_tank());
  EXPECT_NE(message_of<std::invalid_argument>([this] { write(small_tank()); }).find("not empty"),
            std::string::npos);
}

TEST_F(WrittenCase, RefusesATemplateThatNamesWhatNothingDefines) {
  TemporaryDirectory templates;
  std::ofstream(templates.path() / "dictionary") << "length {{lenght}};\n";
  const std::string message =
      message_of<RunError>([&] { write_case(small_tank(), templates.path(), directory_.path()); });
  EXPECT_NE(message.find("lenght"), std::string::npos) << message;
  EXPECT_NE(message.find("dictionary"), std::string::npos) << message;
}

}  // namespace
}  // namespace slosh::openfoam
