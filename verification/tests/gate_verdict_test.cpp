// What a verdict rests on: a failure that was recorded, the results of the right keys, rows that
// the baseline knows. Each test does what somebody might, by mistake or on purpose, to pass a gate.
#include <signal.h>
#include <unistd.h>

#include <fstream>

#include "verification/results/result_file.hpp"
#include "verification/tests/comes_true.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::gate_verdict_test {
namespace {

namespace fs = std::filesystem;

const std::string own_run = R"([[run]]
name = "mine"
solver = "external"
command = ["./solve", "{case_file}", "{work_directory}/wave.csv", "scaled", "1.01"]
)" + wave_series;

const std::string own_case =
    small_case + own_run + own_row("amplitude_error", "0.05") + own_row("phase_lag", "5.0");

class GateVerdict : public SmallCampaign {
 protected:
  GateVerdict() {
    write_program(std::string("exec \"") + STAND_IN_SOLVER + "\" \"$@\"\n");
    write_campaign(own_case);
  }
  void write_program(const std::string& script) const {
    write("solve", "#!/bin/sh\n" + script);
    fs::permissions(directory() / "solve", fs::perms::owner_all);
  }
  Ended on_ledger(std::vector<std::string> command, std::vector<std::string> more = {}) const {
    command.insert(command.end(), {"./surges.toml", "-o", "out", "--ledger", "ledger.jsonl"});
    command.insert(command.end(), more.begin(), more.end());
    return tool(command);
  }
  Ended gate(std::vector<std::string> more = {}) const { return on_ledger({"gate"}, more); }
  Ended report() const { return tool({"campaign", "--report-only", "./surges.toml", "-o", "out"}); }
  void approve(const std::vector<std::string>& more = {}) const {
    EXPECT_EQ(on_ledger({"baseline", "propose"}, more).status, 0);
    std::vector<std::string> by{"--who", "a tester", "--reason", "a test"};
    by.insert(by.end(), more.begin(), more.end());
    const Ended approved = on_ledger({"baseline", "approve"}, by);
    EXPECT_EQ(approved.status, 0) << approved.err;
  }
  std::string gate_md() const { return read("out/gate/gate.md"); }
  std::string junit() const { return read("out/gate/junit.xml"); }
  // Copies the result of theory, higher by a factor and sealed anew, to a file of the directory.
  void forge_theory(const std::string& file, double factor) const {
    RunResult forged = read_result(result("theory"));
    for (TimeSeries& series : forged.series)
      for (double& value : series.value) value *= factor;
    write_result(forged, directory() / file);
  }
};

TEST_F(GateVerdict, OfARecordedFailureOutranksAllOlderResults) {
  ASSERT_EQ(campaign().status, 0);
  approve({"--new"});
  write_program("exit 1\n");
  EXPECT_EQ(gate().status, 3);
  EXPECT_FALSE(fs::is_symlink(result("mine"))) << "it leads to a result of the program as it was";
  EXPECT_TRUE(fs::is_symlink(result("theory")));
  EXPECT_EQ(report().status, 3) << "the failure is recorded";
  EXPECT_EQ(tool({"gate", "./surges.toml", "-o", "out", "--ledger", "ledger.jsonl"}).status, 3);
  EXPECT_TRUE(holds(on_ledger({"baseline", "diff"}).out, "no value any more"));
  EXPECT_TRUE(holds(on_ledger({"baseline", "propose"}).out, "nothing to propose"));
  const Ended shown = tool({"show", "./small.toml", "-o", "picture.svg"});
  EXPECT_TRUE(holds(shown.err, "mine is not there: solver failed"));
}

TEST_F(GateVerdict, OfAFailureOutsideACampaignOutranksAllOlderResultsToo) {
  ASSERT_EQ(campaign().status, 0);
  write_program("exit 1\n");
  EXPECT_EQ(run("mine").status, 3);
  EXPECT_EQ(report().status, 3);
  EXPECT_FALSE(fs::is_symlink(result("mine")));
}

TEST_F(GateVerdict, OfAFailureKeepsTheLinkAndTheFileThatAUserLaidAtItsPlace) {
  ASSERT_EQ(campaign().status, 0);
  write_program("exit 1\n");
  fs::remove(result("mine"));
  fs::create_symlink(result("theory"), result("mine"));
  EXPECT_EQ(campaign().status, 3);
  EXPECT_TRUE(fs::is_symlink(result("mine")));
  fs::remove(result("mine"));
  fs::copy_file(result("theory"), result("mine"));
  EXPECT_EQ(report().status, 3);
  EXPECT_TRUE(fs::exists(result("mine")));
}

