// The command `case` as a user meets it: what it writes for interFoam is run by interFoam and gives
// what our own run gives; the script for DualSPHysics starts its programs, which are stood in for;
// the run that is written takes the output of both back.
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "verification/results/result_file.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::case_for_codes_test {
namespace {

namespace fs = std::filesystem;

// The gauge is in the middle of a column of 20 cells.
const std::string short_case =
    with(with(with(with(small_case, "duration_s = 8.0", "duration_s = 1.0"), "window_end_s = 8.0",
                   "window_end_s = 1.0"),
              "window_begin_s = 1.0", "window_begin_s = 0.2"),
         "x_m = 0.95", "x_m = 0.975");
const std::string baffle =
    "[[obstacle]]\nname = \"baffle\"\nleft_m = 0.45\nright_m = 0.55\nbottom_m = 0\ntop_m = 0.1\n";

class CaseForCodes : public SmallCampaign {
 protected:
  // Writes small.toml, the case for the code, and small.toml anew with the run.
  void hand(const std::string& text, const std::string& code,
            const std::vector<std::string>& more = {}) const {
    write("small.toml", text);
    std::vector<std::string> command{"case", "./small.toml", "--for", code, "-o", "for it"};
    command.insert(command.end(), more.begin(), more.end());
    const Ended ended = tool(command);
    ASSERT_EQ(ended.status, 0) << ended.err;
    write("small.toml", text + read("for it/run.toml"));
  }

  std::map<std::string, std::map<long, double>> series_of(const std::string& run) const {
    std::map<std::string, std::map<long, double>> all;
    for (const TimeSeries& series : read_result(directory() / (run + ".h5")).series)
      for (std::size_t i = 0; i < series.time.size(); ++i)
        all[series.name][std::lround(series.time[i] * 1e6)] = series.value[i];
    return all;
  }

  // The largest difference of a series of two runs at their common times after `from` [s], over the
  // largest magnitude of the first.
  double difference(const std::string& quantity, const std::string& own, const std::string& other,
                    double from) const {
    const auto mine = series_of(own).at(quantity), theirs = series_of(other).at(quantity);
    double largest = 0, most = 0;
    int common = 0;
    for (const auto& [time, value] : theirs)
      if (const auto found = mine.find(time); time >= from * 1e6 && found != mine.end()) {
        ++common;
        largest = std::max(largest, std::abs(found->second));
        most = std::max(most, std::abs(value - found->second));
      }
    EXPECT_GE(common, 80) << quantity;
    return most / largest;
  }

