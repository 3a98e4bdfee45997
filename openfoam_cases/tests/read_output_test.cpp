// What is read of logs and time directories of OpenFOAM.
#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/output/read_log.hpp"
#include "openfoam_cases/output/read_snapshot.hpp"
#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::read_output_test {
namespace {

const std::string banner = R"(
| =========                 |                                                 |
| \\      /  F ield         | OpenFOAM: The Open Source CFD Toolbox           |
Build  : OPENFOAM=1912 patch=200626
Exec   : interFoam
nProcs : 1
trapFpe: Floating point exception trapping enabled (FOAM_SIGFPE).

Create time
DICPCG:  Solving for pcorr, Initial residual = 1, Final residual = 8.05388587347e-09, No Iterations 94
Courant Number mean: 1.93620323922e-12 max: 5.80851471556e-12

Starting time loop
)";

const std::string two_steps = R"(
Courant Number mean: 0.00215249242374 max: 0.0182264766273
Interface Courant Number mean: 0.00014848658109 max: 0.00783782453642
deltaT = 0.002
Time = 1.998

PIMPLE: iteration 1
MULES: Solving for alpha.liquid
Phase-1 volume fraction = 0.35  Min(alpha.liquid) = -4.0822254139e-21  Max(alpha.liquid) = 1.00000084685
Time = 1.998 accelerations: ((-0.00777710412656 0 0) (0 0 0) (0 0 0))
DICPCG:  Solving for p_rgh, Initial residual = 0.00195816059671, Final residual = 4.1809946375e-05, No Iterations 1
DICPCG:  Solving for p_rgh, Initial residual = 4.19966254014e-05, Final residual = 8.14670528976e-08, No Iterations 28
ExecutionTime = 3.11 s  ClockTime = 3 s

Courant Number mean: 0.00213990567562 max: 0.0181372408124
Interface Courant Number mean: 0.00014739122006 max: 0.00777564147678
deltaT = 0.002
Time = 2

PIMPLE: iteration 1
Time = 2 accelerations: ((-0.00764854051812 0 0) (0 0 0) (0 0 0))
DICPCG:  Solving for p_rgh, Initial residual = 0.00195409128303, Final residual = 4.11887471991e-05, No Iterations 1
DICPCG:  Solving for p_rgh, Initial residual = 4.13717077396e-05, Final residual = 8.02840811026e-08, No Iterations 26
ExecutionTime = 3.11 s  ClockTime = 3 s
)";

const std::string end = "\nEnd\n\n";

const std::string diverging_end = R"(
Courant Number mean: 9.15676740639e+19 max: 9.12081499424e+21
Interface Courant Number mean: 0 max: 0
Time = 5

PIMPLE: iteration 1
#0  Foam::error::printStack(Foam::Ostream&) at ??:?
#1  Foam::sigFpe::sigHandler(int) at ??:?
#2  ? in /lib/x86_64-linux-gnu/libc.so.6
#3  ? in /usr/bin/interFoam
)";

const std::string fatal_end = R"(

--> FOAM FATAL IO ERROR: 
Unknown ddt type Eular

Valid ddt types :
8(CoEuler CrankNicolson Euler SLTS backward bounded localEuler steadyState)


file: system/fvSchemes.ddtSchemes.default at line 6.

FOAM exiting

)";

const std::string warning = R"(--> FOAM Warning : 
    From function void* Foam::dlLibraryTable::openLibrary(const Foam::fileName&, bool)
    in file db/dynamicLibrary/dlLibraryTable/dlLibraryTable.C at line 65
    Could not load "libfroces.so"
)";

const std::string face_in_interface = R"(--> FOAM Warning : 
    From function void Foam::isoCutFace::cutPoints(const pointField&, const scalarField&, Foam::scalar, Foam::DynamicList<Foam::Vector<double> >&)
    in file fvMatrices/solvers/isoAdvection/isoCutFace/isoCutFace.C at line 666
    cutPoints = 4((0.9 0 0.275) (0.9 1 0.275) (0.9 1 0.3) (0.9 0 0.3)) for pts = 4((0.9 0 0.275) (0.9 1 0.275) (0.9 1 0.3) (0.9 0 0.3)), f - f0 = 4(5.44634307678e-15 0 0 5.44634307678e-15) and f0 = 3.49196591746e-06
)";

LogReader read(const std::string& text) {
  LogReader reader;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) reader.read_line(line);
  return reader;
}

TEST(Log, OfAWholeRunGivesItsStepsAndTheirCost) {
  const LogReader log = read(banner + two_steps + end);
  EXPECT_EQ(log.failure(), "");
  EXPECT_EQ(log.version(), "1912");
  EXPECT_EQ(log.steps(), 2);
  EXPECT_EQ(log.time(), 2);
  EXPECT_EQ(log.max_courant_number(), 0.0182264766273);
  EXPECT_EQ(log.mean_pressure_iterations(), (1 + 28 + 1 + 26) / 2.0);
}