TEST_F(GateVerdict, OfAFailureThatCannotBeReadIsOneToo) {
  ASSERT_EQ(campaign().status, 0);
  write_program("exit 1\n");
  ASSERT_EQ(campaign().status, 3);
  const fs::path failure = files_of_store(".failure.json").at(0);
  std::ofstream(failure) << "{}";
  EXPECT_EQ(report().status, 3);
  write_program(std::string("exec \"") + STAND_IN_SOLVER + "\" \"$@\"\n");
  EXPECT_EQ(campaign().status, 0) << "the program as it was has its result";
}

TEST_F(GateVerdict, RestsOnNoResultThatLiesAtThePlaceOfAnotherKey) {
  ASSERT_EQ(campaign().status, 0);
  const fs::path earlier = fs::read_symlink(result("mine"));
  write_program(std::string("# another build\nexec \"") + STAND_IN_SOLVER +
                "\" \"$1\" \"$2\" scaled 1.2\n");
  ASSERT_EQ(campaign().status, 1);
  const fs::path present = fs::read_symlink(result("mine"));
  ASSERT_NE(earlier, present);
  fs::copy_file(earlier, present, fs::copy_options::overwrite_existing);
  const Ended forged = report();
  EXPECT_EQ(forged.status, 4) << forged.out;
  EXPECT_TRUE(holds(forged.err, "expected that of its place"));
  EXPECT_EQ(campaign().status, 1) << "it is computed again";
}

TEST_F(GateVerdict, RestsOnNoReferenceThatAProgramHasSealedAnew) {
  write_campaign(small_case);
  campaign();
  forge_theory("forged.h5", 1.2);
  const fs::path theory = fs::read_symlink(result("theory"));
  write_program("cp '" + (directory() / "forged.h5").string() + "' '" + theory.string() +
                "'\nexec \"" + STAND_IN_SOLVER + "\" \"$1\" \"$2\" scaled 1.2\n");
  write_campaign(own_case);
  const Ended first = campaign();
  EXPECT_EQ(first.status, 4) << first.out;
  EXPECT_TRUE(holds(first.err, "has changed 1 results of the store"));
  EXPECT_FALSE(fs::exists(theory));
  const Ended second = campaign();
  EXPECT_EQ(second.status, 1) << second.out;
}

TEST_F(GateVerdict, RestsOnNoReferenceThatAProgramHasSealedAnewOutsideACampaign) {
  write_campaign(small_case);
  campaign();
  forge_theory("forged.h5", 1.2);
  const fs::path theory = fs::read_symlink(result("theory"));
  write_program("cp '" + (directory() / "forged.h5").string() + "' '" + theory.string() +
                "'\nexec \"" + STAND_IN_SOLVER + "\" \"$1\" \"$2\" scaled 1.2\n");
  write_campaign(own_case);
  EXPECT_EQ(run("mine").status, 4);
  EXPECT_FALSE(fs::exists(theory));
}

// Where theory is new too, it is computed and read before the program starts.
TEST_F(GateVerdict, ComesAfterReferencesThatWereReadBeforeAnyProgramRan) {
  write_program("test -n \"$(find '" + store().string() + "' -name '*.h5')\" || exit 9\nexec \"" +
                STAND_IN_SOLVER + "\" \"$@\"\n");
  EXPECT_EQ(campaign().status, 0);
}

// Whoever ends a start on a part of the campaign does not know whether the rest still holds.
TEST_F(GateVerdict, OfTheWholeDoesNotOutliveASelectionThatWasEnded) {
  const fs::path started = directory() / "started";
  for (const int signal : {SIGTERM, SIGKILL}) {
    write_program(std::string("exec \"") + STAND_IN_SOLVER + "\" \"$@\"\n");
    ASSERT_EQ(tool({"gate", "./surges.toml", "-o", "out"}).status, 0);
    ASSERT_EQ(tool({"gate", "./surges.toml", "-o", "out", "--only", "small"}).status, 0);
    EXPECT_TRUE(holds(gate_md(), "PASS")) << "a selection that passes leaves it";
    fs::remove(started);
    write_program("touch '" + started.string() + "'\nsleep 60\n");
    auto child = start_tool({"gate", "./surges.toml", "-o", "out", "--only", "small"});
    ASSERT_TRUE(comes_true([&] { return fs::exists(started); }, patience));
    kill(child.id(), signal);
    end_of(std::move(child));
    EXPECT_FALSE(holds(gate_md(), "PASS")) << signal;
    EXPECT_TRUE(holds(junit(), "<error")) << signal;
  }
}

