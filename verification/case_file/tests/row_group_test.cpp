// Gate rows that are written as a group: they are the rows that one would write out.
#include "verification/case_file/groups/row_group.hpp"

#include <gtest/gtest.h>

#include "verification/case/metric_table.hpp"
#include "verification/case_file/campaign_parser.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::row_group_test {
namespace {

// The trial case without its row, with the runs theory, coarse, mesh, fine_1 and fine_2.
const std::string head = valid_text.substr(0, valid_text.find("[[gate]]")) +
                         "[[run]]\nname = \"fine_1\"\nsolver = \"sph\"\nscheme = \"any\"\n"
                         "particle_spacing_m = 0.01\n"
                         "[[run]]\nname = \"fine_2\"\nsolver = \"sph\"\nscheme = \"any\"\n"
                         "particle_spacing_m = 0.005\n";
const std::string group = R"([[gate]]
candidates = ["fine_*", "coarse"]
reference = "theory"
limits.normalised_rms = 0.2
limits.amplitude_error = { lower = -0.1, upper = 0.05, reason = "its own reason" }
limits.phase_lag = 5
reason = "a reason"
source = "a source"
)";
const int first_line = 1 + static_cast<int>(std::count(head.begin(), head.end(), '\n'));

std::string changed(const std::string& from, const std::string& to) {
  std::string text = group;
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("no such text: " + from);
  return text.replace(at, from.size(), to);
}

std::string refusal(const std::string& gate) {
  const Workspace workspace;
  return complaint(workspace.write("trial.toml", head + gate));
}

std::vector<GateRow> rows(const std::string& gate) { return read_text(head + gate).gate; }

std::string named(const GateRow& row) {
  return row.candidate + " " + metric_name(row.metric) + " " + row.mode;
}

std::string text_of(const GateRow& row) {
  return named(row) + " " + row.reference + " " + row.quantity + " " + row.unit + " " +
         (row.limit ? std::to_string(*row.limit) : "-") + " " +
         (row.between ? std::to_string(row.between->first) + std::to_string(row.between->second)
                      : "-") +
         " " + kind_name(row.kind) + " " + row.reason + " " + row.source;
}

std::vector<std::string> names(const std::string& gate) {
  std::vector<std::string> all;
  for (const GateRow& row : rows(gate)) all.push_back(named(row));
  return all;
}

TEST(RowGroup, HasARowForEachRunAndEachMetricInTheOrderOfTheFile) {
  EXPECT_EQ(names(group), (std::vector<std::string>{
                              "fine_1 normalised_rms whole", "fine_1 amplitude_error forced",
                              "fine_1 phase_lag forced", "fine_2 normalised_rms whole",
                              "fine_2 amplitude_error forced", "fine_2 phase_lag forced",
                              "coarse normalised_rms whole", "coarse amplitude_error forced",
                              "coarse phase_lag forced"}));
}

TEST(RowGroup, GivesTheRowsThatOneWouldWriteOut) {
  const std::string written = R"([[gate]]
candidate = "fine_2"
reference = "theory"
quantity = "elevation@right"
mode = "forced"
metric = "amplitude_error"
unit = "1"
lower = -0.1
upper = 0.05
reason = "its own reason"
source = "a source"
[[gate]]
candidate = "fine_2"
reference = "theory"
quantity = "elevation@right"
mode = "forced"
metric = "phase_lag"
unit = "deg"
limit = 5
reason = "a reason"
source = "a source"
)";
  const std::vector<GateRow> of_group = rows(group), single = rows(written);
  EXPECT_EQ(text_of(of_group[4]), text_of(single[0]));
  EXPECT_EQ(text_of(of_group[5]), text_of(single[1]));
}

TEST(RowGroup, TellsOfEachRowTheLineOfItsMetric) {
  const std::vector<GateRow> all = rows(group);
  EXPECT_EQ(all[0].where.line, first_line + 3);
  EXPECT_EQ(all[1].where.line, first_line + 4);
  EXPECT_EQ(all[8].where.line, first_line + 5);
}

TEST(RowGroup, HasARowForEachModeThatItLists) {
  EXPECT_EQ(names("[[gate]]\ncandidate = \"coarse\"\nreference = \"theory\"\n"
                  "modes = [\"natural_2\", \"forced\"]\nmetric = \"amplitude_error\"\n"
                  "limit = 0.1\nreason = \"r\"\nsource = \"s\"\n"),
            (std::vector<std::string>{"coarse amplitude_error natural_2",
                                      "coarse amplitude_error forced"}));
}

TEST(RowGroup, TakesARunThatTwoPatternsMatchOnceAndNeverTheReference) {
  const std::string all = changed("\"fine_*\", \"coarse\"", "\"fine_2\", \"*\"");
  const std::vector<std::string> found = names(all);
  ASSERT_EQ(found.size(), 12u) << "of fine_2, coarse, mesh and fine_1";
  EXPECT_EQ(found[0], "fine_2 normalised_rms whole");
  EXPECT_EQ(found[3], "coarse normalised_rms whole");
}

