// The campaign parser: the shipped campaigns and each kind of mistake.
#include "verification/case_file/campaign_parser.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "verification/case/ensemble.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/small_case.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::campaign_parser_test {
namespace {

namespace fs = std::filesystem;

const fs::path cases = fs::path(SLOSH_SOURCE_DIR) / "verification/cases";
const fs::path campaigns = fs::path(SLOSH_SOURCE_DIR) / "verification/campaigns";

const std::vector<KnownProblem> problems{{"eddy", {{"velocity", "m/s"}, {"decay_rate", "1"}}},
                                         {"drop", {{"period", "1"}}}};

const std::string head =
    "schema_version = 1\nname = \"trial\"\ntitle = \"A trial\"\nsource = \"none\"\n";

// What the reader says of the file, without its directory; "" when nothing is wrong.
template <class Read>
std::string said_of(const fs::path& file, const Read& read) {
  const std::string message = message_of<CaseFileError>(read);
  return message.empty() ? "" : message.substr(file.parent_path().string().size() + 1);
}

class CampaignParser : public ::testing::Test {
 protected:
  CampaignDefinition read(const std::string& text) const {
    return read_campaign(workspace_.write("trial.toml", text), cases, problems);
  }
  std::string complaint(const std::string& text) const {
    return said_of(workspace_.path() / "trial.toml", [&] { read(text); });
  }
  // The rows' mistakes, made in this campaign.
  void refuse(const std::string& text, const std::string& rows) const {
    Trial trial(text);
    trial.complaint = [](const fs::path& file) {
      return said_of(file, [&] { read_campaign(file, cases, problems); });
    };
    expect_refusals(trial, rows);
  }

  const Workspace workspace_;
};

TEST_F(CampaignParser, ReadsTheShippedCampaignWhoseCasesAllParse) {
  const CampaignDefinition campaign =
      read_campaign(find_campaign("small_amplitude", campaigns), cases, problems);
  EXPECT_EQ(campaign.name, "small_amplitude");
  ASSERT_EQ(campaign.cases.size(), 6u);
  EXPECT_EQ(campaign.cases.front().stem(), "li2010_small_amplitude");
  EXPECT_EQ(campaign.cases.back().stem(), "li2010_resonant_T13_b050");
  for (const fs::path& file : campaign.cases) EXPECT_NO_THROW(read_case(file)) << file;
}

TEST_F(CampaignParser, TellsAllMistakesAtOnce) {
  const std::string message = complaint(
      "schema_version = 1\nname = \"a b\"\ntitle = \"\"\nsource = \"none\"\n"
      "cases = [\"one\", \"li2010_small_amplitude\", \"other\"]\n"
      "[timing]\nrepeats = 0\nlongest_run_s = -1\n");
  std::vector<std::string> told;
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("trial.toml:");
    told.push_back(line.substr(at, line.find_first_of(" =", at + 14) - at));
  }
  EXPECT_EQ(told,
            (std::vector<std::string>{
                "trial.toml:2: name", "trial.toml:3: title", "trial.toml:7: timing.repeats",
                "trial.toml:8: timing.longest_run_s", "trial.toml:5: case", "trial.toml:5: case"}))
      << message;
}

TEST_F(CampaignParser, TakesPathsRelativeToTheCampaign) {
  workspace_.write("own.toml", "not read here");
  const auto campaign =
      read(head + "paper = \"li2010\"\ncases = [\"own.toml\", \"li2010_small_amplitude\"]\n");
  EXPECT_EQ(campaign.paper, "li2010");
  EXPECT_EQ(campaign.cases.at(0), workspace_.path() / "own.toml");
  EXPECT_EQ(campaign.cases.at(1), cases / "li2010_small_amplitude.toml");
}

