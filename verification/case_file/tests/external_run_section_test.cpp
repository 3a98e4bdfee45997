// [[run]] with solver = "external": what a case may say about a program of the user, and what is
// refused.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::external_run_section_test {
namespace {

const std::string command = "command = [\"./solve\", \"--case\", \"{case_file}\", \"\"]\n";
const std::string series =
    "[[run.series]]\nquantity = \"elevation@right\"\nfile = \"out/swl.csv\"\n"
    "format = \"csv\"\ncolumn = \"eta\"\n";

std::string text_with(const std::string& keys) {
  const std::string text = valid_text.substr(0, valid_text.find("[[gate]]"));
  return text + "[[run]]\nname = \"mine\"\nsolver = \"external\"\n" + keys;
}

// The settings are those that the run's key hashes.
TEST(ExternalRunSection, SaysWhatIsStartedAndWhatItLeaves) {
  const RunDefinition read =
      read_trial(
          {text_with(
               command +
               "method = \"my_sph\"\nparticle_spacing_m = 0.02\ntime_limit_s = 60\n"
               "inputs = [\"numbers.txt\"]\n" +
               series +
               "unit = \"mm\"\ntime_column = \"t\"\ntime_unit = \"ms\"\nscale = -2\noffset = 0.5\n"
               "time_offset_s = -3\n"
               "[[run.series]]\nquantity = \"force_x\"\nfile = \"f.dat\"\nformat = \"sphinxsys\"\n"
               "column = \"Force[0]\"\ndatum = \"first\"\n"),
           {{"numbers.txt", "1"}}})
          .runs.back();
  EXPECT_EQ(hashed_settings(read).dump(),
            R"({"external":[["./solve","--case","{case_file}",""],)"
            R"([["elevation@right","out/swl.csv","csv","eta","mm","t","ms",-2.0,0.5,false,-3.0],)"
            R"(["force_x","f.dat","sphinxsys","Force[0]","","","",1.0,0.0,true]]],)"
            R"("particle_spacing":0.02})");
  const auto& run = std::get<ExternalRun>(read.solver);
  EXPECT_EQ(run.time_limit, 60);
  EXPECT_EQ(run.method, "my_sph");
  EXPECT_EQ(run.inputs.at(0).filename(), "numbers.txt");
  EXPECT_TRUE(run.directory.empty());
}

// Otherwise two methods would be shown, and judged, as one.
TEST(ExternalRunSection, MayNotShareItsMethodWithAnotherOne) {
  const std::string mine =
      text_with(command + "method = \"mine_too\"\nparticle_spacing_m = 0.02\n" + series);
  expect_refusals(mine, R"(
run.method = "any": expected a name that does not stand for the run coarse too
run.method = "theory": expected a name that does not stand for the run theory too
run.method = "interFoam": expected a name that does not stand for the run mesh too
)");
  expect_refusals(mine +
                      "[[run]]\nname = \"later\"\nsolver = \"sph\"\nscheme = \"mine_too\"\n"
                      "particle_spacing_m = 0.02\n",
                  R"(
-> run.scheme = "mine_too": expected a name that does not stand for the run mine too
)");
  std::string again = mine.substr(mine.rfind("[[run]]"));
  expect_refusals(mine + again.replace(again.find("mine"), 4, "again"), R"(
-> run.particle_spacing_m = 0.02: expected a spacing that no other run of the method has; mine has
  this one
)");
}

// The coarse and the fine run of one method.
std::string complaint_about_pair(const std::string& coarse, const std::string& fine,
                                 const std::string& of_fine = "") {
  const Workspace workspace;
  for (const char* directory : {"c", "f"})
    std::filesystem::create_directory(workspace.path() / directory);
  for (const char* program : {"solve", "other", "c/run", "f/run"})
    workspace.write(program, "#!/bin/sh\n");
  for (const char* settings : {"c.cfg", "f.cfg", "swl.csv", "cost.json"})
    workspace.write(settings, "1");
  const std::string method = "method = \"my_sph\"\nparticle_spacing_m = ",
                    taken =
                        "[[run.series]]\nquantity = \"elevation@right\"\n"
                        "file = \"swl.csv\"\nformat = \"csv\"\ncolumn = \"eta\"\n";
  return complaint(workspace.write(
      "trial.toml", text_with(coarse + method + "0.04\n" + taken +
                              "[[run]]\nname = \"fine\"\nsolver = \"external\"\n" + fine + method +
                              "0.02\n" + (of_fine.starts_with("[") ? of_fine : taken + of_fine))));
}

std::string started(const std::string& words) { return "command = [" + words + "]\n"; }

const std::string solve = started("\"./solve\", \"{particle_spacing_m}\"");

TEST(ExternalRunSection, OfAMethodDiffersInItsSpacingAlone) {
  const std::string begin = "expected a run that differs from mine in the spacing alone, and ";
  const auto expect = [&](const std::string& coarse, const std::string& fine,
                          const std::string& said, const std::string& of_fine = "") {
    EXPECT_TRUE(holds(complaint_about_pair(coarse, fine, of_fine), begin + said))
        << fine << of_fine;
  };
  expect(solve, started("\"./other\", \"{particle_spacing_m}\""), "starts the same programs, ");
  expect(started("\"python3\", \"prog.py\""), started("\"python3\", \"other.py\""),
         "starts the same programs, ");
  expect(started("\"mpirun\", \"-n\", \"2\", \"{case_directory}/solve\""),
         started("\"mpirun\", \"-n\", \"4\", \"./other\""), "starts the same programs, ");
  expect(started("\"./solve\""), started("\"./solve\""),
         "has another command or directory, as by {particle_spacing_m}");
  for (const char* key : {"scale = 1.1", "offset = 0.01", "datum = \"first\"", "unit = \"mm\"",
                          "time_offset_s = 0.1", "time_column = \"t\""})
    expect(solve, solve, "takes elevation@right with the same format, column, unit, scale",
           std::string(key) + "\n");
}

// Of such a series the first value is 0 whatever the program prints.
TEST(ExternalRunSection, ThatCountsFromItsFirstValueIsNotJudgedByIt) {
  expect_refusals(text_with(command + series + "datum = \"first\"\n") +
                      "[[gate]]\ncandidate = \"mine\"\nquantity = \"elevation@right\"\n"
                      "metric = \"initial_value\"\nlimit = 0.001\nunit = \"m\"\nreason = \"r\"\n"
                      "source = \"s\"\n",
                  R"(
-> gate.metric = "initial_value": expected another metric: elevation@right of mine counts from its
  first value
gate.metric = "largest_magnitude": accepted
gate.unit = "N/m" & run.series.quantity = "force_x" & gate.quantity = "force_x" & gate.metric = "largest_magnitude": expected another metric: force_x of mine counts from its first value
run.series.datum is missing: accepted
)");
}

TEST(ExternalRunSection, OfAMethodMayHaveSettingsAndDirectoriesOfItsOwn) {
  const std::string other_file =
      "[[run.series]]\nquantity = \"elevation@right\"\nfile = \"fine.csv\"\nformat = \"csv\"\n"
      "column = \"eta\"\n";
  for (const auto& [coarse, fine] :
       {std::pair{solve, solve},
        {started("\"./solve\", \"c.cfg\""), started("\"./solve\", \"f.cfg\"")},
        {started("\"./c/run\""), started("\"./f/run\"")},
        {started("\"./solve\"") + "directory = \"c\"\n",
         started("\"./solve\"") + "directory = \"f\"\n"},
        {started("\"mpirun\", \"-n\", \"2\", \"./solve\", \"c.cfg\""),
         started("\"mpirun\", \"-n\", \"8\", \"./solve\", \"f.cfg\"")}}) {
    EXPECT_EQ(complaint_about_pair(coarse, fine), "") << fine;
    EXPECT_EQ(complaint_about_pair(coarse, fine, other_file), "") << fine;
  }
}

TEST(ExternalRunSection, IsRefusedByTheLineWhereItGoesWrong) {
  expect_refusals(text_with(command + series), R"(
run.command = [] -> run.command = (an array): expected a list of texts that begins with a program
run.command = "./solve --fast": expected
run.inputs = ["none.txt"] -> run.inputs = (an array): expected files, directories or patterns of them,
  relative to the case file; there is no file in
run.inputs = ["/dev/null"] -> run.inputs = (an array): expected
run.directory = "none": expected a directory relative to the case file
run.modes = 3: expected only these keys
run.fail_on = ["NaN", "[0-9"] -> run.fail_on = "[0-9": expected a regular expression of RE2
run.version_command = [] -> run.version_command = (an array): expected a list of texts that begins
  with a program
run.facts = "../cost.json": expected a file's path below the run's work directory
run.method = "my_sph" -> run.particle_spacing_m is missing: expected the method's spacing in this
  run, in m, beside method
run.particle_spacing_m = 0.02 -> run.method is missing: expected the name of the method
run.method = "my_sph" & run.particle_spacing_m = 0.6: expected a number > 0 and <= the fill depth
  (0.5), in m
run.series.unit = "Pa": expected a unit of elevation@right, one of m, cm
run.series.scale = 0: expected a number other than 0, without unit
run.series.datum = "still": expected a datum, which is first
run.series.offset = 0.5 & run.series.datum = "first": expected no datum beside an offset
run.series.time_unit = "h": expected a unit of time, one of s, ms, min
run.series.file = "/tmp/a.csv": expected a file's path below the run's work directory
)");
  expect_refusals(text_with(command + series + series), R"(
-> run.series.quantity = "elevation@right": expected a quantity that no other
)");
  expect_refusals(text_with(command), R"(
-> run.series is missing: expected at least one [[run.series]]
)");
}

const std::string pysph = "[[run]]\nname = \"peer\"\nsolver = \"pysph\"\nscheme = \"edac\"\n";

std::string with_pysph(const std::string& keys) {
  const std::string text = valid_text.substr(0, valid_text.find("[[gate]]"));
  return text + pysph + keys;
}

TEST(PysphRunSection, IsAnExternalRunOfTheShippedDriver) {
  const CaseDefinition definition = read_text(with_pysph("particle_spacing_m = 0.05\n"));
  EXPECT_EQ(hashed_settings(definition.runs.back()).dump(),
            R"({"cores":1,"external":[["{peers_directory}/pysph_tank.py","{tank_file}",)"
            R"("{work_directory}","edac","{particle_spacing_m}"],)"
            R"([["elevation@right","elevation.csv","csv","right","m","t","s",1.0,0.0,false],)"
            R"(["elevation@left","elevation.csv","csv","left","m","t","s",1.0,0.0,false]]],)"
            R"("facts":"cost.json","particle_spacing":0.05,)"
            R"("version":["{peers_directory}/pysph_tank.py","--version"]})");
  EXPECT_EQ(method_of(definition.runs.back()), "pysph_edac");
}

TEST(PysphRunSection, IsRefusedWhereTheDriverCannotFollow) {
  const std::string text = with_pysph("particle_spacing_m = 0.05\n");
  expect_refusals(text, R"(
run.particle_spacing_m = 0.03: expected a whole fraction of the tank's length and of the fill depth,
  2 and 0.5 m, for pysph
run.scheme = "tvf": expected a scheme of PySPH's driver
)");
  expect_refusals(text +
                      "[[obstacle]]\nname = \"baffle\"\nleft_m = 1\nright_m = 1.1\nbottom_m = "
                      "0\ntop_m = 0.2\n",
                  R"(
-> run.solver = "pysph": expected another solver: pysph takes a tank with a [[gauge]]
)");
  // Two runs of one scheme differ in their spacing.
  std::string twice = text + pysph + "particle_spacing_m = 0.05\n";
  twice.replace(twice.rfind("peer"), 4, "also");
  expect_refusals(twice, R"(
-> run.particle_spacing_m = 0.05: expected a spacing that no other run of the method has
)");
}

const std::string stored = valid_text.substr(0, valid_text.find("[[gate]]")) + R"([[run]]
name = "theirs"
solver = "stored"
facts = "cost.json"
method = "their_sph"
particle_spacing_m = 0.02
[[run.series]]
quantity = "elevation@right"
file = "swl.csv"
format = "csv"
column = "eta"
)";
const std::map<std::string, std::string> stored_files{{"swl.csv", "t,eta\n"}, {"cost.json", "{}"}};

