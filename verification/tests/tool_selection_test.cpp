// Parts of campaigns, cases in words, and orders of convergence, as a user asks the tool for them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "verification/tests/small_campaign.hpp"

namespace slosh::tool_selection_test {
namespace {

namespace fs = std::filesystem;

class ToolSelection : public SmallCampaign {
 protected:
  static std::string two_candidates() {
    return particles_case +
           with(with(particles_run, "\"particles\"", "\"coarser\""), "0.025", "0.05") +
           gate_on("coarser");
  }
  Ended only(const std::string& command, const std::string& pattern) const {
    return typed(command + " ./surges.toml --output out --only " + pattern);
  }
};

TEST_F(ToolSelection, RunsAndJudgesOnlyWhatAPatternNamesWithItsReference) {
  write_campaign(two_candidates());
  const Ended run = only("campaign", "sm*/part*");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(holds(run.out, "1 of 1 gate rows hold, 1 not selected."));
  EXPECT_EQ(run.out.find("coarser"), std::string::npos);
  EXPECT_TRUE(fs::exists(result("particles")) && fs::exists(result("theory")));
  EXPECT_FALSE(fs::exists(result("coarser")));
  const fs::path selected = directory() / "out/selected";
  EXPECT_TRUE(holds(read(selected / "report/index.html"), "Small surges (only sm*/part*)"));
  EXPECT_TRUE(holds(read(selected / "report/index.html"), "--only &apos;sm*/part*&apos;"));
  EXPECT_FALSE(fs::exists(report())) << "a part passes for the whole";

  EXPECT_EQ(only("campaign --report-only", "small/particles").out.substr(0, 4), "pass");
  EXPECT_EQ(only("gate", "small/particles").status, 0);
  EXPECT_TRUE(holds(read(selected / "gate/junit.xml"), "skipped=\"1\""));
  EXPECT_EQ(only("gate --selftest", "small/particles").status, 0);
  EXPECT_EQ(only("gate --selftest", "small/coarser").status, 4);
  EXPECT_EQ(only("campaign --report-only", "small/coarser").status, 4) << "it has no result";
}

TEST_F(ToolSelection, RefusesAPatternOrATagThatMatchesNothingBeforeAnythingRuns) {
  write_campaign(particles_case);
  const Ended pattern = only("campaign", "small/partickles");
  EXPECT_EQ(pattern.status, 2);
  EXPECT_TRUE(holds(pattern.err,
                    "small/partickles matches nothing: expected a pattern that matches "
                    "a name or a CASE/RUN; nearest: small/particles"));
  EXPECT_EQ(tool({"campaign", "./surges.toml", "--output", "out", "--tag", "surge"}).status, 2);
  EXPECT_FALSE(fs::exists(directory() / "out"));
}

TEST_F(ToolSelection, RefusesAPatternThatMatchesNothingBeforeAnyRunIsSetUp) {
  write_campaign(with(particles_case, "\"recommended\"", "\"unheard_of\""));
  EXPECT_TRUE(
      holds(only("gate", "particles").err, "particles matches nothing: expected a pattern"));
  EXPECT_TRUE(holds(only("gate", "small").err, "unheard_of"));
}

TEST_F(ToolSelection, RunsAProblemWithoutTheOthersAndTheCases) {
  const Ended run = tool({"campaign", "verification", "--only", "rigid_rotation", "-o", "out"});
  EXPECT_EQ(run.status, 0) << run.err << run.out;
  EXPECT_TRUE(fs::exists(directory() / "out/problems/rigid_rotation.json"));
  EXPECT_FALSE(fs::exists(directory() / "out/problems/taylor_green.json"));
  EXPECT_FALSE(fs::exists(directory() / "out/runs"));
}

TEST_F(ToolSelection, ListsWhatPatternsAndTagsNameAsTextJsonOrNames) {
  const Ended text = tool({"list", "li2010_large_*/recommended_10mm", "rigid_rotation"});
  EXPECT_TRUE(holds(text.out, "  li2010_large_b075 "));
  EXPECT_TRUE(holds(text.out, "      recommended_10mm\n"));
  EXPECT_TRUE(holds(text.out, "problems:\n  rigid_rotation "));
  EXPECT_EQ(text.out.find("linear"), std::string::npos);
  EXPECT_EQ(text.out.find("campaigns:"), std::string::npos);
  const auto json = nlohmann::json::parse(tool({"list", "--tag", "ramp", "--json"}).out);
  ASSERT_EQ(json["cases"].size(), 1u);
  EXPECT_EQ(json["cases"][0]["name"], "li2010_small_amplitude_ramp");
  EXPECT_EQ(json["cases"][0]["runs"][0]["solver"], "linear");
  EXPECT_TRUE(holds(tool({"list", "small_*"}).out, "campaigns:\n  small_amplitude "));
  EXPECT_EQ(tool({"list", "smal_amplitude"}).status, 2);
  EXPECT_TRUE(holds(tool({"list", "smal_amplitude"}).err, "nearest: small_amplitude"));
}

TEST_F(ToolSelection, ExplainsEveryShippedCaseInLinesOfEightyColumns) {
  const auto listed = nlohmann::json::parse(tool({"list", "--json"}).out);
  int explained = 0;
  for (const nlohmann::json& one : listed.at("cases")) {
    const std::string name = one.at("name");
    if (name == "extreme_million_particles") continue;  // whose start takes its time
    ++explained;
    const Ended run = tool({"explain", name});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char* part : {"Flow\n", "Runs and their costs\n", "Gate rows\n"})
      EXPECT_TRUE(holds(run.out, part));
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);)
      EXPECT_TRUE(line.size() <= 80 || line.starts_with("drawings: ") ||
                  line.starts_with("doubtful: "))
          << line;  // a path is as long as it is
  }
  EXPECT_GT(explained, 30);
}

