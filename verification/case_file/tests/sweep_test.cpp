#include "verification/case_file/sweep.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "verification/case/ensemble.hpp"
#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/small_campaign.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::sweep_test {
namespace {

const std::string head =
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

class Sweep : public ::testing::Test {
 protected:
  Sweep() { std::ofstream(directory.path() / "small.toml") << particles_case; }

  CampaignDefinition campaign(const std::string& text) const {
    std::ofstream(directory.path() / "swept.toml") << head << text;
    return read_campaign(directory.path() / "swept.toml", directory.path(), {});
  }
  CaseDefinition swept(const std::string& text) const {
    CaseDefinition definition = read_case(directory.path() / "small.toml");
    const CampaignDefinition swept = campaign(text);
    add_swept_runs(swept, "", definition);
    require_swept_cases(swept, {definition});
    return definition;
  }
  // The rows' mistakes, made in the campaign of this text.
  void refuse(const std::string& text, const std::string& rows) const {
    Trial trial(head + text);
    trial.complaint = [&](const std::filesystem::path& file) {
      std::ifstream stream(file);
      const std::string changed{std::istreambuf_iterator<char>(stream), {}};
      try {
        swept(changed.substr(head.size()));
        return std::string();
      } catch (const CaseFileError& error) {
        return "trial" +
               std::string(error.what()).substr((directory.path() / "swept").string().size());
      }
    };
    expect_refusals(trial, rows);
  }

  TemporaryDirectory directory;
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
sweep.cases = ["sm*", "smal"] -> sweep.cases = "smal": expected a case of the campaign
sweep.cases = [] -> sweep.cases = (an array): expected a case of the campaign
sweep.cases = ["sm*", "small"]: accepted
)");
}

TEST_F(Sweep, RefusesAKeyThatNoRunHas) {
  EXPECT_TRUE(
      holds(message_of<CaseFileError>([&] { swept(with(sweep, "courant_number", "courant")); }),
            "nearest known key"));
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
}

TEST_F(Sweep, RefusesTwoRunsOfAMethodAtOneSpacing) {
  refuse(programs, R"(
sweep.name = "{time_limit_s}_{particle_spacing_m}" & sweep.time_limit_s = [1, 2] &
  sweep.particle_spacing_m = 0.05: expected a spacing that no other run of the method has; 1_0p05 has
  this one
)");
}

TEST_F(Sweep, IsReadWithTheCampaignsTiming) {
  const TimingDefinition timing =
      campaign("[timing]\nrepeats = 3\nlongest_run_s = 5\nonly = [\"small/*\"]\n").timing;
  EXPECT_EQ(timing.repeats, 3);
  EXPECT_EQ(timing.longest_run, 5);
  EXPECT_EQ(timing.only, std::vector<std::string>{"small/*"});
  EXPECT_THROW(campaign("[timing]\nrepeats = 0\n"), CaseFileError);
  EXPECT_THROW(campaign("[timing]\nrepeat = 1\n"), CaseFileError);
}

}  // namespace
}  // namespace slosh::sweep_test
