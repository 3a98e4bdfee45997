// A program of a user's own in a campaign: it is judged against the references as SPH is, and does
// not pass where it is wrong, late, short, broken or endless.
#include <chrono>
#include <nlohmann/json.hpp>

#include "verification/results/result_file.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh::external_run_test {
namespace {

std::string own_run(const std::string& kind, const std::string& more = "") {
  return "[[run]]\nname = \"mine\"\nsolver = \"external\"\ncommand = [\"" STAND_IN_SOLVER
         "\", \"{case_file}\", \"{work_directory}/wave.csv\", " +
         kind + "]\n" + more + wave_series;
}

std::string own_case(const std::string& kind, const std::string& more = "") {
  return small_case + own_run(kind, more) + own_row("amplitude_error", "0.05") +
         own_row("phase_lag", "5.0") + own_row("normalised_rms", "0.2");
}

class ExternalRun : public SmallCampaign {
 protected:
  Ended campaign_of(const std::string& kind, const std::string& more = "") const {
    write_campaign(own_case(kind, more));
    return campaign();
  }
  std::string log() const { return read(files_of_store("mine.external.log").at(0)); }
};

TEST_F(ExternalRun, PassesTheGateWhereItIsRightToAPerCent) {
  const Ended ended = campaign_of("\"scaled\", \"1.01\"");
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_TRUE(holds(report_words(), "external program stand_in_solver"));
  EXPECT_TRUE(holds(read("out/report/results.json"), "\"solver\": \"external\""));
}

// What a script loads is a part of the run where `inputs` names it, and a doubt where nothing does.
TEST_F(ExternalRun, IsComputedAgainWhereAModuleOfItsScriptChanges) {
  std::filesystem::create_directories(directory() / "lib");
  write("run.sh",
        ". \"$(dirname \"$0\")/lib/k.sh\"\nexec \"" STAND_IN_SOLVER "\" \"$1\" \"$2\" scaled $k\n");
  const std::string kind = "\"scaled\", \"1\"";
  const auto script = [&](const std::string& more) {
    return with(with(own_case(kind, more), "\"" STAND_IN_SOLVER "\"",
                     "\"sh\", \"{case_directory}/run.sh\""),
                ", " + kind, "");
  };
  const std::string doubt = "what sh loads or holds is no part of its key";
  write("lib/k.sh", "k=1.01\n");
  write_campaign(script("inputs = [\"lib\"]\n"));
  EXPECT_EQ(campaign().status, 0);
  EXPECT_FALSE(holds(report_words(), doubt));
  write("lib/k.sh", "k=1.5\n");
  EXPECT_EQ(campaign().status, 1);
  std::filesystem::remove(directory() / "lib" / "k.sh");
  EXPECT_EQ(campaign().status, 2) << "there is no file in lib";
  write("lib/k.sh", "k=1.01\n");
  write_campaign(script(""));
  EXPECT_EQ(campaign().status, 0);
  EXPECT_TRUE(holds(report_words(), doubt));
  EXPECT_TRUE(holds(typed("explain ./small.toml").out, doubt));
}

// Three spacings of a program whose error falls with their square.
std::string runs_of_method() {
  std::string text;
  for (const char* spacing : {"0.08", "0.04", "0.02"}) {
    std::string run =
        own_run("\"converges\", \"{particle_spacing_m}\"",
                std::string("method = \"my_sph\"\nparticle_spacing_m = ") + spacing + "\n");
    text += with(run, "\"mine\"", std::string("\"mine_0p") + (spacing + 2) + "\"");
  }
  return text;
}

TEST_F(ExternalRun, FormsAMethodWithAnOrderACostAndAnUncertainty) {
  const std::string row = with(own_row("normalised_rms", "0.2"), "\"mine\"", "\"mine_0p02\"");
  write_campaign(small_case + runs_of_method() +
                 "[[refinement]]\nname = \"spacings\"\nnumber = \"particle_spacing\"\nruns = "
                 "[\"mine_0p08\", \"mine_0p04\", \"mine_0p02\"]\n" +
                 row);
  const Ended ended = campaign();
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  const auto results = nlohmann::json::parse(read("out/report/results.json"));
  const auto& one = results.at("cases").at(0);
  const auto& run = one.at("runs").at(3);
  EXPECT_EQ(run.at("method"), "my_sph");
  EXPECT_EQ(run.at("particle_spacing_m"), 0.02);
  EXPECT_TRUE(
      std::filesystem::exists(report() / "figures/small-convergence-my_sph-normalised_rms.svg"));
  const std::string words = report_words();
  EXPECT_TRUE(holds(words, "mine_0p08, mine_0p04, mine_0p02"));
  EXPECT_TRUE(holds(words, "Particle spacing: my_sph"));
}

// The study's case file lies in another directory, and finds the program and its files from there.
TEST_F(ExternalRun, IsStudiedByConvergeAtSpacingsThatTheCaseDoesNotHave) {
  std::filesystem::copy_file(STAND_IN_SOLVER, directory() / "solve");
  write("needed.txt", "");
  write("small.toml",
        small_case +
            with(own_run("\"converges\", \"{particle_spacing_m}\", \"{case_directory}/needed.txt\"",
                         "method = \"my_sph\"\nparticle_spacing_m = 0.1\ninputs = "
                         "[\"needed.txt\"]\nversion_command = [\"./tell\"]\n"),
                 STAND_IN_SOLVER, "./solve"));
  write("tell", "#!/bin/sh\necho my_sph 1.0\n");
  std::filesystem::permissions(directory() / "tell", std::filesystem::perms::owner_all);
  for (const char* how : {"--family", "--candidate"}) {
    const std::string name = how == std::string("--family") ? "my_sph" : "mine";
    const Ended ended = tool({"converge", "./small.toml", how, name, "--spacings", "0.08,0.04,0.02",
                              "-o", "orders", "--json"});
    EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
    const auto study = nlohmann::json::parse(ended.out);
    bool found = false;
    for (const auto& metric : study.at("metrics"))
      if (metric.at("metric") == "normalised_rms") {
        found = true;
        EXPECT_NEAR(metric.at("order").get<double>(), 2, 0.05);
      }
    EXPECT_TRUE(found) << ended.out;
  }
}

TEST_F(ExternalRun, TellsItsCountsAndWhatItDoesNotTellStaysUnknown) {
  const auto run_of_results = [&] {
    const auto results = nlohmann::json::parse(read("out/report/results.json"));
    return results.at("cases").at(0).at("runs").at(1);
  };
  EXPECT_EQ(campaign_of("\"tells\", \"42\"", "facts = \"cost.json\"\n").status, 0);
  EXPECT_EQ(run_of_results().at("steps"), 42);
  EXPECT_EQ(run_of_results().at("elements"), 3500);
  EXPECT_EQ(run_of_results().at("diagnostics").at("loop_wall_time_s"), 2);
  EXPECT_TRUE(holds(report_words(), "|3500|42|"));
  EXPECT_EQ(campaign_of("\"scaled\", \"1\"").status, 0);
  EXPECT_TRUE(run_of_results().at("steps").is_null());
  EXPECT_TRUE(run_of_results().at("elements").is_null());
  EXPECT_FALSE(holds(report_words(), "|external|0|0|"));
}

TEST_F(ExternalRun, FailsWhereItsFactsAreMissingOrWrong) {
  EXPECT_EQ(campaign_of("\"tells\", \"-1\"", "facts = \"cost.json\"\n").status, 3);
  EXPECT_TRUE(
      holds(read("out/report/results.json"),
            "cost.json: steps = -1: expected an integer > 0, or null where it is not known"));
  EXPECT_EQ(campaign_of("\"scaled\", \"1\"", "facts = \"cost.json\"\n").status, 3);
  EXPECT_TRUE(holds(read("out/report/results.json"),
                    "cost.json: expected a file that the program "
                    "writes"));
}

TEST_F(ExternalRun, IsShownUnderTheVersionThatItTells) {
  const std::string version =
      "version_command = [\"sh\", \"-c\", \"echo; echo My SPH 2.1; echo more\"]\n";
  EXPECT_EQ(campaign_of("\"scaled\", \"1\"", version).status, 0);
  const auto results = nlohmann::json::parse(read("out/report/results.json"));
  const auto& origin = results.at("cases").at(0).at("runs").at(1).at("provenance");
  EXPECT_EQ(origin.at("external_version"), "My SPH 2.1");
  EXPECT_FALSE(origin.contains("compiler")) << "which compiled Slosh";
  // The campaign names the case ./small.toml and is itself ./surges.toml.
  EXPECT_FALSE(holds(origin.at("external_command").get<std::string>(), "/./"));
  EXPECT_FALSE(holds(read("out/report/results.json"), "././"));
  EXPECT_TRUE(holds(report_words(), "|mine|My SPH 2.1, started by Slosh "));
  EXPECT_EQ(campaign_of("\"scaled\", \"1\"").status, 0);
  EXPECT_TRUE(
      holds(report_words(), "|mine|a program that does not tell its version, started by Slosh "));
}

TEST_F(ExternalRun, FailsBeforeItStartsWhereItsVersionCannotBeTold) {
  const auto complaint = [&](const std::string& command) {
    EXPECT_EQ(campaign_of("\"sleeps\"", "version_command = [" + command + "]\n").status, 3);
    return read("out/report/results.json");
  };
  EXPECT_TRUE(holds(complaint("\"sh\", \"-c\", \"exit 3\""), "exit status 3"));
  EXPECT_TRUE(holds(complaint("\"true\""), "version_command: expected a line of output"));
  EXPECT_TRUE(holds(complaint("\"./none\""), "version_command: ./none: expected a program"));
}

// The second line has a colour and a letter of Latin-1.
TEST_F(ExternalRun, FailsWhereALineOfItsLogMatchesAPattern) {
  const std::string command =
      "[\"sh\", \"-c\", \"echo step 7: NaN in pressure; printf '12 \\\\033[31mparticles\\\\033[0m "
      "lib\\\\351r\\\\351es\\\\n'; exec \\\"$0\\\" \\\"$@\\\"\", \"" STAND_IN_SOLVER "\"";
  const auto campaign_with = [&](const std::string& patterns) {
    write_campaign(with(own_case("\"scaled\", \"1\"", "fail_on = " + patterns + "\n"),
                        "[\"" STAND_IN_SOLVER "\"", command));
    return campaign();
  };
  const Ended ended = campaign_with("[\"inf\", \"step [0-9]+: N\"]");
  EXPECT_EQ(ended.status, 3);
  EXPECT_TRUE(holds(ended.out + ended.err,
                    "line 1 of its log matches fail_on = \"step [0-9]+: N\": step 7: NaN "
                    "in pressure"));
  EXPECT_EQ(campaign_with("[\"inf\"]").status, 0) << "the pattern is part of the run";
  for (const char* shown : {"[\"12 particles\"]", "[\"particles.*es$\"]"})
    EXPECT_EQ(campaign_with(shown).status, 3) << shown;
}

TEST_F(ExternalRun, FailsWhereItMakesItsOwnLogShorter) {
  const std::string command =
      "[\"sh\", \"-c\", \"echo NaN in pressure; sleep 0.5; echo > /dev/stdout; sleep 0.5; exec "
      "\\\"$0\\\" \\\"$@\\\"\", \"" STAND_IN_SOLVER "\"";
  write_campaign(with(own_case("\"scaled\", \"1\"", "fail_on = [\"NaN\"]\n"),
                      "[\"" STAND_IN_SOLVER "\"", command));
  const Ended ended = campaign();
  EXPECT_EQ(ended.status, 3);
  EXPECT_TRUE(holds(ended.out + ended.err, "made its own log shorter")) << ended.err;
}

TEST_F(ExternalRun, IsBoundToItsCoresAndMarkedWhereItLeavesThem) {
  const std::string command =
      "[\"sh\", \"-c\", \"nproc > \\\"$0/cores\\\"; exec \\\"$@\\\"\", "
      "\"{case_directory}\", \"" STAND_IN_SOLVER "\"";
  const auto campaign_with = [&](const std::string& cores) {
    write_campaign(with(own_case("\"scaled\", \"1\"", cores), "[\"" STAND_IN_SOLVER "\"", command));
    return campaign();
  };
  EXPECT_EQ(campaign_with("cores = 1\n").status, 0);
  EXPECT_EQ(read("cores"), "1\n");
  const auto results = nlohmann::json::parse(read("out/report/results.json"));
  const auto& run = results.at("cases").at(0).at("runs").at(1);
  EXPECT_EQ(run.at("cores"), 1);
  EXPECT_EQ(run.at("message"), "") << "it keeps to them";
  EXPECT_EQ(campaign_with("cores = 5000\n").status, 3);
  EXPECT_TRUE(holds(read("out/report/results.json"), "cores = 5000: expected at most the "));
}

TEST_F(ExternalRun, IsToldThatItsCommandWantsASpacing) {
  write_campaign(own_case("\"converges\", \"{particle_spacing_m}\""));
  const Ended ended = campaign();
  EXPECT_EQ(ended.status, 2);
  EXPECT_TRUE(holds(ended.err,
                    "{particle_spacing_m} is filled in only where the run has method and "
                    "particle_spacing_m"));
}

TEST_F(ExternalRun, ViolatesTheGateWhereItIsTooHighOrLate) {
  EXPECT_EQ(campaign_of("\"scaled\", \"1.2\"").status, 1);
  EXPECT_EQ(campaign_of("\"shifted\", \"0.1\"").status, 1);
}

TEST_F(ExternalRun, FailsWhereItsSeriesIsShortOrHoldsNoNumber) {
  const Ended truncated = campaign_of("\"truncated\", \"4\"");
  EXPECT_EQ(truncated.status, 3);
  EXPECT_TRUE(holds(report_words(), "ends at 4 s, expected 8 s"));
  EXPECT_EQ(campaign_of("\"nan\"").status, 3);
  EXPECT_TRUE(holds(report_words(), "eta = nan: expected a number, in mm"));
}

TEST_F(ExternalRun, FailsWithItsLastWordsWhereItExitsWithAnError) {
  const Ended ended = campaign_of("\"fails\"");
  EXPECT_EQ(ended.status, 3);
  EXPECT_EQ(log(), "the Courant number is too large\n");
  EXPECT_TRUE(holds(ended.out + ended.err,
                    "exit status 7; its last words: the Courant number is too large"));
}

// What it said is kept beside where its result would lie, told again by a later report, and gone
// once the run has succeeded.
TEST_F(ExternalRun, LeavesWhyItFailedAsDataUntilItSucceeds) {
  write_campaign(with(own_case("\"scaled\", \"1.01\""), "[\"" STAND_IN_SOLVER "\"",
                      "[\"sh\", \"{case_directory}/solve.sh\", \"{case_directory}\", "
                      "\"" STAND_IN_SOLVER "\""));
  write("solve.sh",
        "if test -e \"$1/licence_expired\"; then echo one; echo two; exit 7; fi\nshift\n"
        "exec \"$@\"\n");
  write("licence_expired", "");
  const Ended failed = campaign();
  EXPECT_EQ(failed.status, 3);
  EXPECT_TRUE(holds(failed.err, "    one\n    two\n    log: "));
  const auto files = files_of_store(".failure.json");
  ASSERT_EQ(files.size(), 1u);
  const auto failure = nlohmann::json::parse(read(files[0])).at("body");
  EXPECT_EQ(failure.at("kind"), "solver failed");
  EXPECT_TRUE(holds(failure.at("message"), "exit status 7; its last words: two"));
  EXPECT_EQ(failure.at("details"), "one\ntwo");
  EXPECT_EQ(read(failure.at("log").get<std::string>()), "one\ntwo\n");
  const Ended report = typed("campaign --report-only ./surges.toml --output out");
  EXPECT_EQ(report.status, 3) << report.err;
  EXPECT_TRUE(holds(report.err, "    one\n    two\n"));
  std::filesystem::remove(directory() / "licence_expired");
  EXPECT_EQ(campaign().status, 0);
  EXPECT_TRUE(files_of_store(".failure.json").empty());
}

TEST_F(ExternalRun, IsEndedWhenItsTimeIsOver) {
  const Ended ended = campaign_of("\"sleeps\"", "time_limit_s = 0.3\n");
  EXPECT_EQ(ended.status, 3);
  EXPECT_TRUE(
      holds(ended.out + ended.err, "did not end within its time_limit_s = 0.3; it said nothing"));
}

TEST_F(ExternalRun, IsKeptUntilItsProgramsInputsOrArgumentsChange) {
  write("numbers.txt", "1\n");
  const std::string inputs = "inputs = [\"numbers.txt\"]\n";
  EXPECT_EQ(campaign_of("\"scaled\", \"1.01\"", inputs).status, 0);
  const auto first = std::filesystem::last_write_time(result("mine"));
  EXPECT_EQ(campaign_of("\"scaled\", \"1.01\"", inputs).status, 0);
  EXPECT_EQ(std::filesystem::last_write_time(result("mine")), first);
  write("numbers.txt", "2\n");
  EXPECT_EQ(campaign_of("\"scaled\", \"1.01\"", inputs).status, 0);
  const auto second = std::filesystem::last_write_time(result("mine"));
  EXPECT_GT(second, first);
  EXPECT_EQ(campaign_of("\"scaled\", \"1.02\"", inputs).status, 0);
  EXPECT_GT(std::filesystem::last_write_time(result("mine")), second);
}

// Its result would be kept under the key of the content that was there before.
TEST_F(ExternalRun, FailsWhereAnInputChangesWhileItRuns) {
  write("numbers.txt", "1\n");
  write("solve.sh", "echo 2 > \"$1\"\nshift\nexec \"$@\"\n");
  write_campaign(with(own_case("\"scaled\", \"1.01\""), "[\"" STAND_IN_SOLVER "\"",
                      "[\"sh\", \"{case_directory}/solve.sh\", \"{case_directory}/numbers.txt\", "
                      "\"" STAND_IN_SOLVER "\""));
  const Ended ended = campaign();
  EXPECT_EQ(ended.status, 3) << ended.out;
  EXPECT_TRUE(holds(ended.out + ended.err, "numbers.txt changed while the run went on"));
  EXPECT_EQ(campaign().status, 0) << "now it writes what is there already";
}

TEST_F(ExternalRun, IsRepeatedWhereAnArgumentThatIsAFileHasChanged) {
  const std::string script = "exec \"$@\"\n";
  const std::string own = with(own_case("\"scaled\", \"1.01\""), "[\"" STAND_IN_SOLVER "\"",
                               "[\"sh\", \"{case_directory}/solve.sh\", \"" STAND_IN_SOLVER "\"");
  write("solve.sh", script);
  write_campaign(own);
  const Ended ended = campaign();
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  const auto first = std::filesystem::last_write_time(result("mine"));
  write("solve.sh", "exit 9\n");
  EXPECT_EQ(campaign().status, 3) << "the program that fails now must not pass";
  write("solve.sh", script);
  EXPECT_EQ(campaign().status, 0);
  EXPECT_EQ(std::filesystem::last_write_time(result("mine")), first) << "the old one is kept";
}

TEST_F(ExternalRun, IsRefusedBeforeAnythingRunsWhereItsCaseIsWrong) {
  const auto complaint = [&](const std::string& from, const std::string& to) {
    write_campaign(with(own_case("\"scaled\", \"1\""), from, to));
    const Ended ended = campaign();
    EXPECT_EQ(ended.status, 2);
    return ended.err;
  };
  const auto expect_words = [](const std::string& text, const std::string& words) {
    EXPECT_TRUE(holds(text, words));
  };
  expect_words(complaint("format = \"csv\"", "format = \"cvs\""),
               "run mine: format = cvs: expected one of csv");
  expect_words(
      complaint("{case_file}", "{case_fil}"),
      "{case_fil} is no placeholder, expected one of case_file, case_directory, "
      "work_directory, tank_file, peers_directory, duration_s, sample_interval_s; nearest: "
      "case_file");
  expect_words(
      complaint("quantity = \"elevation@right\"\nfile", "quantity = \"elevation@left\"\nfile"),
      "run.series.quantity = \"elevation@left\": expected a compared quantity");
  expect_words(complaint("file = \"wave.csv\"", "file = \"../wave.csv\""),
               "expected a file's path below the run's work directory");
  expect_words(complaint("[[run.series]]", "inputs = [\"none.txt\"]\n[[run.series]]"),
               "expected files, directories or patterns of them, relative to the case file; there "
               "is no file in");
}

TEST_F(ExternalRun, WithoutItsProgramFailsButIsStillReportedOn) {
  write_campaign(with(own_case("\"scaled\", \"1.01\""), STAND_IN_SOLVER, "./solve"));
  std::filesystem::copy_file(STAND_IN_SOLVER, directory() / "solve");
  EXPECT_EQ(campaign().status, 0);
  std::filesystem::remove(directory() / "solve");
  EXPECT_EQ(typed("campaign --report-only ./surges.toml --output out").status, 0);
  const Ended ended = campaign();
  EXPECT_EQ(ended.status, 3);
  EXPECT_TRUE(holds(ended.out + ended.err,
                    "command: ./solve: expected a program relative to the case file or on "
                    "the PATH; there is none"));
}

// What the program starts in turn goes with it.
TEST_F(ExternalRun, EndsWithTheRunThatStartedIt) {
  namespace fs = std::filesystem;
  write_campaign(with(own_case("\"sleeps\""), STAND_IN_SOLVER, "./waits.sh"));
  write("waits.sh", "#!/bin/sh\nsleep 61 &\necho $! > \"${2%/*}/child\"\nwait\n");
  fs::permissions(directory() / "waits.sh", fs::perms::owner_all);
  boost::process::child run = start_tool({"run", "./small.toml", "mine"});
  const fs::path child = directory() / "mine.work/mine.external/child";
  for (int i = 0; i < 200 && (!fs::exists(child) || fs::file_size(child) == 0); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const int sleeper = std::stoi(read(child));
  ASSERT_EQ(::kill(sleeper, 0), 0);
  ::kill(run.id(), SIGTERM);
  EXPECT_EQ(end_of(std::move(run)).status, -SIGTERM);
  for (int i = 0; i < 100 && ::kill(sleeper, 0) == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  // Gone, or dead and waiting for whoever adopts orphans.
  const std::string status = read("/proc/" + std::to_string(sleeper) + "/status");
  EXPECT_TRUE(::kill(sleeper, 0) != 0 || status.find("State:\tZ") != std::string::npos);
}

TEST_F(ExternalRun, IsCountedWhereTheParentOfSloshIgnoresTheEndOfChildren) {
  namespace fs = std::filesystem;
  write_campaign(with(own_case("\"scaled\", \"1.01\""), "[\"" STAND_IN_SOLVER "\"",
                      "[\"./works.sh\", \"" STAND_IN_SOLVER "\""));
  write("works.sh", "#!/bin/sh\ni=0\nwhile [ $i -lt 300000 ]; do i=$((i + 1)); done\n\"$@\"\n");
  fs::permissions(directory() / "works.sh", fs::perms::owner_all);
  const auto cost = [&](const std::vector<std::string>& before) {
    std::vector<std::string> words = before;
    words.insert(words.end(), {SLOSH_TOOL, "run", "./small.toml", "mine", "-o", "mine.h5"});
    const Ended ended = end_of(start("/usr/bin/env", words));
    EXPECT_EQ(ended.status, 0) << ended.err;
    return read_result(directory() / "mine.h5").cost.core_seconds();
  };
  const double usual = cost({});
  EXPECT_GT(cost({"--ignore-signal=CHLD"}), 0.7 * usual);
}

// A process in a session of its own hears no signal to the program's group.
TEST_F(ExternalRun, LeavesNoDetachedProcessBehind) {
  namespace fs = std::filesystem;
  write_campaign(with(own_case("\"scaled\", \"1.01\""), "[\"" STAND_IN_SOLVER "\"",
                      "[\"./detaches.sh\", \"" STAND_IN_SOLVER "\""));
  write(
      "detaches.sh",
      "#!/bin/sh\nsetsid sh -c 'echo $$ > started; exec sleep 62' </dev/null &\n"
      "while ! test -s started; do sleep 0.02; done\ncp started \"${0%/*}/child\"\nexec \"$@\"\n");
  fs::permissions(directory() / "detaches.sh", fs::perms::owner_all);
  const Ended ended = campaign();
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  const int sleeper = std::stoi(read("child"));
  const std::string command = read("/proc/" + std::to_string(sleeper) + "/cmdline");
  EXPECT_FALSE(holds(command, "sleep")) << "the detached process still runs";
}

}  // namespace
}  // namespace slosh::external_run_test
