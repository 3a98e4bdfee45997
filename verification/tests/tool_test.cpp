// The tool as a user sees it: exit statuses, messages and files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "verification/results/result_file.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::tool_test {
namespace {

namespace fs = std::filesystem;

class Tool : public SmallCampaign {};

std::vector<fs::path> half_written_files(const fs::path& directory) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    for (const char* mark : {".partial", ".tmp", ".writing-"})
      if (name.find(mark) != std::string::npos) found.push_back(entry.path());
  }
  return found;
}

TEST_F(Tool, PassesACampaignAndComputesNothingTwice) {
  const bool mesh = has_interfoam();
  write_campaign(particles_case + (mesh ? mesh_run + gate_on("mesh") : ""));
  const Ended first = campaign();
  EXPECT_EQ(first.status, 0) << first.err << first.out;
  EXPECT_TRUE(holds(first.out, mesh ? "2 of 2 gate rows hold." : "1 of 1 gate rows"));
  EXPECT_TRUE(holds(first.out, "\nThe results of the campaign cost "));
  EXPECT_TRUE(holds(first.out, "report: " + (report() / "index.html").string()));
  EXPECT_TRUE(holds(first.err, "finished small/particles"));
  EXPECT_EQ((first.out + first.err).find('\033'), std::string::npos) << "an escape code";
  for (const char* file : {"index.html", "results.json", "figures"})
    EXPECT_TRUE(fs::exists(report() / file)) << file;
  EXPECT_TRUE(half_written_files(directory()).empty());

  const auto written = fs::last_write_time(result("particles"));
  const Ended second = campaign();
  EXPECT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(second.err, "") << "a run was started";
  EXPECT_EQ(fs::last_write_time(result("particles")), written);
  EXPECT_EQ(second.out, first.out);
}

TEST_F(Tool, EndsWithOneWhereALimitIsViolated) {
  write_campaign(with(particles_case, "limit = 0.3", "lower = 0.5\nupper = 0.6"));
  const Ended run = campaign();
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_TRUE(holds(run.out, "violated       small particles forced amplitude_error"));
  EXPECT_TRUE(holds(run.out, "0 of 1 gate rows hold, 1 violated."));
  EXPECT_TRUE(holds(read(report() / "results.json"), "\"exit_status\": 1"));
}

TEST_F(Tool, EndsWithFourWhereNothingWasCompared) {
  write_campaign(particles_case);
  const Ended run = typed("campaign ./surges.toml --quick --output out");
  EXPECT_EQ(run.status, 4) << run.err;
  EXPECT_TRUE(holds(run.out, "0 of 0 gate rows hold, 1 not selected."));
  EXPECT_FALSE(fs::exists(result("particles")));
}

TEST_F(Tool, JudgesTheQuickFormByItsRepeatsAlone) {
  const std::string repeated =
      with(particles_case, "particle_spacing_m = 0.025",
           "particle_spacing_m = 0.025\nstart_disorder = 1e-6\nrepeats = 3\nquick_repeats = 2\n"
           "quick = true");
  write_campaign(repeated);
  const Ended run = typed("campaign ./surges.toml --quick --output out");
  EXPECT_EQ(run.status, 0) << run.err << run.out;
  EXPECT_TRUE(holds(run.out, "1 of 1 gate rows hold."));
  EXPECT_TRUE(holds(run.out, "mean over 2 x 1 repeats"));
  EXPECT_TRUE(fs::exists(result("particles_2")));
  EXPECT_FALSE(fs::exists(result("particles_3")));
}

// Nothing failed where a reference is out of its range: every output has the one word for that.
TEST_F(Tool, SaysNotComparedInAllOutputsWhereAReferenceIsOutOfItsRange) {
  write_campaign(with(particles_case, "valid_elevation_over_depth = 0.2",
                      "valid_elevation_over_depth = 0.0001"));
  const Ended run = campaign();
  EXPECT_EQ(run.status, 4) << run.err;
  EXPECT_TRUE(holds(run.out, "0 of 1 gate rows hold, 1 not compared"));
  const Ended gate = typed("gate ./surges.toml --output out");
  EXPECT_EQ(gate.status, 4) << gate.err;
  EXPECT_TRUE(holds(gate.out, "\nNOT COMPARED: "));
  EXPECT_TRUE(holds(read("out/report/index.html"), "</span> Not compared</strong>"));
  EXPECT_TRUE(
      holds(read("out/report/index.html"), "Decided by <a href=\"small.html#row-small-1\">"));
  EXPECT_TRUE(holds(read("out/report/results.json"), "\"verdict\": \"not compared\""));
  EXPECT_TRUE(holds(read("out/gate/gate.md"),
                    "NOT COMPARED: SPH at 25 mm against linear theory: particles, forced "));
  EXPECT_TRUE(holds(read("out/gate/gate.md"), "| **not compared** | validation | small |"));
  EXPECT_TRUE(holds(read("out/gate/junit.xml"), "type=\"not compared\""));
  for (const std::string& text : {run.out, gate.out, report_words(), read("out/gate/gate.md")})
    EXPECT_EQ(text.find("FAIL"), std::string::npos) << text;
}