TEST(RowGroup, GivesItsReferenceToTheMetricsThatTakeOne) {
  const std::vector<GateRow> all =
      rows(changed("limits.phase_lag = 5", "limits.noise_share = 0.05"));
  EXPECT_EQ(all[1].reference, "theory");
  EXPECT_EQ(all[2].reference, "");
  EXPECT_EQ(all[2].quantity, "elevation@right");
  EXPECT_NE(refusal("[[gate]]\ncandidate = \"coarse\"\nreference = \"theory\"\n"
                    "limits = { noise_share = 0.05 }\nreason = \"r\"\nsource = \"s\"\n")
                .find("no reference"),
            std::string::npos);
}

TEST(RowGroup, NeedsNoSourceForARegression) {
  const std::string without = changed("source = \"a source\"\n", "");
  EXPECT_NE(refusal(without).find("source is missing"), std::string::npos) << refusal(without);
  const std::vector<GateRow> all = rows(without + "kind = \"regression\"\n");
  EXPECT_EQ(all[0].source, "measured before: the reason names it");
}

TEST(RowGroup, RefusesAPatternThatMatchesNoRunByItsName) {
  const std::string line = "trial.toml:" + std::to_string(first_line + 1);
  EXPECT_EQ(refusal(changed("fine_*", "fien_*")),
            line +
                ": gate.candidates = \"fien_*\": expected a run or a pattern of them, one of "
                "coarse, mesh, fine_1, fine_2");
  EXPECT_NE(refusal(changed("[\"fine_*\", \"coarse\"]", "[]")).find("gate.candidates"),
            std::string::npos);
  EXPECT_NE(refusal(changed("[\"fine_*\", \"coarse\"]", "\"fine_*\"")).find("an array of texts"),
            std::string::npos);
}

TEST(RowGroup, RefusesAMistakeOnceWithTheKeyAndTheLineWhereItIsWritten) {
  const auto at = [](int line, const std::string& rest) {
    return "trial.toml:" + std::to_string(first_line + line) + ": " + rest;
  };
  const std::string negative = refusal(changed("phase_lag = 5", "phase_lag = -5"));
  EXPECT_TRUE(negative.starts_with(at(5, "gate.limits.phase_lag = -5: expected a number > 0")))
      << negative;
  EXPECT_EQ(negative.find('\n'), std::string::npos) << negative;
  const std::string inverted = refusal(changed("upper = 0.05", "upper = -0.5"));
  EXPECT_TRUE(inverted.starts_with(at(4, "gate.limits.amplitude_error.upper = -0.5"))) << inverted;
  const std::string misspelt = refusal(changed("phase_lag", "phase_lga"));
  EXPECT_TRUE(misspelt.starts_with(at(5, "gate.limits.phase_lga = 5"))) << misspelt;
  EXPECT_NE(misspelt.find("nearest known key: phase_lag"), std::string::npos) << misspelt;
  const std::string unknown = refusal(changed("upper =", "uper ="));
  EXPECT_NE(unknown.find("nearest known key: upper"), std::string::npos) << unknown;
}

TEST(RowGroup, RefusesToSayOneThingTwice) {
  EXPECT_NE(refusal(group + "candidate = \"mesh\"\n").find("no such key beside candidates"),
            std::string::npos);
  EXPECT_NE(refusal(group + "metric = \"phase_lag\"\n").find("no such key beside limits"),
            std::string::npos);
  EXPECT_NE(refusal(group + "limit = 1\n").find("no such key beside limits"), std::string::npos);
  EXPECT_NE(refusal(group + "mode = \"forced\"\nmodes = [\"forced\"]\n").find("beside modes"),
            std::string::npos);
  EXPECT_NE(refusal(group + changed("fine_*", "fine_1")).find("a second bound on"),
            std::string::npos);
  EXPECT_NE(refusal("[[gate]]\ncandidate = \"mesh\"\nlimits = {}\n").find("at least one metric"),
            std::string::npos);
}

TEST(RowGroup, IsNotJudgedByItsPatternsWhereARunWasRefused) {
  std::string text = head + group;
  const std::string spacing = "particle_spacing_m = 0.005";
  text.replace(text.find(spacing), spacing.size(), "particle_spacing_m = -1");
  const Workspace workspace;
  const std::string found = complaint(workspace.write("trial.toml", text));
  EXPECT_NE(found.find("particle_spacing_m"), std::string::npos);
  EXPECT_EQ(found.find("gate"), std::string::npos) << found;
}

TEST(RowGroup, OfAProblemIsOfTheMeasuresThatItsPatternsMatch) {
  const Workspace workspace;
  const auto campaign = read_campaign(
      workspace.write("trial.toml",
                      "schema_version = 1\nname = \"trial\"\ntitle = \"t\"\nsource = \"s\"\n"
                      "[[problem]]\nname = \"kernels\"\n[[problem.gate]]\n"
                      "measures = [\"slope_*\"]\nlimits.order_at_least = 1.9\n"
                      "limits.error_at_finest = { limit = 0.001, kind = \"regression\" }\n"
                      "reason = \"r\"\nsource = \"s\"\n"),
      workspace.path(), {{"kernels", {{"slope_a", "1"}, {"norm_a", "1"}, {"slope_b", "m"}}}});
  const std::vector<ProblemGateRow>& all = campaign.problems.at(0).gate;
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[1].measure, "slope_a");
  EXPECT_EQ(all[1].kind, RowKind::regression);
  EXPECT_EQ(all[3].measure, "slope_b");
  EXPECT_EQ(all[3].metric, ProblemMetric::error_at_finest);
  EXPECT_EQ(all[3].unit, "m");
}

}  // namespace
}  // namespace slosh::row_group_test
