// Time directories as interFoam writes them, made by hand and then damaged.
#include "openfoam_cases/output/read_snapshot.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::read_snapshot_test {
namespace {

namespace fs = std::filesystem;

// There are two rows of three cells, and an obstacle fills the lower right one.
SloshingTank tank_of_five_cells() {
  SloshingTank tank = still_tank();
  tank.length = 0.3;
  tank.height = 0.4;
  tank.fill_depth = 0.3;
  tank.cells_x = 3;
  tank.cells_z = 2;
  tank.obstacles = {{0.2, 0.3, 0, 0.2}};
  tank.gauges = {};
  return tank;
}

class Snapshot : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(directory_.path() / "0");
    fs::create_directories(directory_.path() / "constant");
    fs::create_directories(directory_.path() / "0.5003");
    fs::create_directories(directory_.path() / "1");
    write("alpha.liquid", 5, [](int cell) { return cell < 2 ? "1" : cell == 2 ? "0.5" : "0"; });
    write("p", 5, [](int cell) { return std::to_string(10 * (5 - cell)); });
    write("U", 5,
          [](int cell) { return (std::ostringstream() << "(" << cell << " 0 -2.5e-3)").str(); });
  }

  fs::path file(const std::string& field) { return directory_.path() / "0.5003" / field; }

  void write(const std::string& field, int cells, const std::function<std::string(int)>& value) {
    std::ofstream out(file(field));
    out << "FoamFile\n{\n}\ndimensions      [0 0 0 0 0 0 0];\n\n"
        << "internalField   nonuniform List<scalar> \n"
        << cells << "\n(\n";
    for (int cell = 0; cell < cells; ++cell) out << value(cell) << "\n";
    out << ")\n;\n\nboundaryField\n{\n}\n";
  }

  FieldSnapshot read() {
    const SloshingTank tank = tank_of_five_cells();
    return read_snapshot(tank, TankMesh(tank), directory_.path(), 0.5);
  }

  std::string refusal() {
    return message_of<RunError>([this] { read(); });
  }

  TemporaryDirectory directory_;
};

TEST_F(Snapshot, HasEveryCellsPlaceAndFields) {
  const FieldSnapshot snapshot = read();
  EXPECT_EQ(snapshot.time, 0.5003);
  EXPECT_NEAR(snapshot.cell_width, 0.1, 1e-15);
  EXPECT_NEAR(snapshot.cell_height, 0.2, 1e-15);
  ASSERT_EQ(snapshot.x.size(), 5u);
  for (int cell = 0; cell < 5; ++cell) {
    const bool is_below = snapshot.z[cell] < 0.2;
    EXPECT_NEAR(snapshot.z[cell], is_below ? 0.1 : 0.3, 1e-15);
    EXPECT_EQ(snapshot.velocity_x[cell], cell);
    EXPECT_EQ(snapshot.velocity_z[cell], -2.5e-3);
    // Half a cell of gas at 30 Pa and cells at 20 and 10 Pa have a mean of 18 Pa.
    EXPECT_NEAR(snapshot.pressure[cell], 10 * (5 - cell) - 18, 1e-12);
  }
  EXPECT_NEAR(snapshot.x[1], 0.15, 1e-15);
  EXPECT_NEAR(snapshot.x[4], 0.25, 1e-15);
  EXPECT_EQ(snapshot.liquid_share, (std::vector<double>{1, 1, 0.5, 0, 0}));
}

TEST_F(Snapshot, MayBeUniform) {
  std::ofstream(file("U")) << "internalField   uniform (1 0 2);\n\nboundaryField\n";
  const FieldSnapshot snapshot = read();
  EXPECT_EQ(snapshot.velocity_x, std::vector<double>(5, 1));
  EXPECT_EQ(snapshot.velocity_z, std::vector<double>(5, 2));
}

TEST_F(Snapshot, IsRefusedWhereItIsLate) {
  fs::rename(directory_.path() / "0.5003", directory_.path() / "0.504");
  EXPECT_NE(refusal().find("no fields at 0.5 s, the nearest are at 0.504 s"), std::string::npos)
      << refusal();
}

TEST_F(Snapshot, IsRefusedWithoutOneOfItsFields) {
  fs::remove(file("p"));
  EXPECT_NE(refusal().find("missing"), std::string::npos) << refusal();
}

TEST_F(Snapshot, IsRefusedWithAnotherNumberOfCellsOrOneThatIsNone) {
  write("p", 4, [](int) { return "1"; });
  EXPECT_NE(refusal().find("expected 5 cells"), std::string::npos) << refusal();
  write("p", 5, [](int cell) { return cell == 3 ? "nan" : "1"; });
  EXPECT_NE(refusal().find("cell 3 is the first"), std::string::npos) << refusal();
  write("p", 5, [](int) { return "(1 2 3)"; });
  EXPECT_NE(refusal().find("cell 0 is the first"), std::string::npos) << refusal();
}

TEST_F(Snapshot, IsRefusedWhereAFieldIsCutShort) {
  fs::resize_file(file("U"), fs::file_size(file("U")) - 60);
  EXPECT_NE(refusal().find("expected 5 cells"), std::string::npos) << refusal();
}

}  // namespace
}  // namespace slosh::openfoam::read_snapshot_test