TEST_F(GateVerdict, IsNotTakenFromAFileOfAnEarlierStart) {
  write_campaign(with(own_case, "limit = 0.05", "limit = 0.001"));
  const Ended first = campaign();
  ASSERT_EQ(first.status, 1);
  const std::string cached = read("out/standing.json");
  for (const char* status : {"0", "18446744073709551615"})
    if (const auto at = cached.find("\"status\": 1"); at != cached.npos)
      write("out/standing.json",
            std::string(cached).replace(at, 11, std::string("\"status\": ") + status));
  EXPECT_EQ(campaign().status, 1);
  EXPECT_FALSE(fs::exists(directory() / "out/standing.json") && cached.empty());
}

// Two rows of one name are one to a ledger.
TEST_F(GateVerdict, IsOfRowsWithNamesOfTheirOwn) {
  const std::string row = own_row("normalised_rms", "0.05");
  const auto over = [&](const char* end) {
    return row + "part_begin_s = 1.0\npart_end_s = " + end + "\n";
  };
  write_campaign(own_case + over("5.0") + over("5.0000001"));
  const Ended ended = gate();
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(holds(ended.err, "expected one row of the name")) << ended.err;
}

TEST_F(GateVerdict, NamesTheRowsThatWereLostAndEndsWithFiveUntilTheyAreApproved) {
  ASSERT_EQ(campaign().status, 0);
  approve({"--new"});
  EXPECT_EQ(gate().status, 0);
  write_campaign(small_case + own_run + own_row("amplitude_error", "0.05"));
  const Ended lost = gate({"--inconclusive-exit", "0"});
  EXPECT_EQ(lost.status, 5) << lost.out;
  for (const std::string& text : {lost.out, gate_md()}) {
    EXPECT_TRUE(holds(text, "Rows since the baseline: 1 lost (1 of validation)"));
    EXPECT_TRUE(holds(text, "no row of this form any more"));
  }
  EXPECT_TRUE(
      holds(gate_md(), "| **lost** | validation | small | mine against theory, forced phase"));
  EXPECT_TRUE(holds(junit(), "type=\"lost\""));
  EXPECT_TRUE(holds(junit(), "failures=\"1\""));
  approve();
  const Ended approved = gate();
  EXPECT_EQ(approved.status, 0) << approved.out;
  EXPECT_FALSE(holds(approved.out, "since the baseline:"));
}

TEST_F(GateVerdict, OfATagTellsThatACaseHasLostIt) {
  const auto write_cases = [&](const std::string& tags) {
    const std::string tagged = with(own_case, "tags = []", "tags = [\"wave\"]");
    write("small.toml", tagged);
    write("other.toml", with(with(tagged, "\"small\"", "\"other\""), "[\"wave\"]", tags));
  };
  write_cases("[\"wave\"]");
  write("surges.toml",
        with(read("surges.toml"), "[\"./small.toml\"]", "[\"./small.toml\", \"./other.toml\"]"));
  ASSERT_EQ(campaign().status, 0);
  approve({"--new"});
  EXPECT_EQ(gate({"--tag", "wave"}).status, 0);
  write_cases("[]");
  const Ended lost = gate({"--tag", "wave", "--inconclusive-exit", "0"});
  EXPECT_EQ(lost.status, 5) << lost.out;
  for (const std::string& text : {lost.out, read("out/selected/gate/gate.md")})
    EXPECT_TRUE(holds(text, "no row of this selection any more; its case had the tags wave"));
}

TEST_F(GateVerdict, NamesARunThatHasAnotherName) {
  ASSERT_EQ(campaign().status, 0);
  approve({"--new"});
  std::string renamed = own_case;
  for (const char* of : {"name = \"mine\"", "candidate = \"mine\"", "candidate = \"mine\""})
    renamed = with(renamed, of, with(of, "mine", "ours"));
  write_campaign(with(renamed, "\"1.01\"", "\"1.04\""));
  const Ended ended = gate();
  EXPECT_EQ(ended.status, 5);
  for (const std::string& text : {ended.out, gate_md(), junit()}) {
    EXPECT_TRUE(holds(text, "it may be small: ours against theory, forced"));
    EXPECT_TRUE(holds(text, "it may have been small: mine against theory, forced"));
  }
  EXPECT_TRUE(holds(ended.out, "2 lost (2 of validation), 2 new"));
}

