// The list of problems, and the shipped campaigns over them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

#include "verification/case_file/campaign_parser.hpp"
#include "verification/problems/drop_motion.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/problems/problem_result.hpp"
#include "verification/runs/tests/key_question.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::problem_test {
namespace {

// Of both campaigns that have problems.
std::vector<ProblemDefinition> shipped() {
  const std::filesystem::path verification =
      std::filesystem::path(SLOSH_SOURCE_DIR) / "verification";
  std::vector<ProblemDefinition> problems;
  for (const char* name : {"campaigns/verification.toml", "campaigns/stability.toml"}) {
    const CampaignDefinition campaign =
        read_campaign(verification / name, verification / "cases", known_problems());
    problems.insert(problems.end(), campaign.problems.begin(), campaign.problems.end());
  }
  return problems;
}

TEST(Problems, HaveNamesOfTheirOwnAndMeasuresOfTheirOwn) {
  std::set<std::string> names;
  for (const Problem& problem : all_problems()) {
    EXPECT_TRUE(names.insert(problem.name).second) << problem.name;
    std::set<std::string> measures;
    for (const MeasureKind& kind : problem.measures)
      EXPECT_TRUE(measures.insert(kind.name).second) << kind.name;
    EXPECT_FALSE(measures.empty()) << problem.name;
  }
  EXPECT_EQ(find_problem("taylor_green").name, "taylor_green");
}

TEST(Problems, AreSuggestedWhereANameIsWrong) {
  EXPECT_TRUE(holds(message_of<std::invalid_argument>([] { find_problem("taylor_gren"); }),
                    "nearest: taylor_green"));
}

TEST(ShippedCampaigns, GateEveryProblemOnceAndEveryGateRowHasASource) {
  std::set<std::string> names;
  for (const ProblemDefinition& problem : shipped()) EXPECT_TRUE(names.insert(problem.name).second);
  EXPECT_EQ(names.size(), all_problems().size());
  for (const ProblemDefinition& problem : shipped())
    for (const ProblemGateRow& row : problem.gate) EXPECT_GT(row.source.size(), 8u);
}

// A problem's result file: what is written is read, and nothing else is taken for one.

ProblemResult sample() {
  ProblemResult result;
  result.problem = "rigid_rotation";
  result.quick = true;
  result.key = "1-2";
  result.provenance = {{"command", "./slosh run rigid_rotation"}};
  result.cost.user_time = 1.5;
  result.outcome.measures = {
      {"slope", {{0.1, 1.0 / 3}, {0.05, std::numeric_limits<double>::quiet_NaN()}}}};
  reports::Figure figure;
  figure.id = "shapes";
  figure.curves = {{"one", {0, 1}, {2, 3}, {}, reports::Curve::Style::dashed}};
  figure.log_y = true;
  result.outcome.figures = {figure};
  result.outcome.tables = {{"limits", "Limits", "", {"C", "how"}, {{"1.4", "stable"}}}};
  return result;
}

class ProblemResultFile : public ::testing::Test {
 protected:
  std::filesystem::path file() const { return temporary_.path() / "new" / "result.json"; }
  std::string text() const {
    std::ifstream stream(file());
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void rewrite(const std::string& text) const { std::ofstream(file()) << text; }

  TemporaryDirectory temporary_;
};

TEST_F(ProblemResultFile, IsReadAsItWasWritten) {
  write_problem_result(sample(), file());
  const ProblemResult read = read_problem_result(file());
  EXPECT_EQ(read.problem, "rigid_rotation");
  EXPECT_TRUE(read.quick);
  EXPECT_EQ(read.key, "1-2");
  EXPECT_EQ(read.provenance, sample().provenance);
  EXPECT_EQ(read.cost.user_time, 1.5);
  ASSERT_EQ(read.outcome.measures.size(), 1u);
  EXPECT_EQ(read.outcome.measures[0].errors[0].error, 1.0 / 3);
  EXPECT_TRUE(std::isnan(read.outcome.measures[0].errors[1].error));
  ASSERT_EQ(read.outcome.figures.size(), 1u);
  EXPECT_EQ(read.outcome.figures[0].curves[0].y, (std::vector<double>{2, 3}));
  EXPECT_EQ(read.outcome.figures[0].curves[0].style, reports::Curve::Style::dashed);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file().parent_path()), {}), 1);
}

TEST_F(ProblemResultFile, IsRefusedWhereItIsAbsentTruncatedOrAltered) {
  EXPECT_THROW(read_problem_result(file()), ResultError);
  write_problem_result(sample(), file());
  const std::string whole = text();
  rewrite(whole.substr(0, whole.size() / 2));
  EXPECT_THROW(read_problem_result(file()), ResultError);
  std::string altered = whole;
  altered.replace(altered.find("0.05"), 4, "0.06");
  rewrite(altered);
  EXPECT_THROW(read_problem_result(file()), ResultError);
  rewrite("{}");
  EXPECT_THROW(read_problem_result(file()), ResultError);
  rewrite(whole);
  EXPECT_NO_THROW(read_problem_result(file()));
}

TEST_F(ProblemResultFile, IsKeyedByProblemFormAndBuild) {
  const std::filesystem::path& builds = temporary_.path();
  std::ofstream(builds / "problems") << "one";
  const Problem& rotation = find_problem("rigid_rotation");
  const std::string key = problem_key(rotation, true, builds);
  EXPECT_EQ(key, problem_key(rotation, true, builds));
  EXPECT_FALSE(asks_the_same(key, problem_key(rotation, false, builds)));
  EXPECT_FALSE(asks_the_same(key, problem_key(find_problem("taylor_green"), true, builds)));
  std::ofstream(builds / "problems") << "two";
  EXPECT_NE(key, problem_key(rotation, true, builds));
  EXPECT_TRUE(asks_the_same(key, problem_key(rotation, true, builds)));
}

// The exact motion of the drop: invariants, and the periods and the span of its axis that an
// integration by other means gives.

TEST(DropMotion, HasTheKnownPeriods) {
  const double known[][2] = {{0.1, 4.4484}, {0.5, 4.5674}, {1, 4.8273}, {1.5, 5.0799}};
  for (const auto& [amplitude, period] : known)
    EXPECT_NEAR(drop_period(amplitude), period, 1e-4) << amplitude;
}

TEST(DropMotion, SpansTheKnownSemiAxis) {
  SemiAxes axes{1, 1, 1};
  double least = 1, most = 1;
  for (int i = 0; i < 1000; ++i) {
    axes = advanced(axes, 0.005);
    least = std::min(least, axes.a);
    most = std::max(most, axes.a);
  }
  EXPECT_NEAR(least, 0.5176, 1e-4);
  EXPECT_NEAR(most, 1.9319, 1e-4);
}

// Energy: kinetic sigma^2 (a^2 + b^2) / 8 and that of the force (a^2 + b^2) / 8.
TEST(DropMotion, KeepsTheAreaAndTheEnergy) {
  const SemiAxes end = advanced({1, 1, 1.5}, 7.3);
  EXPECT_NEAR(end.a * end.b, 1, 1e-10);
  EXPECT_NEAR((end.sigma * end.sigma + 1) * (end.a * end.a + end.b * end.b), 2 * (1.5 * 1.5 + 1),
              1e-9);
}

}  // namespace
}  // namespace slosh::problem_test