TEST_F(Tool, EndsWithTwoAndAMessageWhereTheCommandLineIsWrong) {
  write_campaign(particles_case + mesh_run);
  for (const auto& [line, said] : std::vector<std::pair<std::string, std::string>>{
           {"campain", "campain"},
           {"campaign", "name is required"},
           {"campaign ./surges.toml --fast", "--fast"},
           {"campaign ./surges.toml -j 0", "--jobs: 0: expected an integer >= 1\n"},
           {"campaign ./surges.toml -j -3", "--jobs: -3: expected an integer >= 1\n"},
           {"campaign ./surges.toml -j 1.5", "--jobs: 1.5: expected an integer >= 1\n"},
           {"campaign ./surges.toml -j many", "--jobs: many: expected an integer >= 1\n"},
           {"campaign ./surges.toml --timings -1", "--timings: -1: expected an integer >= 0\n"},
           {"campaign ./surges.toml --inconclusive-exit 300",
            "--inconclusive-exit: 300: expected an integer from 0 to 125\n"},
           {"campaign verification --launcher slrum",
            "--launcher: slrum: expected an engine, one of ninja, slurm; nearest: slurm"},
           {"campaign smal_amplitude", "small_amplitude"},
           {"run ./small.toml", "run"},
           {"run li2010_smal_amplitude linear", "li2010_small_amplitude"},
           {"run li2010_small_amplitude liner", "run = liner: expected one of linear, "},
           {"run ./small.toml theory --snapshots -1", "--snapshots"},
           {"run ./small.toml particles --snapshots nan",
            "--snapshots: nan: expected a number > 0, in s\n"},
           {"run ./small.toml theory --snapshots 2",
            "small.toml:32: run theory: snapshots: expected a run of the solver sph"},
           {"run ./small.toml mesh --snapshots 2",
            "small.toml:53: run mesh: snapshots: expected a run of the solver sph"},
           {"run ./small.toml particles --snapshots 0.015",
            "small.toml:38: run particles: snapshot interval = 0.015 s: expected a multiple of the "
            "sample interval of 0.01 s"}}) {
    const Ended run = typed(line);
    EXPECT_EQ(run.status, 2) << line;
    EXPECT_TRUE(holds(run.err, said)) << line;
  }
  for (const char* run : {"theory", "mesh", "particles"})
    EXPECT_FALSE(fs::exists(directory() / (run + std::string(".h5"))));
}

TEST_F(Tool, RefusesWrongCaseFilesWithTheirLinesBeforeAnythingRuns) {
  const std::string twice = with(particles_run, "recommended", "recomended");
  const std::vector<std::pair<std::string, std::vector<const char*>>> wrong_cases{
      {with(with(particles_case, "window_end_s = 8.0", "window_end_s = 9.0"),
            "particle_spacing_m = 0.025", "particle_spacing_m = -1"),
       {"small.toml:30: comparison.window_end_s = 9.0: expected a",
        "small.toml:42: run.particle_spacing_m = -1: expected a"}},
      {small_case + twice + with(twice, "\"particles\"", "\"again\""),
       {"small.toml:38: run particles: scheme = \"recomended\": expected one of ",
        "small.toml:43: run again: "}},
      {with(particles_case, "0.025\n", "0.11\n"),
       {"small.toml:38: run particles: particle_spacing = 0.11 m: expected a whole number"}},
      {with(particles_case, "0.025\n", "0.025\nsurface_particle_spacing_m = 0.0125\n"),
       {"small.toml:38: run particles: scheme recommended takes one"}},
      {with(particles_case, "window_begin_s = 1.0", "window_begin_s = 7.0"),
       {"small.toml: comparison: the window of "}}};
  const auto refuse = [&](const std::vector<const char*>& messages) {
    const Ended run = campaign();
    EXPECT_EQ(run.status, 2);
    for (const char* message : messages) EXPECT_TRUE(holds(run.err, message));
    EXPECT_FALSE(fs::exists(directory() / "out"));
  };
  for (const auto& [text, messages] : wrong_cases) {
    write_campaign(text);
    refuse(messages);
  }
  write_campaign(particles_case);
  write("twin.toml", particles_case);
  write("surges.toml",
        with(read("surges.toml"), "[\"./small.toml\"]", "[\"./small.toml\", \"./twin.toml\"]"));
  refuse({"twin.toml: name = \"small\": expected a name other than that of "});
}