TEST_F(CampaignParser, RefusesEachKindOfMistakeWithItsPlace) {
  refuse(head + "cases = [\"li2010_small_amplitude\"]\n", R"(
cases is missing: expected an array of texts
cases = [] -> cases = (an array): expected at least one case
tag = 1: expected only these keys here: schema_version, name, title, source, paper, cases, problem,
  sweep, timing; nearest known key: name
schema_version = 3: expected 1
paper = "another": expected a paper, one of li2010, zhao2021
)");
  const auto refused = [&](const std::string& list, const char* message) {
    EXPECT_TRUE(begins(complaint(head + list), message));
  };
  refused("cases = [\n\"li2010_small_amplitude\",\n\"li2010_small_amplitude\"]\n",
          "trial.toml:7: case = \"li2010_small_amplitude\": expected each case once");
  refused("cases = [\"no.toml\"]\n", "trial.toml:5: case = \"no.toml\": expected a file");
  refused("cases = [", "trial.toml:5:");
}

const std::string eddy = "[[problem]]\nname = \"eddy\"\n";
const std::string gate_head = "[[problem.gate]]\nmeasure = \"velocity\"\n";
const std::string reasons = "reason = \"a reason\"\nsource = \"a source\"\n";
const std::string order_row =
    gate_head + "metric = \"order_at_least\"\nunit = \"1\"\nlimit = 1.9\n" + reasons;
const std::string error_row =
    gate_head + "metric = \"largest_error\"\nunit = \"m/s\"\nlimit = 0.1\n" + reasons;
const std::string within_row = gate_head +
                               "metric = \"order_within\"\nunit = \"1\"\nlower = -1.2\n"
                               "upper = -0.8\n" +
                               reasons;

TEST_F(CampaignParser, ReadsProblemsWithTheirGateRows) {
  const auto campaign =
      read(head + eddy + order_row + error_row + within_row + "kind = \"regression\"\n");
  EXPECT_TRUE(campaign.cases.empty());
  ASSERT_EQ(campaign.problems.size(), 1u);
  EXPECT_EQ(campaign.problems[0].name, "eddy");
  const auto& gate = campaign.problems[0].gate;
  ASSERT_EQ(gate.size(), 3u);
  EXPECT_EQ(gate[0].metric, ProblemMetric::order_at_least);
  EXPECT_EQ(gate[0].limit, 1.9);
  EXPECT_EQ(gate[0].where.line, 7);
  EXPECT_EQ(gate[1].unit, "m/s");
  EXPECT_EQ(gate[2].between, std::pair(-1.2, -0.8));
  EXPECT_EQ(gate[0].kind, RowKind::validation);
  EXPECT_EQ(gate[2].kind, RowKind::regression);
}

TEST_F(CampaignParser, RefusesEachKindOfMistakeInAProblem) {
  refuse(head + eddy + order_row, R"(
problem.gate.kind = "regresion": expected what the limit comes from, one of validation, regression;
  nearest: regression
problem.name = "edy": expected a problem, one of eddy, drop; nearest: eddy
problem.gate.measure = "velocty": expected a measure of eddy, one of velocity, decay_rate; nearest:
  velocity
problem.gate.metric = "order": expected a metric, one of order_at_least, order_within,
  error_at_finest, largest_error; nearest: order
problem.gate.unit = "m/s": expected the unit of order_at_least, which is 1
problem.gate.limit is missing & problem.gate.lower = 1.9 -> problem.gate.limit is missing: expected
  limit alone
)");
  refuse(head + eddy + error_row, R"(
problem.gate.unit = "1": expected the unit of largest_error, which is m/s
problem.gate.limit = 1e+300: expected a number > 0 and below 1e+09, in m/s: a wider limit holds any
  error
)");
  refuse(head + eddy + within_row, R"(
problem.gate.upper = 1e+300: expected a number above lower (-1.2) and below 0.8: a wider range holds
  any order
problem.gate.lower is missing & problem.gate.limit = 1: expected lower and upper, and no limit
)");
  refuse(head + eddy, "-> problem.gate is missing: expected at least one");
  refuse(head + eddy + order_row + eddy + order_row, R"(
-> problem.name = "eddy": expected each problem once
)");
  refuse(head + eddy + order_row + order_row, R"(
problem.gate.limit = 0.1 -> problem.gate = a second bound on order_at_least of velocity: expected
  each metric of a measure once; the first is on line 7
)");
}