TEST(StoredRunSection, NamesFilesBesideTheCaseFile) {
  const CaseDefinition definition = read_trial({stored, stored_files});
  const StoredRun run = std::get<StoredRun>(definition.runs.back().solver);
  EXPECT_EQ(run.method, "their_sph");
  EXPECT_EQ(run.particle_spacing, 0.02);
  ASSERT_EQ(run.series.size(), 1u);
  EXPECT_TRUE(run.facts.is_absolute());
  EXPECT_EQ(run.facts.filename(), "cost.json");
  EXPECT_EQ(run.series[0].file, run.facts.parent_path() / "swl.csv");
}

TEST(StoredRunSection, IsRefusedWhereAFileIsMissingOrAMethodShared) {
  expect_refusals({stored, stored_files}, R"(
run.facts = "none.json": expected a file relative to the case file; there is no
run.series.file = "none.csv": expected a file relative to the case file
)");
  std::string again = stored.substr(stored.rfind("[[run]]"));
  expect_refusals({stored + again.replace(again.find("theirs"), 6, "again"), stored_files}, R"(
-> run.particle_spacing_m = 0.02: expected a spacing that no other run of the method has; theirs has
  this one
)");
}

const std::string mine = valid_text.substr(0, valid_text.find("[[gate]]")) + R"([[run]]
name = "mine"
solver = "stored"
file = "mine.csv"
)";

