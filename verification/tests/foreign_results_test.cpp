// The commands import and compare as a user starts them: another program's file becomes a result,
// and two results are compared and judged with no case at all.
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "verification/results/result_file.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::foreign_results_test {
namespace {

using std::numbers::pi;

struct Wave {
  double amplitude = 0.02, lag = 0, end = 10;  // [m], [s]
};

// Two tones, so that neither series is the other's copy but for scale and lag.
double height(double time) {
  return std::sin(2 * pi * 0.8 * time) + 0.1 * std::sin(2 * pi * 1.7 * time + 1);
}

class ForeignResults : public SmallCampaign {
 protected:
  void write_gauge(const std::string& file, const Wave& wave) const {
    std::string text = "time [s];swlx [m];swly [m];swlz [m]\n";
    for (int i = 0; 0.02 * i <= wave.end; ++i) {
      const double time = 0.02 * i;
      text += std::to_string(time) + ";0.95;0;" +
              std::to_string(0.35 + wave.amplitude * height(time - wave.lag)) + "\n";
    }
    write(file, text);
  }
  Ended import_gauge(const std::string& file, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{
        "import",   file,    "--format", "dualsphysics_gauge", "--series", "elevation@right=swlz",
        "--offset", "-0.35", "-o",       file + ".h5"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return tool(arguments);
  }
  void import_pair(const Wave& candidate) const {
    write_gauge("a.csv", candidate);
    write_gauge("b.csv", {});
    ASSERT_EQ(import_gauge("a.csv").status, 0);
    ASSERT_EQ(import_gauge("b.csv").status, 0);
  }
  Ended compare(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"compare", "a.csv.h5", "b.csv.h5"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return tool(arguments);
  }
  int judged(const Wave& candidate, const std::vector<std::string>& more) const {
    import_pair(candidate);
    return compare(more).status;
  }
};

TEST_F(ForeignResults, AnImportedFileIsAResultWithItsProvenance) {
  write_gauge("a.csv", {});
  const Ended ended = import_gauge("a.csv");
  EXPECT_EQ(ended.status, 0) << ended.err;
  const RunResult result = read_result(directory() / "a.csv.h5");
  EXPECT_EQ(result.solver, "imported");
  EXPECT_EQ(result.provenance.at("source_format"), "dualsphysics_gauge");
  EXPECT_EQ(result.provenance.at("source_hash").size(), 32u);
  EXPECT_EQ(result.provenance.at("command"),
            "./slosh import 'a.csv' --format dualsphysics_gauge --series 'elevation@right=swlz' "
            "--offset -0.35 -o 'a.csv.h5'");
  const TimeSeries& elevation = result.at("elevation@right");
  EXPECT_EQ(elevation.unit, "m");
  EXPECT_EQ(elevation.time.size(), 501u);
  EXPECT_NEAR(elevation.value[10], 0.02 * height(0.2), 1e-6);
}

TEST_F(ForeignResults, AnImportIsRefusedByTheLineWhereItGoesWrong) {
  write("a.csv", "time [s];swlz [m]\n0;0.35\n0.1;nan\n");
  const Ended unusable = import_gauge("a.csv");
  EXPECT_EQ(unusable.status, 4);
  EXPECT_EQ(unusable.err, "slosh: a.csv:3: swlz = nan: expected a number, in m\n");
  EXPECT_FALSE(std::filesystem::exists(directory() / "a.csv.h5"));
  const Ended wrong_unit = import_gauge("a.csv", {"--unit", "mm"});
  EXPECT_EQ(wrong_unit.status, 2);
  EXPECT_EQ(wrong_unit.err, "slosh: a.csv: unit = mm: expected m, as the file says\n");
  const Ended no_quantity = import_gauge("a.csv", {"--series", "elevatoin@right=swlz"});
  EXPECT_EQ(no_quantity.status, 2);
  EXPECT_TRUE(holds(no_quantity.err, "nearest: elevation@GAUGE"));
  EXPECT_EQ(import_gauge("a.csv", {"--format", "gauge"}).status, 2);
}

TEST_F(ForeignResults, TheFilesOfARestartedRunAreOneSeriesWhoseSeamIsTold) {
  write("a.csv", "time [s];swlz [m]\n0;0.35\n0.1;0.36\n0.2;0.5\n0.3;0.5\n");
  write("b.csv", "time [s];swlz [m]\n0.2;0.37\n0.3;0.38\n0.4;0.39\n");
  const Ended ended = import_gauge("a.csv", {"b.csv"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  const std::string seam =
      "b.csv:2: takes over at 0.2 s; the 2 values up to 0.3 s before it are "
      "left out";
  EXPECT_TRUE(holds(ended.out, "5 samples from 0 to 0.4 s"));
  EXPECT_TRUE(holds(ended.out, seam));
  const RunResult result = read_result(directory() / "a.csv.h5");
  EXPECT_NEAR(result.at("elevation@right").value[3], 0.03, 1e-12);
  EXPECT_EQ(result.provenance.at("seams_of_elevation@right"), seam);
}

// Five rows of ten particles fill the tank.
TEST_F(ForeignResults, ParticlesThatCannotBeTheLiquidAreRefusedAndDoubtfulOnesToldOf) {
  write_campaign(with(small_case, "fill_depth_m = 0.35", "fill_depth_m = 0.5"));
  const auto lattice = [](double time, int rows, double volume) {
    std::string text;
    for (int i = 0; i < 10 * rows; ++i)
      text +=
          fmt::format("{},{},{},{}\n", time, 0.05 + 0.1 * (i % 10), 0.05 + 0.1 * (i / 10), volume);
    return text;
  };
  const auto imported = [&](const std::string& rows, const std::string& more = "") {
    write("p.csv", "time,x,z,V\n" + rows);
    return typed("import p.csv --format particles --case ./small.toml --spacing 0.1 -o p.h5 " +
                 more);
  };
  const std::string whole = lattice(0, 5, 0.01);
  const Ended right = imported(whole + lattice(1, 5, 0.0101), "--volume V");
  EXPECT_EQ(right.status, 0) << right.err;
  EXPECT_EQ(right.err, "");
  for (const char* place : {"-0.11,0.1", "1.11,0.1", "0.1,-0.11", "0.1,1.11"}) {
    const Ended out = imported(whole + "1,0.1,0.1,1\n1," + place + ",1\n");
    EXPECT_EQ(out.status, 2) << place;
    EXPECT_TRUE(holds(out.err, "p.csv:53: place in the tank = (")) << out.err;
    EXPECT_TRUE(holds(out.err, "x from 0 to 1 m and z from 0 to 1 m (bottom and roof)")) << out.err;
  }
  const Ended void_of = imported(whole + "1,0.1,0.1,0\n", "--volume V");
  EXPECT_EQ(void_of.status, 2);
  EXPECT_TRUE(holds(void_of.err, "p.csv:52: V = 0: expected a number > 0, in m2")) << void_of.err;
  const auto expect_doubt = [&](const Ended& ended, const std::string& doubt) {
    EXPECT_EQ(ended.status, 0) << ended.err;
    EXPECT_TRUE(holds(ended.err, doubt)) << ended.err;
    EXPECT_TRUE(holds(read_result(directory() / "p.h5").provenance.at("doubts"), doubt));
  };
  expect_doubt(imported(lattice(0, 4, 1)),
               "volume of all particles at 0 s = 0.4 m2: expected the 0.5 m2 of the case's liquid");
  expect_doubt(imported(whole + lattice(1, 5, 0.0103), "--volume V"),
               "volume of all particles at 1 s = 0.515 m2: expected the 0.5 m2 of the first time");
  expect_doubt(imported(whole, "--x z --z x"),
               "mean height of all particles at 0 s = 0.5 m: expected half the fill depth, 0.25 m");
}

TEST_F(ForeignResults, NoImportScalesByNothingOrIsMovedByNoNumber) {
  write_gauge("a.csv", {});
  for (const char* scale : {"0", "nan", "inf", "-inf", "1e400", "two"}) {
    const Ended ended = import_gauge("a.csv", {"--scale", scale});
    EXPECT_EQ(ended.status, 2) << scale;
    EXPECT_TRUE(
        begins(ended.err,
               fmt::format("--scale: {}: expected a number other than 0, without unit\n", scale)));
  }
  const Ended moved = typed(
      "import a.csv --format dualsphysics_gauge --series elevation@right=swlz --offset nan -o "
      "a.csv.h5");
  EXPECT_EQ(moved.status, 2);
  EXPECT_TRUE(begins(moved.err, "--offset: nan: expected a number, in the quantity's SI unit\n"));
  EXPECT_FALSE(std::filesystem::exists(directory() / "a.csv.h5"));
  EXPECT_EQ(import_gauge("a.csv", {"--scale", "-2"}).status, 0);
}

TEST_F(ForeignResults, TwoAreComparedWithNoCase) {
  import_pair({.amplitude = 0.021, .lag = 0.05});
  const Ended ended = compare({"--gauge", "right", "--frequency", "0.8", "--frequency", "1.7",
                               "--window", "1", "9", "--json", "compared.json"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  for (const char* words :
       {"elevation@right of a.csv.h5 against b.csv.h5, 1 to 9 s", "normalised rms: ",
        "mean offset: ", "largest residual: ", "lag by cross-correlation: 0.0497",
        "mode forced (0.8 Hz)", "amplitude error: 5.000 ± ", "phase lag: 14.4 deg",
        "spectral peaks of the reference: 0.7999 Hz, 1.699 Hz", "Sprague and Geers"})
    EXPECT_TRUE(holds(ended.out, words));
  const auto document = nlohmann::json::parse(read("compared.json"));
  const auto& mode = document.at("comparison").at("modes").at(0);
  EXPECT_NEAR(mode.at("amplitude_error").at("value").get<double>(), 0.05, 1e-4);
  EXPECT_NEAR(mode.at("phase_lag_s").at("value").get<double>(), 0.05, 1e-4);
  EXPECT_EQ(document.at("exit_status"), 0);
}

TEST_F(ForeignResults, WithoutModesTheWholeHistoriesAreCompared) {
  import_pair({.lag = 0.05});
  const Ended ended = compare({});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(holds(ended.out, "0 to 10 s"));
  EXPECT_TRUE(holds(ended.out, "lag that fits best: 0.05"));
  const Ended anew = typed(
      "import a.csv --format dualsphysics_gauge --series elevation@right=swlz --offset 30 -o "
      "a.csv.h5");
  ASSERT_EQ(anew.status, 0) << anew.err;
  const Ended raised = compare({});
  EXPECT_TRUE(holds(raised.out, "lag that fits best: none\n"));
}

TEST_F(ForeignResults, OfOneSeriesHaveNoNegativeZero) {
  import_pair({});
  const std::vector<std::string> none, two{"--frequency", "0.8", "--frequency", "1.7"};
  for (const auto& modes : {none, two}) {
    const Ended ended = compare(modes);
    EXPECT_FALSE(holds(ended.out, " -0 "));
    EXPECT_FALSE(holds(ended.out, "(-0 "));
  }
}

// What a candidate lost is told, and judged by no curve that is made up across it.
TEST_F(ForeignResults, ADropoutOfTheCandidateIsToldAndInconclusive) {
  import_pair({});
  std::istringstream lines(read("a.csv"));
  std::string kept;
  for (std::string line; std::getline(lines, line);)
    if (!(std::atof(line.c_str()) > 4 && std::atof(line.c_str()) < 5.2)) kept += line + "\n";
  write("a.csv", kept);
  ASSERT_EQ(import_gauge("a.csv", {}).status, 0);
  const Ended ended = compare({"--limit", "normalised_rms=0.05"});
  EXPECT_EQ(ended.status, 5) << ended.out;
  EXPECT_TRUE(holds(ended.out, "not compared: the candidate has no sample between 4 and 5.2 s"));
}

TEST_F(ForeignResults, ACaseGivesTheWindowAndTheModes) {
  write("small.toml", small_case);
  import_pair({.amplitude = 0.021});
  const Ended ended = compare({"--case", "./small.toml"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_TRUE(holds(ended.out, "1 to 8 s"));
  EXPECT_TRUE(holds(ended.out, "mode natural_1 (0."));
}

TEST_F(ForeignResults, AreJudgedByLimitsAsRowsAre) {
  const std::vector<std::string> limits{
      "--frequency",          "0.8",     "--frequency", "1.7",     "--limit",
      "amplitude_error=0.02", "--limit", "phase_lag=2", "--limit", "normalised_rms=0.05"};
  EXPECT_EQ(judged({.amplitude = 0.0202}, limits), 0);
  EXPECT_EQ(judged({.amplitude = 0.021}, limits), 1);
  EXPECT_EQ(judged({.lag = 0.1}, limits), 1);
  import_pair({.amplitude = 0.021});
  const Ended ended = compare({"--limit", "normalised_rms=0.01", "--json", "c.json"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_TRUE(holds(ended.out, "violated: whole normalised_rms: 5 % is not ≤ 1 %"));
  EXPECT_EQ(nlohmann::json::parse(read("c.json")).at("gate").at(0).at("verdict"), "violated");
  // One tone alone leaves the other as a residual that widens the interval across the limit.
  EXPECT_EQ(judged({.amplitude = 0.0202},
                   {"--frequency", "0.8", "--window", "0", "3", "--limit", "amplitude_error=0.01"}),
            5);
}

TEST_F(ForeignResults, AForcedModeIsNotJudgedOnAFrequencyOrADecayThatItIsGiven) {
  write("small.toml", small_case);
  import_pair({.amplitude = 0.021});
  for (const char* metric : {"frequency_error", "decay_rate", "decay_error"}) {
    const std::string expected =
        fmt::format("expected what {} is measured on, which is natural_1", metric);
    for (const std::string mode : {"", "forced:"}) {
      const std::string limit = mode + metric + "=0.1";
      const Ended ended = compare({"--case", "./small.toml", "--limit", limit});
      EXPECT_EQ(ended.status, 2) << limit;
      const std::string start = fmt::format("slosh: --limit {}: mode {}: {}", limit,
                                            mode.empty() ? "is missing" : "= forced", expected);
      EXPECT_TRUE(begins(ended.err, start));
    }
    const Ended tone = compare({"--frequency", "0.8", "--limit", metric + std::string("=0.1")});
    EXPECT_EQ(tone.status, 2) << tone.out;
    EXPECT_TRUE(holds(tone.err, "of which there is none; --case names the natural modes"));
  }
}

TEST_F(ForeignResults, ALimitThatCannotBeViolatedIsNone) {
  import_pair({});
  for (const char* limit : {"normalised_rms=1", "normalised_rms=1e300", "forced:phase_lag=180",
                            "amplitude_error=1", "mean_offset=1e9"}) {
    const Ended ended = compare({"--frequency", "0.8", "--limit", limit});
    EXPECT_EQ(ended.status, 2) << limit;
    EXPECT_TRUE(holds(ended.err, ": expected a number > 0 and below "));
  }
  const Ended twice = compare({"--limit", "normalised_rms=0.1", "--limit", "normalised_rms=0.9"});
  EXPECT_EQ(twice.status, 2);
  EXPECT_EQ(twice.err,
            "slosh: --limit normalised_rms=0.9: metric = normalised_rms: expected each metric of a "
            "mode once\n");
}

TEST_F(ForeignResults, ACandidateThatWasCutShortIsNotJudgedOnWhatItHas) {
  import_pair({.end = 6});
  const std::vector<std::string> limit{"--limit", "normalised_rms=0.05"};
  const Ended cut = compare(limit);
  EXPECT_EQ(cut.status, 4);
  EXPECT_TRUE(holds(cut.err, "the candidate spans 0 to 6 s, the reference 0 to 10 s"));
  EXPECT_TRUE(holds(cut.err, "--window BEGIN END"));
  EXPECT_EQ(compare({"--window", "0", "6", "--limit", "normalised_rms=0.05"}).status, 0);
  import_pair({.end = 9.98});  // one sample short
  EXPECT_EQ(compare(limit).status, 0);
}

TEST_F(ForeignResults, NeverPassWhereThereIsNothingToCompare) {
  EXPECT_EQ(judged({.end = 5}, {"--window", "0", "10", "--limit", "normalised_rms=0.9"}), 4);
  EXPECT_EQ(judged({}, {"--quantity", "force_x", "--limit", "normalised_rms=0.9"}), 4);
  EXPECT_EQ(judged({}, {"--window", "20", "30", "--limit", "normalised_rms=0.9"}), 4);
  EXPECT_EQ(judged({}, {"--frequency", "0.05", "--limit", "amplitude_error=0.9"}), 4);
  EXPECT_EQ(judged({}, {"--limit", "amplitude_eror=1"}), 2);
  EXPECT_EQ(judged({}, {"--limit", "normalised_rms=-1"}), 2);
  EXPECT_EQ(judged({}, {"--limit", "normalised_rms=nan"}), 2);
  EXPECT_EQ(judged({}, {"--window", "3", "1"}), 2);
  const Ended missing = typed("compare none.h5 b.csv.h5");
  EXPECT_EQ(missing.status, 4);
  EXPECT_TRUE(holds(missing.err, "none.h5"));
}

// Ten million samples take 17 s of processor time if the memory of each array serves for the next
// one, else 26 s. The pages that the system makes are counted, which no load of the machine
// changes.
TEST_F(ForeignResults, AComparisonOfLongSeriesMakesEachPageOfItsMemoryOnce) {
  for (const char* file : {"a.csv", "b.csv"}) {
    std::string text = "t,eta\n";
    for (int i = 0; i < 200000; ++i) {
      const double time = 1e-4 * i;
      text += fmt::format("{},{}\n", time, height(time - (*file == 'a' ? 0.002 : 0)));
    }
    write(file, text);
    ASSERT_EQ(tool({"import", file, "--format", "csv", "--series", "elevation@right=eta", "--time",
                    "t", "--time-unit", "s", "--unit", "m", "-o", std::string(file) + ".h5"})
                  .status,
              0);
  }
  rusage before{}, after{};
  getrusage(RUSAGE_CHILDREN, &before);
  EXPECT_EQ(compare({"--frequency", "0.8"}).status, 0);
  getrusage(RUSAGE_CHILDREN, &after);
  const double made = static_cast<double>(after.ru_minflt - before.ru_minflt) *
                      static_cast<double>(sysconf(_SC_PAGESIZE)) / 1024;
  EXPECT_LT(made, 1.5 * static_cast<double>(after.ru_maxrss)) << "[KiB] of pages, of memory";
}

}  // namespace
}  // namespace slosh::foreign_results_test