  void expect_agreement(const std::string& text) const {
    hand(text + mesh_run, "openfoam");
    EXPECT_EQ(run("mesh", {"-o", "mesh.h5"}).status, 0);
    const Ended theirs = run("openfoam_20x20", {"-o", "openfoam_20x20.h5"});
    ASSERT_EQ(theirs.status, 0) << theirs.err;
    EXPECT_LT(difference("elevation@right", "mesh", "openfoam_20x20", 0), 1e-9);
    for (const char* load : {"force_x", "force_z"})  // after the impulse of the start
      EXPECT_LT(difference(load, "mesh", "openfoam_20x20", 0.1), 1e-9) << load;
  }
};

TEST_F(CaseForCodes, RunsInInterFoamAndGivesWhatOurOwnRunGives) {
  if (!has_interfoam()) GTEST_SKIP() << "OpenFOAM is not installed";
  expect_agreement(short_case);
}

TEST_F(CaseForCodes, RunsInInterFoamWithAnObstacleInARollingTankToo) {
  if (!has_interfoam()) GTEST_SKIP() << "OpenFOAM is not installed";
  const std::string roll =
      "[motion.roll]\ntype = \"sine\"\namplitude_deg = 3\nangular_frequency_rad_s = 3\n"
      "ramp_periods = 1\naxis_x_m = 0.5\naxis_z_m = 0.2\n";
  std::string text = with(short_case,
                          "[motion.surge]\ntype = \"sine\"\namplitude_m = 0.02\n"
                          "angular_frequency_rad_s = 3.0\n",
                          roll + baffle);
  text = text.substr(0, text.find("[[run]]"));  // no theory knows the baffle
  expect_agreement(with(text, "natural_modes = 1", "natural_modes = 0"));
  EXPECT_LT(difference("moment", "mesh", "openfoam_20x20", 0.1), 1e-9);
}

TEST_F(CaseForCodes, RunsByItsOwnScriptInPlace) {
  if (!has_interfoam()) GTEST_SKIP() << "OpenFOAM is not installed";
  hand(with(with(short_case, "duration_s = 1.0", "duration_s = 0.3"), "window_end_s = 1.0",
            "window_end_s = 0.3"),
       "openfoam", {"--spacing", "0.05"});
  const Ended ended = end_of(start((directory() / "for it/Allrun").string(), {}));
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_TRUE(fs::exists(directory() / "for it/postProcessing/column_19/0/volFieldValue.dat"));
  fs::remove(directory() / "for it/system/fvSchemes");
  const Ended broken = end_of(start((directory() / "for it/Allrun").string(), {"elsewhere"}));
  EXPECT_EQ(broken.status, 1);
  EXPECT_TRUE(holds(broken.out, "fvSchemes"));
}

TEST_F(CaseForCodes, StartsPySphOrNamesItsPackage) {
  hand(short_case, "pysph", {"--spacing", "0.05"});
  const bool installed =
      boost::process::system("/usr/bin/python3", "-c", "import pysph",
                             boost::process::std_out > boost::process::null,
                             boost::process::std_err > boost::process::null) == 0;
  const Ended ended = end_of(start((directory() / "for it/run.sh").string(), {"its output"}));
  EXPECT_EQ(ended.status, installed ? 0 : 3) << ended.err;
  if (installed)
    EXPECT_TRUE(holds(read("its output/elevation.csv"), "t,right\n0,"));
  else
    EXPECT_TRUE(holds(ended.err, "python3-pysph"));
}

// What stands in for GenCase and DualSPHysics checks what it is given. The surface stands 0.36 m
// high and swings by 1 cm.
constexpr const char* gencase = R"sh(#!/bin/sh
grep -q '<casedef>' "$1.xml" && [ "$3" = -save:all ] && touch "$2.xml"
)sh";
constexpr const char* dualsphysics = R"sh(#!/bin/sh
[ "$1" = -cpu ] && [ "$2" = -ompthreads:1 ] && [ -f "$3.xml" ] || exit 9
[ "$(wc -l < "$4/small_acceleration.csv")" -gt 1000 ] || exit 8
awk -v out="$4" 'BEGIN {
  swl = out "/GaugesSWL_surface_right.csv"; top = out "/GaugesMaxZ_highest_right.csv"
  force = out "/GaugesForce_on_tank.csv"
  print "time [s];swlx [m];swly [m];swlz [m];pos0x [m];pos0y [m];pos0z [m];pos2x [m];pos2y [m];pos2z [m]" > swl
  print "time [s];zmax [m];posx [m];posy [m];posz [m]" > top
  print "time [s];force [N];forcex [N];forcey [N];forcez [N]" > force
  for (i = 0; i <= 101; ++i) {
    t = i / 100; z = 0.36 + 0.01 * sin(3 * t)
    printf "%f;0.975;0;%g;0.975;0;0;0.975;0;1\n", t, z > swl
    printf "%f;%g;0.975;0;0\n", t, z - 0.02 > top
    printf "%f;5;3;0;-4\n", t > force
  }
}'
echo "$WARNING"
)sh";

