// Options that a tank does not use must not change its case. The dictionaries of a tank without a
// column, obstacles, roll, pressure gauges and snapshots are, but for the momentum, byte for byte
// those of interFoam's first results.
#include <gtest/gtest.h>

#include <regex>

#include "openfoam_cases/sloshing_tank.hpp"
#include "openfoam_cases/tests/small_tank.hpp"
#include "openfoam_cases/write_case.hpp"

namespace slosh::openfoam::plain_tank_test {
namespace {

constexpr const char* block_mesh_dictionary =
    R"(FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }

// The mesh is one cell in y, 1 m long, so that every integral is per metre of width.
scale 1;

vertices
(
    (0 0 0) (1.1 0 0) (1.1 1 0) (0 1 0)
    (0 0 1.3) (1.1 0 1.3) (1.1 1 1.3) (0 1 1.3)
);

blocks
(
    hex (0 1 2 3 4 5 6 7) (20 1 10) simpleGrading (1 1 1)
);

boundary
(
    walls
    {
        type wall;
        faces ((0 4 7 3) (1 2 6 5) (0 3 2 1) (4 5 6 7));
    }
    frontAndBack
    {
        type empty;
        faces ((0 1 5 4) (3 7 6 2));
    }
);
)";

constexpr const char* control_dictionary =
    R"(FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }

application         interFoam;
startFrom           startTime;
startTime           0;
stopAt              endTime;
endTime             1;
deltaT              MAX_TIME_STEP;

writeControl        adjustableRunTime;
writeInterval       1;
writeFormat         ascii;
writePrecision      12;
timePrecision       12;
runTimeModifiable   no;

// Small waves never reach the Courant limits, so that the largest step sets their accuracy.
adjustTimeStep      yes;
maxDeltaT           MAX_TIME_STEP;
maxCo               0.5;
maxAlphaCo          0.5;

functions
{

    liquid_volume
    {
        type            volFieldValue;
        libs            ("libfieldFunctionObjects.so");
        regionType      all;
        operation       volIntegrate;
        fields          (alpha.liquid);
        writeFields     no;
        log             no;
        writeControl    adjustableRunTime;
        writeInterval   0.01;
    }
    wall_force
    {
        type            forces;
        libs            ("libforces.so");
        patches         (walls);
        rho             rho;
        CofR            (0 0 0);
        log             no;
        executeControl  adjustableRunTime;
        executeInterval 0.01;
        writeControl    adjustableRunTime;
        writeInterval   0.01;
    }
    liquid_momentum
    {
        type            volFieldValue;
        libs            ("libfieldFunctionObjects.so");
        regionType      all;
        operation       weightedVolIntegrate;
        weightField     alpha.liquid;
        fields          (U);
        writeFields     no;
        log             no;
        writeControl    adjustableRunTime;
        writeInterval   0.01;
    }
}
)";

class PlainTank : public ::testing::Test {
 protected:
  void SetUp() override { write_case(tank_, template_directory, directory_.path()); }
  std::string file(const std::string& name) { return contents(directory_.path() / name); }

  static SloshingTank tank_without_gauges() {
    SloshingTank tank = small_tank();
    tank.gauges = {};
    return tank;
  }

  SloshingTank tank_ = tank_without_gauges();
  TemporaryDirectory directory_;
};

TEST_F(PlainTank, HasTheMeshDictionaryThatItAlwaysHad) {
  EXPECT_EQ(file("system/blockMeshDict"), block_mesh_dictionary);
}

TEST_F(PlainTank, HasTheFunctionObjectsThatItAlwaysHad) {
  // The last bit of the step depends on the machine's hyperbolic tangent.
  const std::regex step("(eltaT +)[0-9.e-]+;");
  EXPECT_EQ(std::regex_replace(file("system/controlDict"), step, "$1MAX_TIME_STEP;"),
            control_dictionary);
}

TEST_F(PlainTank, HasTheReferencePressureWhereItAlwaysWas) {
  EXPECT_NE(
      file("system/fvSolution").find("    pRefPoint           (0.5775 0.5 1.2349999999999999);\n"),
      std::string::npos);
}

TEST_F(PlainTank, HasTheInitialFieldThatItAlwaysHad) {
  std::string expected = "nonuniform List<scalar> 200\n(\n";
  for (int cell = 0; cell < 200; ++cell) {
    expected += cell < 40 ? "1\n" : cell < 60 ? "LEVEL\n" : "0\n";
  }
  expected += ");\n";
  const std::string level = "0.7461538461538462";  // 0.357 / 0.13 - 2
  const std::string text = std::regex_replace(file("0/alpha.liquid"), std::regex(level), "LEVEL");
  EXPECT_NE(text.find(expected), std::string::npos) << text;
}

}  // namespace
}  // namespace slosh::openfoam::plain_tank_test