TEST_F(Tool, WritesACaseToEditInWhichNothingIsWrong) {
  ASSERT_EQ(typed("new my_tank --like li2010_small_amplitude -o tank.toml").status, 0);
  const std::string text = read("tank.toml");
  EXPECT_TRUE(holds(text, "name = \"my_tank\"\n"));
  const Ended checked = typed("explain ./tank.toml");
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_TRUE(holds(checked.out, "\nmy_tank: nothing is wrong or doubtful\n"));
  const Ended again = typed("new my_tank --like still_water -o tank.toml");
  EXPECT_EQ(again.status, 2);
  EXPECT_TRUE(holds(again.err, "tank.toml: expected a file that is not there yet"));
  EXPECT_EQ(read("tank.toml"), text);
  const Ended wrong = tool({"new", "my tank", "--like", "still_water", "-o", "other.toml"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_TRUE(holds(wrong.err, "name = \"my tank\": expected a name of letters"));
}

TEST_F(Tool, ChecksACaseForWhatIsWrongAndThenForWhatIsDoubtful) {
  write_campaign(with(with(particles_case, "length_m = 1.0", "length_m = -1.0"),
                      "sample_interval_s = 0.01", "sample_interval_s = 10"));
  const Ended wrong = typed("explain ./small.toml");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_TRUE(holds(wrong.err, "small.toml:8: tank.length_m = -1.0: expected "));
  EXPECT_TRUE(holds(wrong.err, "time.sample_interval_s = 10: expected "));
  write_campaign(
      with(with(particles_case, "particle_spacing_m = 0.025", "particle_spacing_m = 0.02"),
           "valid_elevation_over_depth = 0.2", "valid_elevation_over_depth = 0.001"));
  const Ended doubtful = typed("explain ./small.toml");
  EXPECT_EQ(doubtful.status, 0);
  EXPECT_TRUE(holds(doubtful.out, "\nsmall: nothing is wrong\ndoubtful: run particles: "));
  EXPECT_TRUE(holds(doubtful.out, "the nearest that does is 0.0166667\n"));
  EXPECT_TRUE(holds(doubtful.out, "\ndoubtful: run theory: outside its range"));
  EXPECT_TRUE(files_of_store(".h5").empty()) << "nothing is left by a check";
}

TEST_F(Tool, WritesAMinimalCaseThatPassesByItself) {
  ASSERT_EQ(typed("new my_tank --minimal").status, 0);
  const std::string text = read("my_tank.toml");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 25);
  EXPECT_TRUE(holds(typed("explain ./my_tank.toml").out, ": nothing is wrong or doubtful\n"));
  const Ended run = typed("campaign ./my_tank.toml -o out");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(holds(run.out, "\nPASS: SPH at 20 mm against linear theory: amplitude "));
  EXPECT_TRUE(holds(
      run.out, "Rows: 1 against exact solutions, 0 own tolerances, 0 regression, 0 experiments."));
  EXPECT_EQ(typed("gate ./my_tank.toml -o out").status, 0);
  EXPECT_TRUE(holds(read("out/gate/gate.md"), "| my\\_tank | SPH at 20 mm | linear theory |"));
  EXPECT_EQ(typed("new my_tank").status, 2) << "neither --like nor --minimal";
}

// The candidate's own metrics take any name of a series, which no run may have.
TEST_F(Tool, RefusesAQuantityThatNoRunOfARowWillHaveBeforeAnythingRuns) {
  const auto row_on = [](const char* quantity, const char* unit) {
    return fmt::format(
        "[[gate]]\ncandidate = \"particles\"\nquantity = \"{}\"\nmetric = \"largest_magnitude\"\n"
        "unit = \"{}\"\nlimit = 6e4\nreason = \"a reason\"\nsource = \"a source\"\n",
        quantity, unit);
  };
  for (const auto& [quantity, unit] :
       {std::pair{"force_x@front", "N/m"}, {"liquid_volume", "m2"}, {"elevation@rigth", "N"}}) {
    write_campaign(particles_case + row_on(quantity, unit));
    for (const char* command : {"explain ./small.toml", "campaign ./surges.toml --output out"}) {
      const Ended refused = typed(command);
      EXPECT_EQ(refused.status, 2) << command;
      EXPECT_TRUE(holds(refused.err, fmt::format("quantity = \"{}\": expected one that the run "
                                                 "particles has, of elevation@right, ",
                                                 quantity)));
    }
  }
  EXPECT_FALSE(fs::exists(directory() / "out"));
  write_campaign(particles_case + row_on("mach_number", "1"));
  EXPECT_EQ(typed("explain ./small.toml").status, 0);
}

TEST_F(Tool, SaysAllBrokenLimitsOfATheoryAndWhatHelpsAShortWindow) {
  write_campaign(with(with(particles_case, "amplitude_m = 0.02", "amplitude_m = 0.2"),
                      "angular_frequency_rad_s = 3.0", "angular_frequency_rad_s = 4.9"));
  write("small.toml", with(read("small.toml"), "natural_modes = 1", "natural_modes = 0"));
  const Ended doubtful = typed("explain ./small.toml");
  for (const char* limit : {"it predicts an elevation of", "; it predicts a steepness k A of",
                            "; it is forced at 0.987 times its natural mode 1"})
    EXPECT_TRUE(holds(doubtful.out, limit));
  write_campaign(with(particles_case, "window_end_s = 8.0", "window_end_s = 3.5"));
  const Ended refused = typed("explain ./small.toml");
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(
      holds(refused.err, "; or natural_modes = 0 in [comparison], which fits no natural mode"));
}

TEST_F(Tool, ComparesAPlainTableWithTheTheoryThatItComputesItself) {
  write_campaign(particles_case);
  ASSERT_EQ(run("theory", {"-o", "theory.h5"}).status, 0);
  ASSERT_EQ(typed("export theory.h5 -o theory.csv").status, 0);
  const Ended same =
      typed("compare theory.csv --case ./small.toml --gauge right --limit amplitude_error=0.001");
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_TRUE(holds(same.out, "elevation@right of theory.csv against theory, 1 to 8 s"));
  RunResult fast = read_result(directory() / "theory.h5");
  fast.series.push_back({"mach_number", "1", {0, 4, 8}, {0.5, 0.5, 0.5}});
  write_result(fast, directory() / "fast.h5");
  const Ended unsound = typed(
      "compare fast.h5 theory.h5 --case ./small.toml --gauge right --limit amplitude_error=0.001 "
      "--json fast.json");
  EXPECT_EQ(unsound.status, 5) << unsound.out;
  const std::string doubt = "the candidate is not sound: its Mach number but for 5 % of the time";
  EXPECT_TRUE(holds(unsound.out, "doubtful: " + doubt)) << unsound.out;
  EXPECT_TRUE(holds(read("fast.json"), doubt));
  std::string high = "time [ms],mine [mm]\n";  // by a tenth, in units of its own
  std::istringstream rows(read("theory.csv"));
  std::string row;
  std::getline(rows, row);
  while (std::getline(rows, row))
    high += fmt::format("{:.12g},{:.12g}\n", 1e3 * std::stod(row),
                        1.1e3 * std::stod(row.substr(row.find(',') + 1)));
  write("mine.csv", high);
  const Ended wrong = typed("compare mine.csv --case ./small.toml --limit amplitude_error=0.05");
  EXPECT_EQ(wrong.status, 1) << wrong.err;
  EXPECT_TRUE(holds(wrong.out, "amplitude error: 10 "));
  write("untimed.csv", "x,mine\n0,1\n1,2\n2,3\n3,4\n");
  EXPECT_TRUE(holds(typed("compare untimed.csv --case ./small.toml").err,
                    "untimed.csv:1: columns = x,mine: expected the column of times, t or time"));
  EXPECT_TRUE(
      holds(typed("compare theory.h5").err, "reference is missing: expected a result file"));
  // As a stored run it needs its file and nothing else.
  write("small.toml", small_case +
                          "[[run]]\nname = \"mine\"\nsolver = \"stored\"\nfile = \"mine.csv\"\n" +
                          with(own_row("amplitude_error", "0.05"), "limit = 0.05", "limit = 0.2"));
  const Ended stored = typed("campaign ./small.toml -o out");
  EXPECT_EQ(stored.status, 0) << stored.err;
  EXPECT_TRUE(holds(stored.out, "PASS: mine against linear theory: amplitude 10.0"));
  write("small.toml", with(read("small.toml"), "\"mine.csv\"", "\"mine.csv\"\nmethod = \"m\""));
  EXPECT_TRUE(holds(typed("explain ./small.toml").err, "run.particle_spacing_m is missing"));
}

TEST_F(Tool, NeverPassesATruncatedResultAndComputesItAgain) {
  write_campaign(particles_case);
  ASSERT_EQ(campaign().status, 0);
  fs::resize_file(result("particles"), fs::file_size(result("particles")) / 2);
  const Ended report = typed("campaign --report-only ./surges.toml --output out");
  EXPECT_EQ(report.status, 4);
  EXPECT_TRUE(holds(report.err, fs::read_symlink(result("particles")).string()));
  EXPECT_TRUE(holds(report.out, "0 of 1 gate rows hold, 1 not compared"));
  const Ended again = campaign();
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_TRUE(holds(again.err, "it is computed again"));
  EXPECT_NO_THROW(read_result(result("particles")));
}

TEST_F(Tool, ReportsOnlyResultsOfTheCaseAsItIsNow) {
  write_campaign(particles_case);
  ASSERT_EQ(campaign().status, 0);
  write_campaign(with(particles_case, "gravity_m_s2 = 9.81", "gravity_m_s2 = 9.8"));
  const Ended stale = typed("campaign --report-only ./surges.toml --output out");
  EXPECT_EQ(stale.status, 4);
  EXPECT_TRUE(holds(stale.err, "none was made, or for another state of the case file"));
  write_campaign(with(particles_case, "limit = 0.3", "limit = 0.29"));
  const Ended regated = typed("campaign --report-only ./surges.toml --output out");
  EXPECT_EQ(regated.status, 0) << regated.err;
  EXPECT_EQ(typed("campaign --report-only ./surges.toml --output elsewhere").status, 0)
      << "the store is the same";
  EXPECT_EQ(typed("campaign --report-only ./surges.toml --output out --store elsewhere").status, 4);
}

TEST_F(Tool, TellsTheGateEvenWhereTheReportCannotBeDrawn) {
  write_campaign(particles_case);
  ASSERT_EQ(campaign().status, 0);
  fs::remove_all(report());
  const Ended run = typed("campaign ./surges.toml --output out", {{"PATH", "/nowhere"}});
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(holds(run.err, "gnuplot"));
  EXPECT_TRUE(holds(run.out, "pass           small particles"));
  EXPECT_FALSE(fs::exists(report()));
}

TEST_F(Tool, GatesAChangeAgainstItsBaseline) {
  write_campaign(particles_case);
  ASSERT_EQ(campaign().status, 0);
  const std::vector<std::string> of_campaign =
      words_of("./surges.toml --output out --ledger ledger.jsonl");
  const auto run = [&](std::vector<std::string> command, std::vector<std::string> more = {}) {
    command.insert(command.end(), of_campaign.begin(), of_campaign.end());
    command.insert(command.end(), more.begin(), more.end());
    return tool(command);
  };
  const std::vector<std::string> by_tester{"--who", "a tester", "--reason", "first", "--new"};
  EXPECT_EQ(run({"baseline", "diff"}, {"--new"}).status, 1);
  EXPECT_EQ(run({"baseline", "approve"}, by_tester).status, 4);
  EXPECT_FALSE(fs::exists(directory() / "ledger.jsonl"));
  ASSERT_EQ(run({"baseline", "propose"}, {"--new"}).status, 0);
  ASSERT_EQ(run({"baseline", "approve"}, by_tester).status, 0);
  EXPECT_EQ(run({"baseline", "approve"}, by_tester).status, 2) << "it is not new any more";
  EXPECT_EQ(run({"baseline", "diff"}).status, 0);
  EXPECT_EQ(run({"baseline", "approve"}, {"--who", "", "--reason", "none"}).status, 2);

  write_campaign(with(particles_case, "limit = 0.3", "limit = 0.4"));
  const Ended loosened = run({"gate"});
  EXPECT_EQ(loosened.status, 0) << loosened.err;
  EXPECT_TRUE(holds(loosened.out, "tolerance loosened: -30 % .. +30 % -> -40 % .. +40 %"));
  EXPECT_TRUE(holds(read("out/gate/gate.md"), "tolerance loosened"));
  EXPECT_TRUE(holds(read("out/gate/junit.xml"), "tests=\"1\""));
  write_campaign(with(particles_case, "limit = 0.3", "limit = 0.0001"));
  const Ended violated = run({"gate"});
  EXPECT_NE(violated.status, 0);
  EXPECT_TRUE(holds(read("out/gate/junit.xml"), "<failure"));
}

TEST_F(Tool, RefusesALedgerThatIsNotThereAndSaysWhereItComparesWithNone) {
  write_campaign(particles_case);
  ASSERT_EQ(campaign().status, 0);
  write("empty.jsonl", "");
  for (const char* ledger : {"mistyped.jsonl", "empty.jsonl", ".", ""}) {
    for (const auto& command : std::vector<std::vector<std::string>>{
             {"gate"}, {"baseline", "diff"}, {"baseline", "propose"}}) {
      std::vector<std::string> words = command;
      words.insert(words.end(), {"./surges.toml", "--output", "out", "--ledger", ledger});
      const Ended ended = tool(words);
      EXPECT_EQ(ended.status, 2) << command.back() << " " << ledger << ended.out;
      EXPECT_TRUE(holds(ended.err, "--ledger")) << ended.err;
    }
  }
  const Ended without = typed("gate ./surges.toml --output out");
  EXPECT_EQ(without.status, 0) << without.err;
  EXPECT_TRUE(holds(without.out, "no baseline    ")) << without.out;
  const Ended diff = typed("baseline diff ./surges.toml --output out");
  EXPECT_EQ(diff.status, 2);
  EXPECT_TRUE(holds(diff.err, "--new to begin it")) << diff.err;
}

TEST_F(Tool, GatesNothingOnALedgerWhoseLastLineIsForged) {
  write_campaign(particles_case);
  ASSERT_EQ(campaign().status, 0);
  const std::vector<std::string> place = words_of("./surges.toml --output out --ledger a.jsonl");
  const auto run = [&](std::vector<std::string> words) {
    words.insert(words.end(), place.begin(), place.end());
    return tool(words);
  };
  ASSERT_EQ(run({"baseline", "propose", "--new"}).status, 0);
  ASSERT_EQ(run({"baseline", "approve", "--new", "--who", "a tester", "--reason", "first"}).status,
            0);
  write("a.jsonl", with(read("a.jsonl"), "\"upper\":0.3", "\"upper\":0.9"));
  const Ended forged = run({"gate"});
  EXPECT_EQ(forged.status, 4) << forged.out;
  EXPECT_TRUE(holds(forged.err, "altered, added or removed by hand")) << forged.err;
}

TEST_F(Tool, TestsWhatItsOwnGateDetects) {
  write_campaign(particles_case);
  EXPECT_EQ(typed("gate --selftest ./surges.toml --output out").status, 4);
  ASSERT_EQ(campaign().status, 0);
  const Ended wide = typed("gate --selftest ./surges.toml --output out");
  EXPECT_EQ(wide.status, 1) << wide.out << wide.err;
  EXPECT_TRUE(holds(wide.out, "0 of NaN or a truncated series were let pass"));
  EXPECT_TRUE(holds(wide.out, "amplitude: MISSED")) << wide.out;
  EXPECT_TRUE(holds(wide.out, "truncation: detected")) << wide.out;
  EXPECT_EQ(typed("gate --selftest ./surges.toml --output out --only small").status, 0)
      << "a part need not be complete";
  EXPECT_EQ(typed("gate --selftest ./surges.toml --output out --only small --record").status, 2);
}

// A record of the elevation that the user supplies: theory's own, read back from a table.
const std::string experiment_run = R"([[run]]
name = "probe"
solver = "record"
experiment = "tests/probe.csv"
time_column = "t_s"
value_column = "eta"
quantity = "elevation@right"
unit = "m"
[[gate]]
candidate = "particles"
reference = "probe"
quantity = "elevation@right"
mode = "whole"
metric = "normalised_rms"
kind = "regression"
unit = "1"
limit = 0.5
reason = "The runs are coarse."
source = "made for a test"
)";