TEST_F(CampaignParser, NamesTheNearestCaseAndTheNearestCampaign) {
  const std::string message = complaint(head + "cases = [\n\"li2010_small_amplitud\"]\n");
  EXPECT_TRUE(begins(message, "trial.toml:6: case = \"li2010_small_amplitud\": expected"));
  EXPECT_TRUE(holds(message, "nearest: li2010_small_amplitude, "));
  EXPECT_TRUE(holds(message_of<CaseFileError>([&] { find_campaign("smal_amplitude", campaigns); }),
                    "nearest: small_amplitude"));
}

const std::string swept_head =
    "schema_version = 1\nname = \"swept\"\ntitle = \"t\"\nsource = \"s\"\ncases = "
    "[\"./small.toml\"]\n";
const std::string sweep = R"([[sweep]]
cases = ["sm*"]
name = "{scheme}_{particle_spacing_m}"
solver = "sph"
scheme = ["recommended", "delta_sph"]
particle_spacing_m = [0.05, 0.025]
courant_number = 0.5
)";
const std::string row = R"([[sweep.gate]]
reference = "theory"
quantity = "elevation@right"
mode = "forced"
metric = "amplitude_error"
unit = "1"
limit = 0.5
reason = "The runs are coarse."
source = "made for a test"
)";

// The case beside the campaign, with the runs that it adds.
CaseDefinition swept_by(const fs::path& campaign) {
  CaseDefinition definition = read_case(campaign.parent_path() / "small.toml");
  const CampaignDefinition swept = read_campaign(campaign, campaign.parent_path(), {});
  add_swept_runs(swept, definition);
  require_swept_cases(swept, {definition});
  return definition;
}

class Sweep : public ::testing::Test {
 protected:
  fs::path campaign(const std::string& text) const {
    workspace_.write("small.toml", particles_case);
    return workspace_.write("swept.toml", swept_head + text);
  }
  CaseDefinition swept(const std::string& text) const { return swept_by(campaign(text)); }
  // The rows' mistakes, made in the campaign of this text.
  void refuse(const std::string& text, const std::string& rows) const {
    Trial trial(swept_head + text, {{"small.toml", particles_case}});
    trial.complaint = [](const fs::path& file) { return said_of(file, [&] { swept_by(file); }); };
    expect_refusals(trial, rows);
  }

  const Workspace workspace_;
};

TEST_F(Sweep, AddsEveryCombinationOfWhatItLists) {
  const CaseDefinition definition = swept(sweep);
  std::vector<std::string> names;
  for (const RunDefinition& run : definition.runs) names.push_back(run.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"theory", "particles", "recommended_0p05", "delta_sph_0p05",
                                      "recommended_0p025", "delta_sph_0p025"}));
  const auto& sph = std::get<SphRun>(run_named(definition, "delta_sph_0p025").solver);
  EXPECT_EQ(sph.scheme, "delta_sph");
  EXPECT_EQ(sph.particle_spacing, 0.025);
  EXPECT_EQ(sph.numbers.courant_number, 0.5);
  EXPECT_EQ(definition.gate.size(), 1u) << "the case's own";
}

TEST_F(Sweep, GatesEachOfItsRunsAndSaysWhere) {
  const CaseDefinition definition = swept(sweep + row);
  ASSERT_EQ(definition.gate.size(), 5u);
  EXPECT_EQ(definition.gate[1].candidate, "recommended_0p05");
  EXPECT_EQ(definition.gate[4].candidate, "delta_sph_0p025");
  EXPECT_EQ(definition.gate[4].limit, 0.5);
  EXPECT_TRUE(holds(definition.gate[4].where.file, "swept.toml"));
  EXPECT_EQ(definition.gate[4].where.line, 13);
}