TEST(StoredRunSection, NeedsAPlainTableAndNothingElse) {
  const CaseDefinition definition = read_trial(
      {mine, {{"mine.csv", "t,elevation@left [mm],depth,elevation@right\n0,1,2,3\n1,1,2,3\n"}}});
  EXPECT_EQ(hashed_settings(definition.runs.back()).dump(),
            R"({"stored":[[["elevation@left","mine.csv","csv","elevation@left","","t","s",1.0,)"
            R"(0.0,false],["elevation@right","mine.csv","csv","elevation@right","m","t","s",1.0,)"
            R"(0.0,false]],"",0.0]})");
  EXPECT_TRUE(std::get<StoredRun>(definition.runs.back().solver).facts.empty());
  EXPECT_EQ(family(definition.runs.back()), "mine");
  EXPECT_FALSE(particle_spacing(definition.runs.back()));
}

TEST(StoredRunSection, OfAPlainTableIsRefusedWithoutItsFileAndWithHalfAMethod) {
  expect_refusals({mine, {{"mine.csv", "t,eta\n0,1\n1,1\n"}}}, R"(
run.file = "none.csv": expected a file relative to the case file; there is no
run.method = "m" -> run.particle_spacing_m is missing: expected the method's spacing
)");
  // The elevation at a gauge that the case has not is not that at another.
  expect_refusals_of("mine.csv", {mine, {}}, R"(
t,elevation@middle | 0,1 | 1,1 -> 1: columns = t,elevation@middle: expected beside the times one
  column, or columns with names of the case's quantities
)");
}

}  // namespace
}  // namespace slosh::external_run_section_test