TEST_F(Tool, TellsOfARecordThatIsNotSuppliedAndTakesItWhereItIs) {
  write_campaign(particles_case + experiment_run);
  const Ended without = campaign();
  EXPECT_EQ(without.status, 0) << without.err;
  EXPECT_TRUE(holds(without.err,
                    "small/probe: not supplied: expected "
                    "SLOSH_EXPERIMENTS/tests/probe.csv, below the directory of "
                    "--experiments or SLOSH_EXPERIMENTS; where to get the original: "
                    "made for a test"));
  EXPECT_TRUE(holds(without.out, "not supplied   small particles whole normalised_rms"));
  EXPECT_TRUE(holds(without.out,
                    "1 of 1 gate rows hold, 1 record not supplied, 1 gate row "
                    "without its record."));
  const Ended refused = typed("run ./small.toml probe");
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(holds(refused.err, "run probe: expected SLOSH_EXPERIMENTS/tests/probe.csv"));

  ASSERT_EQ(typed("run ./small.toml theory").status, 0);
  const TimeSeries theory = read_result(directory() / "theory.h5").at("elevation@right");
  std::ostringstream csv;
  csv << "t_s,eta\n";
  for (std::size_t i = 0; i < theory.time.size(); i += 5)
    csv << theory.time[i] << "," << theory.value[i] << "\n";
  fs::create_directories(directory() / "records/tests");
  write("records/tests/probe.csv", csv.str());
  const Ended with_variable = typed("campaign ./surges.toml --output out",
                                    {{"SLOSH_EXPERIMENTS", (directory() / "records").string()}});
  EXPECT_EQ(with_variable.status, 0) << with_variable.err;
  EXPECT_TRUE(holds(with_variable.out, "2 of 2 gate rows hold."));
  const Ended with_option =
      typed("campaign --report-only ./surges.toml --output out --experiments records",
            {{"SLOSH_EXPERIMENTS", directory().string()}});
  EXPECT_TRUE(holds(with_option.out, "2 of 2 gate rows hold."));
  EXPECT_TRUE(holds(read(report() / "index.html"), "--experiments"));
  EXPECT_EQ(read_result(result("probe")).provenance.at("command"),
            "./slosh run '" + (directory() / "small.toml").string() +
                "' probe --output probe.h5 --experiments '" + (directory() / "records").string() +
                "'");
  const Ended again = campaign();
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_TRUE(holds(again.out, "1 record not supplied")) << "a record of earlier was taken";
}