TEST_F(Sweep, RefusesWhatARunOrARowOfACaseWouldWithItsOwnLine) {
  refuse(sweep + row, R"(
sweep.particle_spacing_m = [0.05, -1] -> sweep.particle_spacing_m = -1: expected
sweep.particle_spacing_m = [] -> sweep.particle_spacing_m = (an array): expected a value, or an array of
  at least one
sweep.gate.reference = "teory": expected
sweep.gate.candidate = "theory": expected no such key in [[sweep.gate]]
sweep.gate.candidates = ["*"] -> sweep.gate.candidates = (an array): expected no such key in
  [[sweep.gate]]
sweep.name = "{particle_spacing_m}": expected ... names each run apart
sweep.name = "{schema}_{particle_spacing_m}": expected ... there is no schema
sweep.cases = ["big*"] -> sweep.cases = "big*": expected a case of the campaign or a pattern of them
sweep.cases = [] -> sweep.cases = (an array): expected a case of the campaign
sweep.cases = ["sm*", "small"]: accepted
)");
}

TEST_F(Sweep, MayRepeatEachOfItsRunsUnderOneRow) {
  const CaseDefinition definition = swept(sweep + "start_disorder = 1e-6\nrepeats = 2\n" + row);
  EXPECT_EQ(members_of(definition, "recommended_0p05"),
            (std::vector<std::string>{"recommended_0p05", "recommended_0p05_2"}));
  for (const GateRow& one : definition.gate)
    EXPECT_FALSE(is_later_member(run_named(definition, one.candidate))) << one.candidate;
}

const std::string programs = R"([[sweep]]
cases = ["small"]
name = "mine_{particle_spacing_m}"
solver = "external"
command = ["./solve", "--dp={particle_spacing_m}"]
method = "mine"
particle_spacing_m = [0.05, 0.025]
[[sweep.series]]
quantity = "elevation@right"
file = "wave.csv"
format = "csv"
time_column = "t"
column = "eta"
)";

// A command is a list by itself, and no axis of the sweep.
TEST_F(Sweep, GivesOneCommandOfAProgramItsSpacings) {
  const CaseDefinition definition = swept(programs);
  std::vector<std::string> names;
  for (const RunDefinition& run : definition.runs) names.push_back(run.name);
  EXPECT_EQ(names, (std::vector<std::string>{"theory", "particles", "mine_0p05", "mine_0p025"}));
  const auto& mine = std::get<ExternalRun>(run_named(definition, "mine_0p025").solver);
  EXPECT_EQ(mine.command, (std::vector<std::string>{"./solve", "--dp={particle_spacing_m}"}));
  EXPECT_EQ(mine.particle_spacing, 0.025);
  EXPECT_EQ(mine.method, "mine");
  ASSERT_EQ(mine.series.size(), 1u);
  refuse(programs, R"(
sweep.name = "{time_limit_s}_{particle_spacing_m}" & sweep.time_limit_s = [1, 2] &
  sweep.particle_spacing_m = 0.05: expected a spacing that no other run of the method has; 1_0p05 has
  this one
)");
}

TEST_F(Sweep, IsReadWithTheCampaignsTiming) {
  const auto timing_of = [&](const std::string& text) {
    return read_campaign(campaign(text), workspace_.path(), {}).timing;
  };
  const TimingDefinition timing =
      timing_of("[timing]\nrepeats = 3\nlongest_run_s = 5\nonly = [\"small/*\"]\n");
  EXPECT_EQ(timing.repeats, 3);
  EXPECT_EQ(timing.longest_run, 5);
  EXPECT_EQ(timing.only, std::vector<std::string>{"small/*"});
  EXPECT_THROW(timing_of("[timing]\nrepeats = 0\n"), CaseFileError);
  EXPECT_THROW(timing_of("[timing]\nrepeat = 1\n"), CaseFileError);
}

}  // namespace
}  // namespace slosh::campaign_parser_test