TEST_F(GateVerdict, TellsOtherLimitsKindsWindowsInputsAndSettings) {
  ASSERT_EQ(campaign().status, 0);
  approve({"--new"});
  const auto told = [&](const std::string& text) {
    write_campaign(text);
    const Ended ended = gate();
    EXPECT_TRUE(holds(junit(), "since_baseline"));
    return std::to_string(ended.status) + gate_md();
  };
  EXPECT_TRUE(holds(told(with(own_case, "limit = 0.05", "limit = 0.04")),
                    "tolerance tightened: -5 % .. +5 % -&gt; -4 % .. +4 %"));
  const std::string demoted =
      told(with(own_case, "limit = 0.05", "limit = 0.05\nkind = \"regression\""));
  EXPECT_TRUE(holds(demoted, "kind: validation -&gt; regression"));
  EXPECT_EQ(demoted.front(), '5') << demoted;
  EXPECT_TRUE(holds(told(with(own_case, "window_begin_s = 1.0", "window_begin_s = 2.0")),
                    "window: 1 .. 8 s -&gt; 2 .. 8 s"));
  EXPECT_TRUE(holds(
      told(with(own_case, "[[run]]",
                "[[input]]\nname = \"gravity\"\nhalf_width = 0.01\nunit = \"m/s2\"\nsource = \"a "
                "test\"\n[[run]]")),
      "inputs: none -&gt; gravity"));
  EXPECT_TRUE(holds(told(with(own_case, "modes = 500", "modes = 400")),
                    "the case or the settings of the row"));
}

TEST_F(GateVerdict, ReadsLedgersWithoutTermsAndRecordsThemOnApproval) {
  ASSERT_EQ(campaign().status, 0);
  approve({"--new"});
  const std::string with_terms = read("ledger.jsonl");
  EXPECT_TRUE(holds(with_terms, "\"kind\":\"validation\",\"window\":\"1 .. 8 s\""));
}

TEST_F(GateVerdict, NamesAFailedRunThatNoRowUses) {
  write_campaign(own_case + with(with(own_run, "\"mine\"", "\"idle\""), "\"scaled\"", "\"fails\""));
  EXPECT_EQ(gate({"--store", "other"}).status, 2) << "no ledger is there";
  const Ended ended = tool({"gate", "./surges.toml", "-o", "out"});
  EXPECT_EQ(ended.status, 3);
  EXPECT_TRUE(holds(junit(), "errors=\"1\""));
  EXPECT_TRUE(holds(junit(), "name=\"run idle\""));
  EXPECT_TRUE(holds(gate_md(), "| **solver failed** |  | small | run idle |"));
}

TEST_F(GateVerdict, HasAnEntryForEveryStatusThatIsNotZero) {
  write_campaign(small_case);
  const Ended ended = tool({"gate", "./surges.toml", "-o", "out"});
  EXPECT_EQ(ended.status, 4) << ended.out;
  EXPECT_TRUE(holds(junit(), "errors=\"1\""));
  EXPECT_TRUE(holds(gate_md(), "**not compared**"));
}

TEST_F(GateVerdict, OfAnEarlierStartDoesNotOutliveAGateThatEndsEarly) {
  const std::vector<std::string> start{"gate", "./surges.toml", "-o", "out"};
  const auto passed_once = [&] {
    write_campaign(own_case);
    ASSERT_EQ(tool(start).status, 0);
    ASSERT_TRUE(holds(gate_md(), "PASS"));
  };
  const auto expect_none = [&](const std::string& why) {
    EXPECT_FALSE(holds(gate_md(), "PASS")) << why;
    EXPECT_TRUE(holds(gate_md(), "NOT COMPARED: ")) << why;
    EXPECT_TRUE(holds(gate_md(), why));
    EXPECT_TRUE(holds(junit(), "errors=\"1\"")) << why;
  };
  passed_once();
  write_campaign(with(own_case, "limit = 0.05", "limit = \"none\""));
  EXPECT_EQ(tool(start).status, 2);
  expect_none("limit");
  passed_once();
  write("surges.toml", "name = ");
  EXPECT_EQ(tool(start).status, 2);
  expect_none("surges.toml");
  passed_once();
  write("ledger.jsonl", "{}\n");
  EXPECT_EQ(gate().status, 4);
  expect_none("ledger.jsonl");
}