TEST_F(Tool, RefusesADirectoryOfRecordsOrARecordThatIsNotWhatItShouldBe) {
  write_campaign(particles_case + experiment_run);
  const Ended nowhere = typed("campaign ./surges.toml --output out --experiments nowhere");
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_TRUE(holds(nowhere.err, "nowhere"));
  fs::create_directories(directory() / "records/tests");
  write("records/tests/probe.csv", "t_s,eta\n0,0\n1,none\n");
  const Ended malformed = typed("campaign ./surges.toml --output out --experiments records");
  EXPECT_EQ(malformed.status, 2);
  EXPECT_TRUE(holds(malformed.err, "tests/probe.csv:3: eta = none: expected a number, in m"));
}

// The surface breaks before the end of the case: what is left of the series is no whole run.
TEST_F(Tool, EndsWithFourWherePotentialFlowLeavesItsRange) {
  const std::string violent = with(small_case, "amplitude_m = 0.02", "amplitude_m = 0.5");
  write("small.toml", violent +
                          "[[run]]\nname = \"waves\"\nsolver = \"potential\"\n"
                          "nodes_x = 32\nnodes_z = 16\nquick = true\n");
  const Ended ended = typed("run ./small.toml waves");
  EXPECT_EQ(ended.status, 4) << ended.err;
  EXPECT_TRUE(holds(ended.err, "the run waves leaves its range at "));
  EXPECT_TRUE(holds(ended.err, " s of 8 s: "));
  const RunResult result = read_result(directory() / "waves.h5");
  EXPECT_LT(result.at("elevation@right").time.back(), 8);
  EXPECT_EQ(result.at("elevation@right").time, result.at("elevation@right/coarser").time);
}