TEST(Log, KnowsWhenTheThirdStepWas) {
  EXPECT_EQ(read(two_steps).third_step_time(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(read(two_steps + two_steps).third_step_time(), 1.998);
}

TEST(Log, ThatStopsHalfWayIsAFailure) {
  const LogReader log = read(banner + two_steps);
  EXPECT_TRUE(holds(log.failure(), "no line \"End\""));
  EXPECT_TRUE(holds(log.meaningful_lines(), "ExecutionTime = 3.11 s"));
}

TEST(Log, WithAnEndInsideAnotherLineHasNotEnded) {
  EXPECT_NE(read(two_steps + "End of something else\n").failure(), "");
}

TEST(Log, WithAFatalErrorIsAFailureAndShowsTheError) {
  const LogReader log = read(banner + fatal_end);
  EXPECT_EQ(log.failure(), "a fatal error");
  EXPECT_TRUE(log.meaningful_lines().starts_with("--> FOAM FATAL IO ERROR"));
  EXPECT_TRUE(holds(log.meaningful_lines(), "Unknown ddt type Eular"));
  EXPECT_TRUE(holds(log.meaningful_lines(), "at line 6."));
}

TEST(Log, WithAFloatingPointExceptionIsADivergenceAndShowsTheStepsBefore) {
  const LogReader log = read(banner + two_steps + diverging_end);
  EXPECT_TRUE(holds(log.failure(), "diverged"));
  EXPECT_TRUE(holds(log.meaningful_lines(), "max: 9.12081499424e+21"));
}

TEST(Log, WithAWarningIsAFailureThoughTheRunEndsAsUsual) {
  const LogReader log = read(banner + warning + two_steps + end);
  EXPECT_EQ(log.failure(), "a warning");
  EXPECT_TRUE(holds(log.meaningful_lines(), "Could not load"));
}

TEST(Log, CountsTheFacesInTheInterfaceThatInterIsoFoamWarnsOf) {
  const std::string twice = banner + face_in_interface + two_steps + face_in_interface;
  EXPECT_EQ(read(twice + end).failure(), "");
  EXPECT_EQ(read(twice + end).faces_in_interface(), 2);
  EXPECT_EQ(read(banner + two_steps + end).faces_in_interface(), 0);
  const LogReader also_another = read(twice + warning + end);
  EXPECT_EQ(also_another.failure(), "a warning");
  EXPECT_TRUE(holds(also_another.meaningful_lines(), "Could not load"));
  EXPECT_NE(read(twice).failure(), "") << "the run has not ended";
  EXPECT_EQ(read(twice + fatal_end).failure(), "a fatal error");
}

TEST(Log, WithAFatalErrorAfterAWarningShowsTheErrorWithAllItsLines) {
  std::string valid_words;
  for (int i = 0; i < 40; ++i) valid_words += "scheme_" + std::to_string(i) + "\n";
  const LogReader log = read(banner + warning + fatal_end + valid_words);
  EXPECT_EQ(log.failure(), "a fatal error");
  EXPECT_TRUE(log.meaningful_lines().starts_with("--> FOAM FATAL IO ERROR"));
  EXPECT_TRUE(log.meaningful_lines().ends_with("scheme_39"));
}

TEST(Log, ThatIsMissingIsARunError) { EXPECT_THROW(read_log("/no/such/log.interFoam"), RunError); }

// Time directories as interFoam writes them, made by hand and then damaged.

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
  EXPECT_TRUE(holds(refusal(), "no fields at 0.5 s, the nearest are at 0.504 s"));
}

TEST_F(Snapshot, IsRefusedWithoutOneOfItsFields) {
  fs::remove(file("p"));
  EXPECT_TRUE(holds(refusal(), "missing"));
}

TEST_F(Snapshot, IsRefusedWithAnotherNumberOfCellsOrOneThatIsNone) {
  write("p", 4, [](int) { return "1"; });
  EXPECT_TRUE(holds(refusal(), "expected 5 cells"));
  write("p", 5, [](int cell) { return cell == 3 ? "nan" : "1"; });
  EXPECT_TRUE(holds(refusal(), "cell 3 is the first"));
  write("p", 5, [](int) { return "(1 2 3)"; });
  EXPECT_TRUE(holds(refusal(), "cell 0 is the first"));
}

TEST_F(Snapshot, IsRefusedWhereAFieldIsCutShort) {
  fs::resize_file(file("U"), fs::file_size(file("U")) - 60);
  EXPECT_TRUE(holds(refusal(), "expected 5 cells"));
}

}  // namespace
}  // namespace slosh::openfoam::read_output_test