TEST_F(ToolSelection, ExplainsWhatIsSolvedByWhatAndWhatGates) {
  write_campaign(particles_case);
  const Ended run = tool({"explain", "./small.toml"});
  EXPECT_EQ(run.status, 0) << run.err;
  for (const char* part :
       {"1 m long, 1 m high", "surge X = 0.02 m sin(3 rad/s t)", "4.966 rad/s",
        "linear potential flow, 500 modes", "spacing 25 mm, 560 particles: core-seconds",
        "steps: 1.43 ms each: ", "terms: Kaiser-Bessel",
        "  particles: error of the amplitude of elevation@right (forced) against theory\n"
        "  must not exceed 30 % either way.\n      The runs are coarse. [made for a test]\n"})
    EXPECT_TRUE(holds(run.out, part));
}

TEST_F(ToolSelection, TellsTheOrderOfASchemesErrorsOverItsSpacings) {
  write_campaign(particles_case);
  const std::vector<std::string> asked{"converge",   "./small.toml",     "--candidate", "particles",
                                       "--spacings", "0.05,0.035,0.025", "-o",          "orders"};
  const Ended run = tool(asked);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(holds(run.out, "small: elevation@right against theory\n"));
  EXPECT_TRUE(holds(run.out, "whole normalised_rms of elevation@right\n        50 mm "));
  std::vector<std::string> as_json = asked;
  as_json.push_back("--json");
  const Ended again = tool(as_json);
  EXPECT_EQ(again.err, "") << "a run was started";
  const auto json = nlohmann::json::parse(again.out);
  EXPECT_EQ(json["reference"], "theory");
  ASSERT_EQ(json["metrics"].size(), 5u);
  const auto& rms = json["metrics"][4];
  EXPECT_EQ(rms["metric"], "normalised_rms");
  ASSERT_EQ(rms["values"].size(), 3u);
  EXPECT_GT(rms["values"][0]["value"], rms["values"][2]["value"]) << "coarse to fine";
  EXPECT_GT(rms["uncertainty_95"], 0);
}

TEST_F(ToolSelection, TellsWhyAnErrorHasNoOrder) {
  write_campaign(particles_case);
  const Ended run = tool({"converge", "./small.toml", "--family", "recommended", "--spacings",
                          "0.05,0.035,0.025", "--quantity", "momentum_x", "-o", "orders"});
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(holds(run.out, "not measured: whole normalised_rms: "));
}

TEST_F(ToolSelection, RefusesAStudyOfConvergenceThatCannotBeMade) {
  write_campaign(particles_case);
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"--family", "recommended", "--spacings", "0.05,0.025"},
       "spacings = 0.05, 0.025: expected three numbers or more, each > 0 and given once, in m"},
      {{"--family", "recommended", "--spacings", "0.05,0.05,0.025"}, "given once"},
      {{"--family", "recommended", "--spacings", "0.11,0.05,0.025"},
       "particle_spacing = 0.11 m: expected"},
      {{"--family", "recomended", "--spacings", "0.05,0.035,0.025"}, "scheme = \"recomended\""},
      {{"--candidate", "partikles", "--spacings", "0.05,0.035,0.025"}, "nearest: particles"},
      {{"--candidate", "theory", "--spacings", "0.05,0.035,0.025"},
       "expected a run of one particle spacing"},
      {{"--spacings", "0.05,0.035,0.025"}, "expected --candidate RUN or --family NAME"},
      {{"--family", "recommended", "--spacings", "0.05,0.035,0.025", "--reference", "teory"},
       "nearest: theory"},
      {{"--family", "recommended", "--spacings", "0.05,0.035,0.025", "--quantity", "moment"},
       "quantity = moment: expected one of elevation@right"}};
  for (const auto& [options, message] : wrong) {
    std::vector<std::string> arguments{"converge", "./small.toml", "-o", "orders"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ended run = tool(arguments);
    EXPECT_EQ(run.status, 2) << ::testing::PrintToString(options);
    EXPECT_TRUE(holds(run.err, message));
    EXPECT_FALSE(fs::exists(directory() / "orders/runs"));
  }
}

}  // namespace
}  // namespace slosh::tool_selection_test