TEST_F(Tool, LeavesSnapshotsForParaView) {
  write_campaign(particles_case);
  const Ended run = typed("run ./small.toml particles --snapshots 2");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(holds(run.out, "result: particles.h5"));
  EXPECT_TRUE(holds(run.out, "snapshots: particles.work/particles.snapshots.xmf\n"));
  EXPECT_NO_THROW(read_result(directory() / "particles.h5"));
  const fs::path work = directory() / "particles.work";
  EXPECT_GT(fs::file_size(work / "particles.snapshots.h5"), 10000u);
  EXPECT_TRUE(
      holds(read(work / "particles.snapshots.xmf"), "particles.snapshots.h5:/snapshot_00004"));
}

TEST_F(Tool, EndsInterFoamAtItsTimeLimit) {
  write_campaign(particles_case + with(mesh_run, "cells_x = 20", "cells_x = 200"));
  const Ended refused = typed("run ./small.toml particles --time-limit 60");
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(holds(refused.err, "time limit: expected a run of the solver interfoam"));
  if (!has_interfoam()) GTEST_SKIP() << "interFoam is not installed";
  const Ended ended = typed("run ./small.toml mesh --time-limit 0.5");
  EXPECT_EQ(ended.status, 3);
  EXPECT_TRUE(holds(ended.err, "interFoam: ended at its time limit of 0.5 s"));
  EXPECT_TRUE(holds(ended.err, "log.interFoam"));
  EXPECT_TRUE(fs::exists(directory() / "mesh.work/mesh.openfoam/log.interFoam"));
}

