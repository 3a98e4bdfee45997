// Gate rows that are written as a group: they are the rows that one would write out.
#include <gtest/gtest.h>

#include "verification/case/field_times.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::gate_section_test {
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

TEST(RowGroup, GivesTheRowsThatOneWouldWriteOutWithTheLinesOfTheirMetrics) {
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
  EXPECT_EQ(of_group[0].where.line, first_line + 3);
  EXPECT_EQ(of_group[8].where.line, first_line + 5);
}

TEST(RowGroup, HasARowForEachModeThatItLists) {
  EXPECT_EQ(names("[[gate]]\ncandidate = \"coarse\"\nreference = \"theory\"\n"
                  "modes = [\"natural_3\", \"forced\"]\nmetric = \"amplitude_error\"\n"
                  "limit = 0.1\nreason = \"r\"\nsource = \"s\"\n"),
            (std::vector<std::string>{"coarse amplitude_error natural_3",
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
  expect_refusals(head + "[[gate]]\ncandidate = \"coarse\"\nreason = \"r\"\nsource = \"s\"\n", R"(
gate.limits = { noise_share = 0.05 } & gate.reference = "theory": expected no reference
gate.limits = {} -> gate.limits = (a table): expected at least one metric
)");
}

TEST(RowGroup, IsRefusedByTheKeyAndTheLineOfItsMistake) {
  expect_refusals(head + group, R"(
gate.candidates = ["fien_*", "coarse"] -> gate.candidates = "fien_*": expected a run or a pattern of
  them, one of coarse, mesh, fine_1, fine_2
gate.candidates = [] -> gate.candidates = (an array): expected
gate.candidates = "fine_*": expected an array of texts
gate.limits.phase_lag = -5: expected a number > 0
gate.limits.phase_lag is missing & gate.limits.phase_lga = 5: expected ... nearest known key: phase_lag
gate.limits.amplitude_error = { lower = -0.1, upper = -0.5 } -> gate.limits.amplitude_error.upper =
  -0.5: expected
gate.limits.amplitude_error = { lower = -0.1, uper = 0.5 } -> gate.limits.amplitude_error.uper = 0.5:
  expected ... nearest known key: upper
gate.candidate = "mesh": expected no such key beside candidates
gate.metric = "phase_lag": expected no such key beside limits
gate.limit = 1: expected no such key beside limits
gate.modes = ["forced"] & gate.mode = "forced": expected no such key beside modes
run(fine_2).particle_spacing_m = -1: expected
)");
  const Workspace workspace;
  const auto said = [&](const std::string& text) {
    return complaint(workspace.write("trial.toml", text));
  };
  EXPECT_TRUE(holds(said(with_keys(head + group, "gate.source is missing")), "source is missing"));
  EXPECT_EQ(said(head + changed("source = \"a source\"\n", "kind = \"regression\"\n")), "");
  EXPECT_TRUE(holds(said(head + group + changed("fine_*", "fine_1")), "a second bound on"));
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

// Gate rows on pressure fields: what they name, and what they are refused for.

const std::string row =
    "[[gate]]\ncandidate = \"coarse\"\nmetric = \"pressure_field_rms\"\nreference = \"mesh\"\n"
    "limit = 0.2\nreason = \"a reason\"\nsource = \"a source\"\n";
const std::string text = with_keys(valid_text, "time.snapshot_times_s = [1, 2]") + row;

TEST(FieldRows, AreOfAllMomentsUnlessOneIsNamed) {
  const GateRow whole = read_text(text).gate.back();
  EXPECT_EQ(whole.metric, Metric::pressure_field_rms);
  EXPECT_EQ(whole.reference, "mesh");
  EXPECT_EQ(whole.quantity, pressure_field);
  EXPECT_EQ(whole.mode, "whole");
  EXPECT_EQ(whole.unit, "1");
  EXPECT_EQ(whole.limit, 0.2);
  EXPECT_EQ(read_text(with_keys(text, "gate.mode = \"moment_2\"")).gate.back().mode, "moment_2");
}

TEST(FieldRows, AreRefusedAgainstOtherSolversOtherMomentsAndWideLimits) {
  expect_refusals(text, R"(
gate.reference = "theory": expected an OpenFOAM run other than the candidate
gate.mode = "moment_3": expected ... moment_2
time.snapshot_times_s is missing -> gate.metric = "pressure_field_rms": expected ... snapshot_times_s
gate.limit = 0.6: expected ... without pressure
)");
}

}  // namespace
}  // namespace slosh::gate_section_test