class CaseForDualSphysics : public CaseForCodes {
 protected:
  void stand_in(const std::string& name, const std::string& script) const {
    write(name, script);
    fs::permissions(directory() / name, fs::perms::owner_all);
  }
  Ended run_it(const std::string& warning = "") const {
    return tool({"run", "./small.toml", "dualsphysics_50mm", "-o", "theirs.h5"},
                {{"GENCASE", (directory() / "gencase").string()},
                 {"DUALSPHYSICS", (directory() / "dualsphysics").string()},
                 {"WARNING", warning}});
  }
};

TEST_F(CaseForDualSphysics, StartsItsProgramsAndTakesItsGaugesBack) {
  hand(short_case, "dualsphysics", {"--spacing", "0.05"});
  stand_in("gencase", gencase);
  stand_in("dualsphysics", dualsphysics);
  const Ended ended = run_it();
  ASSERT_EQ(ended.status, 0) << ended.err;
  auto series = series_of("theirs");
  EXPECT_EQ(series.size(), 4u);
  for (const auto& [time, value] : series.at("elevation@right"))
    EXPECT_NEAR(value, 0.01 * std::sin(3e-6 * static_cast<double>(time)), 2e-6);
  EXPECT_EQ(series.at("force_x").at(500000), 3);
  EXPECT_EQ(series.at("force_z").at(500000), -4);
}

TEST_F(CaseForDualSphysics, FailsWhereParticlesHaveNoNormals) {
  hand(short_case, "dualsphysics", {"--spacing", "0.05"});
  stand_in("gencase", gencase);
  stand_in("dualsphysics", dualsphysics);
  const Ended ended = run_it(
      "*** WARNING: There are 324 of 384 fixed or moving boundary particles without normal data.");
  EXPECT_EQ(ended.status, 3);
  EXPECT_TRUE(holds(ended.err, "324 of 384"));
}

TEST_F(CaseForCodes, TellsOfAMotionWhoseAccelerationIsMostlyNoise) {
  std::string rows = "time_s,displacement_m\n";
  for (int i = 0; i <= 1000; ++i)
    rows += fmt::format("{:.3f},{:.4f}\n", 0.001 * i, 0.002 * std::sin(0.003 * i));
  write("surge.csv", rows);
  write("small.toml",
        with(short_case, "\"sine\"\namplitude_m = 0.02\nangular_frequency_rad_s = 3.0",
             "\"table\"\nfile = \"surge.csv\""));
  const Ended ended = tool({"case", "./small.toml", "--for", "csv", "-o", "tables"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  const char* doubt = "doubtful: the noise of motion.surge, whose table surge.csv";
  EXPECT_TRUE(holds(ended.out, doubt));
  const Ended theory = run("theory");
  EXPECT_EQ(theory.status, 0) << theory.err;
  EXPECT_TRUE(holds(theory.out, doubt)) << theory.out;
}

TEST_F(CaseForCodes, IsRefusedWithTheOptionTheKeyAndThePlace) {
  write("small.toml", short_case + baffle);
  const auto refusal = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command{"case", "./small.toml"};
    command.insert(command.end(), more.begin(), more.end());
    const Ended ended = tool(command);
    EXPECT_EQ(ended.status, 2) << ended.out;
    return ended.err;
  };
  EXPECT_TRUE(holds(refusal({"--for", "pysph", "-o", "out"}), "obstacle: expected a tank without"));
  EXPECT_TRUE(holds(refusal({"--for", "dualsphysik", "-o", "out"}), "nearest: dualsphysics"));
  EXPECT_TRUE(holds(refusal({"--for", "dualsphysics", "--spacing", "0.06", "-o", "out"}),
                    "--spacing: 0.06: expected a whole fraction"));
  EXPECT_TRUE(holds(refusal({"--for", "csv", "--spacing", "-1", "-o", "out"}), "--spacing"));
  EXPECT_TRUE(holds(refusal({"--for", "csv", "-o", "."}), "--output: "));
  EXPECT_FALSE(fs::exists(directory() / "out"));
}

}  // namespace
}  // namespace slosh::case_for_codes_test