TEST_F(GateVerdict, OfInconclusiveRowsThatMayPassIsNoFailureInJUnit) {
  write_campaign(small_case + own_run + own_row("amplitude_error", "0.01"));
  const std::vector<std::string> start{"gate", "./surges.toml", "-o", "out"};
  const Ended strict = tool(start);
  ASSERT_EQ(strict.status, 5) << strict.out;
  EXPECT_TRUE(holds(junit(), "<failure"));
  std::vector<std::string> lenient = start;
  lenient.insert(lenient.end(), {"--inconclusive-exit", "0"});
  EXPECT_EQ(tool(lenient).status, 0);
  EXPECT_TRUE(holds(junit(), "failures=\"0\""));
  EXPECT_TRUE(holds(junit(), "skipped=\"1\""));
  EXPECT_TRUE(holds(junit(), "type=\"inconclusive\""));
}

TEST_F(GateVerdict, OfACampaignNamedAsAShippedOneIsNotComparedWithTheShippedLedger) {
  write("surges.toml", with(read("surges.toml"), "\"surges\"", "\"small_amplitude\""));
  const Ended ended = tool({"gate", "./surges.toml", "-o", "out"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_TRUE(holds(ended.out, "no baseline"));
  EXPECT_FALSE(holds(ended.out, "li2010_small_amplitude"));
  EXPECT_TRUE(holds(gate_md(), "There is no baseline"));
}

TEST_F(GateVerdict, OfAllCampaignsCountsAReportThatCannotBeRead) {
  ASSERT_EQ(tool({"campaign", "./surges.toml", "-o", "all/surges"}).status, 0);
  EXPECT_EQ(tool({"campaign", "--report-only", "--all", "-o", "all"}).status, 0);
  fs::create_directories(directory() / "all/other/report");
  EXPECT_EQ(tool({"campaign", "--report-only", "--all", "-o", "all"}).status, 4)
      << "it has no results.json";
  for (const char* text : {"[]", "{}", ""}) {
    write("all/other/report/results.json", text);
    const Ended ended = tool({"campaign", "--report-only", "--all", "-o", "all"});
    EXPECT_EQ(ended.status, 4) << text << ended.out;
    EXPECT_TRUE(holds(ended.out, "1 of 2 campaigns pass"));
  }
  std::string forged = read("all/surges/report/results.json");
  boost::replace_all(forged, "\"verdict\": \"pass\"", "\"verdict\": \"violated\"");
  write("all/other/report/results.json", forged);
  EXPECT_EQ(tool({"campaign", "--report-only", "--all", "-o", "all"}).status, 4);
}

TEST_F(GateVerdict, CountsARecordThatIsNotInTheDirectoryThatTheUserNames) {
  const std::string record = R"([[run]]
name = "measured"
solver = "record"
experiment = "tank/wave.csv"
time_column = "t_s"
value_column = "eta_m"
quantity = "elevation@right"
unit = "m"
uncertainty = 0.0001
)";
  write_campaign(small_case + own_run + record + own_row("amplitude_error", "0.05") +
                 with(own_row("phase_lag", "5.0"), "\"theory\"", "\"measured\""));
  EXPECT_EQ(campaign().status, 0) << "without --experiments the record is not asked for";
  fs::create_directories(directory() / "records/tank");
  const auto with_records = [&] {
    return tool({"campaign", "./surges.toml", "-o", "out", "--experiments", "records"});
  };
  EXPECT_EQ(with_records().status, 4) << "misspelt";
  fs::create_directory(directory() / "records/tank/wave.csv");
  EXPECT_EQ(with_records().status, 4) << "a directory";
  fs::remove(directory() / "records/tank/wave.csv");
  fs::create_symlink("nowhere", directory() / "records/tank/wave.csv");
  EXPECT_EQ(with_records().status, 4) << "a dangling link";
  fs::remove(directory() / "records/tank/wave.csv");
  fs::create_symlink("wave.csv", directory() / "records/tank/wave.csv");
  const Ended loop = with_records();
  EXPECT_EQ(loop.status, 4) << "a link to itself";
  EXPECT_TRUE(holds(loop.out, "not compared")) << loop.err;
  fs::remove(directory() / "records/tank/wave.csv");
  write("records/tank/wave.csv", "");
  const Ended empty = with_records();
  EXPECT_EQ(empty.status, 2);
  EXPECT_TRUE(holds(empty.err, "wave.csv:1: head = (nothing): expected a line with the columns'"));
}

// Of a campaign that has passed in a gate and in a report.
class EarlierVerdict : public GateVerdict {
 protected:
  void pass_both() const {
    write_campaign(own_case);
    EXPECT_EQ(tool({"campaign", "--report-only", "./surges.toml", "-o", place}).status, 0);
    EXPECT_EQ(tool({"gate", "./surges.toml", "-o", place}).status, 0);
    EXPECT_TRUE(holds(page(), "Pass</strong>"));
    EXPECT_TRUE(holds(gate_page(), "PASS"));
    EXPECT_EQ(all().status, 0);
  }
  Ended all() const { return tool({"campaign", "--report-only", "--all", "-o", "all"}); }
  std::string page() const { return read(place + "/report/index.html"); }
  std::string gate_page() const { return read(place + "/gate/gate.md"); }
  void expect_no_report(const std::string& why) const {
    EXPECT_FALSE(holds(page(), "Pass</strong>")) << why;
    EXPECT_NE(all().status, 0) << why;
  }
  void expect_no_pass(const std::string& why) const {
    expect_no_report(why);
    EXPECT_FALSE(holds(gate_page(), "PASS")) << why;
  }
  const std::string place = "all/surges";
};

TEST_F(EarlierVerdict, OutlivesNoLaterOneThatIsWorse) {
  ASSERT_EQ(tool({"campaign", "./surges.toml", "-o", place}).status, 0);
  for (const char* command : {"gate", "campaign", "campaign --report-only"}) {
    pass_both();
    write_campaign(with(own_case, "limit = 0.05", "limit = 0.001"));
    EXPECT_EQ(typed(command + (" ./surges.toml -o " + place)).status, 1);
    expect_no_pass(command);
    EXPECT_EQ(all().status, 1) << command;
  }
  pass_both();
  EXPECT_EQ(tool({"campaign", "--report-only", "./surges.toml", "-o", place}).status, 0);
  EXPECT_TRUE(holds(gate_page(), "PASS")) << "a report that says the same leaves it";
}

TEST_F(EarlierVerdict, OutlivesNoStartThatEndsEarly) {
  ASSERT_EQ(tool({"campaign", "./surges.toml", "-o", place}).status, 0);
  const std::vector<std::vector<std::string>> mistakes{
      {"--experiments", "/nonexistent"}, {"--only", "nosuch"}, {"--tag", "nosuch"},
      {"--inconclusive-exit", "256"},    {"--nosuch"},         {"--store", ""}};
  for (const auto& mistake : mistakes)
    for (const char* command : {"gate", "campaign"}) {
      pass_both();
      std::vector<std::string> words{command, "./surges.toml", "-o", place};
      words.insert(words.end(), mistake.begin(), mistake.end());
      EXPECT_EQ(tool(words).status, 2) << mistake.front();
      expect_no_pass(mistake.front());
    }
  for (const char* command : {"gate", "campaign --report-only"}) {
    pass_both();
    const Ended full =
        end_of(start("/bin/sh", {"-c", "\"$0\" $1 ./surges.toml -o \"$2\" >/dev/full", SLOSH_TOOL,
                                 command, place}));
    EXPECT_EQ(full.status, 4);
    expect_no_pass("a full standard output");
  }
  pass_both();
  EXPECT_EQ(tool({"gate", "--help"}).status, 0);
  EXPECT_TRUE(holds(gate_page(), "PASS"));
}

// The lists are lost, as in an artefact without hidden files, or a document is edited, or where it
// cannot be replaced.
TEST_F(EarlierVerdict, OutlivesNoStartWhateverBecameOfItsFiles) {
  ASSERT_EQ(tool({"campaign", "./surges.toml", "-o", place}).status, 0);
  const fs::path there = directory() / place;
  const auto fails_with = [&](int status, const char* why) {
    write_campaign(with(own_case, "limit = 0.05", "limit = 0.001"));
    for (int i = 0; i < 2; ++i) {
      const Ended ended = tool({"gate", "./surges.toml", "-o", place});
      EXPECT_EQ(ended.status, status) << why << ended.err;
      expect_no_report(why);
    }
  };
  pass_both();
  for (const char* list : {"gate/.slosh", "report/.slosh"}) fs::remove(there / list);
  fails_with(1, "no list");
  expect_no_pass("no list");
  EXPECT_TRUE(holds(read(place + "/gate/gate.md.kept-1"), "PASS"));
  pass_both();
  for (const char* list : {"gate/.slosh", "report/.slosh"}) fs::remove(there / list);
  EXPECT_EQ(tool({"gate", "./surges.toml", "-o", place, "--only", "nosuch"}).status, 2);
  expect_no_pass("no list, a mistake");
  pass_both();
  std::ofstream(there / "gate/gate.md", std::ios::app) << "\n";
  fails_with(1, "edited");
  expect_no_pass("edited");
  pass_both();
  fs::rename(there / "gate", there / "away");
  fs::create_directory_symlink("away", there / "gate");
  fails_with(4, "a link");
  EXPECT_TRUE(holds(tool({"gate", "./surges.toml", "-o", place}).err,
                    "an earlier verdict stays, remove it"));
}

TEST_F(EarlierVerdict, GivesWayToOneThatCannotBePrinted) {
  ASSERT_EQ(tool({"campaign", "./surges.toml", "-o", place}).status, 0);
  for (const char* command : {"gate", "campaign"}) {
    pass_both();
    write_campaign(with(own_case, "limit = 0.05", "limit = 0.001"));
    const Ended full =
        end_of(start("/bin/sh", {"-c", "\"$0\" $1 ./surges.toml -o \"$2\" >/dev/full", SLOSH_TOOL,
                                 command, place}));
    EXPECT_EQ(full.status, 1) << command << full.err;
    EXPECT_TRUE(holds(full.err, "standard output"));
    expect_no_pass(command);
    EXPECT_EQ(all().status, 1) << command;
    EXPECT_TRUE(holds(gate_page(), "exit status 1 -->")) << command;
  }
}

// A campaign that is let pass does not bring back what a gate said of it before.
TEST_F(EarlierVerdict, OutlivesNoCampaignThatIsLetPassUndecided) {
  ASSERT_EQ(tool({"campaign", "./surges.toml", "-o", place}).status, 0);
  pass_both();
  write_campaign(small_case + own_run + own_row("amplitude_error", "0.01"));
  EXPECT_EQ(tool({"campaign", "./surges.toml", "-o", place, "--inconclusive-exit", "0"}).status, 0);
  expect_no_pass("campaign");
  EXPECT_TRUE(holds(gate_page(), "INCONCLUSIVE"));
}

TEST_F(EarlierVerdict, SaysTheExitStatusOfItsProcess) {
  write_campaign(small_case + own_run + own_row("amplitude_error", "0.01"));
  const auto expect_told = [&](std::vector<std::string> words, int status) {
    words.insert(words.begin() + 1, {"./surges.toml", "-o", place});
    EXPECT_EQ(tool(words).status, status);
    const std::string told = "exit status " + std::to_string(status) + " -->";
    for (const char* file : {"/gate/gate.md", "/gate/junit.xml"})
      EXPECT_TRUE(holds(read(place + file), told)) << words.back();
  };
  expect_told({"gate"}, 5);
  expect_told({"gate", "--inconclusive-exit", "42"}, 42);
  expect_told({"gate", "--inconclusive-exit", "0"}, 0);
  expect_told({"campaign", "--inconclusive-exit", "0"}, 0);
  expect_told({"gate", "--nosuch"}, 2);
  expect_told({"gate", "--only", "nosuch"}, 2);
}

// The second start waits for the first, and does not put back what stood there in between.
TEST_F(EarlierVerdict, OfTwoStartsAtOnceIsTheirOwn) {
  write_program(std::string("sleep 2\nexec \"") + STAND_IN_SOLVER + "\" \"$@\"\n");
  for (const char* second : {"campaign", "campaign --report-only", "gate"}) {
    fs::remove_all(store());
    auto gate = start(SLOSH_TOOL, {"gate", "./surges.toml", "-o", place});
    for (int i = 0; i < 1000 && !fs::exists(directory() / place / "jobs"); ++i) ::usleep(10'000);
    ::usleep(500'000);
    const Ended other = typed(second + (" ./surges.toml -o " + place));
    gate.wait();
    EXPECT_EQ(gate.exit_code(), 0) << second;
    EXPECT_EQ(other.status, 0) << second << other.err;
    EXPECT_TRUE(holds(gate_page(), "PASS")) << second;
    if (second != std::string("gate")) {
      EXPECT_TRUE(holds(page(), "Pass</strong>")) << second;
    }
    fs::remove_all(directory() / place);
  }
}

TEST_F(GateVerdict, OfAnOutputThatIsAFileIsAMistakeAndLeavesTheFile) {
  const std::string before = read("small.toml");
  for (const char* command : {"gate", "campaign"}) {
    const Ended ended = tool({command, "./surges.toml", "-o", "small.toml"});
    EXPECT_EQ(ended.status, 2) << ended.err;
    EXPECT_TRUE(holds(ended.err, "small.toml: expected a directory")) << ended.err;
  }
  EXPECT_EQ(read("small.toml"), before);
}

// Two outputs, an output behind "=", a misspelt option, and the campaign behind "--".
TEST_F(EarlierVerdict, OutlivesNoCommandLineThatMayMeanIt) {
  ASSERT_EQ(tool({"campaign", "./surges.toml", "-o", place}).status, 0);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"-o", place, "-o", "other"},
        {"-o", "other", "-o", place},
        {"-o=" + place, "--bad"},
        {"--outpu", place},
        {"--outpu=" + place},
        {"-o", place, "--", "another"}}) {
    pass_both();
    std::vector<std::string> line{"gate", "./surges.toml"};
    line.insert(line.end(), words.begin(), words.end());
    EXPECT_EQ(tool(line).status, 2) << words.front();
    expect_no_pass(words.front() + " " + words.back());
  }
}