// Programs that stand in for OpenFOAM's: what theirs say of an error reaches the terminal, the
// report and its data whole.
TEST_F(Tool, TellsAnErrorOfOpenFoamInItsOwnWords) {
  fs::create_directory(directory() / "bin");
  write("bin/interFoam", "#!/bin/sh\necho 'Using: OpenFOAM- (1912) - visit www.openfoam.com'\n");
  write("bin/blockMesh",
        "#!/bin/sh\nprintf '%s\\n' '--> FOAM FATAL ERROR :' '    Unknown word Eular' '' "
        "'    Valid words are:' 12 13 14 15 16 17 18 19 20 Euler '    at line 6.'\nexit 1\n");
  for (const char* program : {"bin/interFoam", "bin/blockMesh"})
    fs::permissions(directory() / program, fs::perms::owner_all);
  write_campaign(mesh_case);
  const Ended run =
      typed("campaign ./surges.toml --output out",
            {{"PATH", (directory() / "bin").string() + ":" + std::string(std::getenv("PATH"))}});
  EXPECT_EQ(run.status, 3) << run.err;
  const std::string page = report_words(), data = read("out/report/results.json");
  for (const char* words : {"FOAM FATAL ERROR", "Unknown word Eular", "Euler", "at line 6."}) {
    EXPECT_TRUE(holds(run.err, words));
    EXPECT_TRUE(holds(page, words));
    EXPECT_TRUE(holds(data, words));
  }
  EXPECT_TRUE(holds(run.err, "log.blockMesh"));
  EXPECT_TRUE(holds(data, "log.blockMesh"));
}