TEST_F(EarlierVerdict, OfTheWholeDoesNotOutliveASelectionThatFails) {
  ASSERT_EQ(tool({"campaign", "./surges.toml", "-o", place}).status, 0);
  pass_both();
  EXPECT_EQ(tool({"gate", "./surges.toml", "-o", place, "--only", "small/*"}).status, 0);
  EXPECT_TRUE(holds(gate_page(), "PASS"));
  for (const char* program : {"exit 1\n", "scaled"}) {
    pass_both();
    if (program == std::string("scaled"))
      write_campaign(with(own_case, "limit = 0.05", "limit = 0.001"));
    else
      write_program(program);
    EXPECT_NE(tool({"gate", "./surges.toml", "-o", place, "--only", "small/mine"}).status, 0);
    expect_no_pass(program);
    write_program(std::string("exec \"") + STAND_IN_SOLVER + "\" \"$@\"\n");
  }
}

TEST_F(EarlierVerdict, IsTheExitStatusThatTheUserAskedFor) {
  write_campaign(small_case + own_run + own_row("amplitude_error", "0.01"));
  ASSERT_EQ(tool({"campaign", "./surges.toml", "-o", place, "--inconclusive-exit", "0"}).status, 0);
  EXPECT_TRUE(holds(read(place + "/report/results.json"), "\"exit_status\": 0,"));
  EXPECT_EQ(all().status, 5);
  EXPECT_EQ(
      tool({"campaign", "--report-only", "--all", "-o", "all", "--inconclusive-exit", "0"}).status,
      0);
}

TEST_F(EarlierVerdict, IsReadAsItIsWritten) {
  ASSERT_EQ(tool({"campaign", "./surges.toml", "-o", place}).status, 0);
  const std::string data = read(place + "/report/results.json");
  for (const char* status :
       {"0.5", "4294967296", "1,\n  \"exit_status\": 0", "-1", "true", "\"0\""}) {
    write(place + "/report/results.json",
          with(data, "\"exit_status\": 0", "\"exit_status\": " + std::string(status)));
    EXPECT_EQ(all().status, 4) << status << ": no campaign is left";
  }
}

TEST_F(GateVerdict, OfNothingIsProposedAsNoBaseline) {
  write_program("exit 1\n");
  ASSERT_EQ(campaign().status, 3);
  const Ended ended = on_ledger({"baseline", "propose"}, {"--new"});
  EXPECT_EQ(ended.status, 3);
  EXPECT_TRUE(holds(ended.out, "nothing to propose: no row has a value, and there is no baseline"));
}

}  // namespace
}  // namespace slosh::gate_verdict_test