TEST_F(Tool, ListsTheCasesWithTheirTags) {
  EXPECT_TRUE(holds(typed("list").out,
                    "  li2010_small_amplitude               Small-amplitude surge, set off from "
                    "rest in the frame of the earth [surge, small_amplitude, li2010]\n"
                    "      linear\n"));
}

TEST_F(Tool, RecordsTheCommandThatRepeatsARun) {
  write_campaign(particles_case);
  ASSERT_EQ(typed("run ./small.toml theory").status, 0);
  EXPECT_EQ(
      read_result(directory() / "theory.h5").provenance.at("command"),
      "./slosh run '" + (directory() / "small.toml").string() + "' theory --output theory.h5");
}

TEST_F(Tool, ColoursATerminalUnlessToldNotTo) {
  const std::string script = boost::process::search_path("script").string();
  if (script.empty()) GTEST_SKIP() << "script is not installed";
  write_campaign(particles_case);
  const auto on_terminal = [&](const std::string& output, const std::string& no_color) {
    const std::string command =
        "'" SLOSH_TOOL "' campaign ./surges.toml --output " + output + " --store " + output;
    return end_of(
        start(script, {"-qec", command, "/dev/null"}, {{"TERM", "xterm"}, {"NO_COLOR", no_color}}));
  };
  const Ended coloured = on_terminal("out", "");
  EXPECT_EQ(coloured.status, 0);
  EXPECT_TRUE(holds(coloured.out, "\033[32mfinished"));
  EXPECT_TRUE(holds(coloured.out, "\033[1A"));
  const Ended plain = on_terminal("out2", "1");
  EXPECT_TRUE(holds(plain.out, "\033[1A"));
  EXPECT_EQ(plain.out.find("\033[32m"), std::string::npos);
}

}  // namespace
}  // namespace slosh::tool_test
