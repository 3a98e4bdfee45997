// Published records as references: read from a CSV file beside the case, or refused by its line.
#include <gtest/gtest.h>

#include "verification/tests/trial_case.hpp"

namespace slosh::case_record_test {
namespace {

// A dam about to break, whose last run is a record of its front. The lines are those of
// `valid_text` with another one for the column.
std::string dam_text(const std::string& record = "file = \"front.csv\"\n") {
  std::string text = valid_text.substr(0, valid_text.find("[[run]]"));
  const auto replace = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("viscosity_m2_s = 1e-6", "viscosity_m2_s = 1e-6\ncolumn_width_m = 0.25");
  replace("natural_modes = 2", "natural_modes = 0");
  return text +
         "[[run]]\nname = \"particles\"\nsolver = \"sph\"\nscheme = \"any\"\n"
         "particle_spacing_m = 0.02\n[[run]]\nname = \"published\"\nsolver = \"record\"\n" +
         record;
}

constexpr const char* front = "time_s,front_position_m\n0.1,0.25\n0.2,0.3\n0.3,0.4\n0.4,0.52\n";

std::string gate(const std::string& candidate, const std::string& reference,
                 const std::string& quantity, const std::string& mode, const std::string& metric,
                 const std::string& unit) {
  return "[[gate]]\ncandidate = \"" + candidate + "\"\nreference = \"" + reference +
         "\"\nquantity = \"" + quantity + "\"\nmode = \"" + mode + "\"\nmetric = \"" + metric +
         "\"\nunit = \"" + unit + "\"\nlimit = 0.1\nreason = \"r\"\nsource = \"s\"\n";
}

std::string complaint_about(const std::string& case_text, const std::string& csv) {
  const Workspace workspace;
  workspace.write("front.csv", csv);
  return complaint(workspace.write("dam.toml", case_text));
}

TEST(RecordOfACase, IsReadWithItsQuantityUnitAndUncertainty) {
  const Workspace workspace;
  workspace.write("front.csv", front);
  const CaseDefinition definition = read_case(
      workspace.write("dam.toml", dam_text("file = \"front.csv\"\nuncertainty = 0.01\n")));
  const auto& record = std::get<RecordRun>(definition.runs.at(1).solver);
  EXPECT_EQ(record.quantity, "front_position");
  EXPECT_EQ(record.unit, "m");
  EXPECT_EQ(record.time, (std::vector<double>{0.1, 0.2, 0.3, 0.4}));
  EXPECT_EQ(record.value, (std::vector<double>{0.25, 0.3, 0.4, 0.52}));
  EXPECT_EQ(record.uncertainty, 0.01);
}

TEST(RecordOfACase, HasTheTimeOffsetAddedToItsTimes) {
  const Workspace workspace;
  workspace.write("front.csv", front);
  const CaseDefinition definition = read_case(
      workspace.write("dam.toml", dam_text("file = \"front.csv\"\ntime_offset_s = -0.25\n")));
  const auto& record = std::get<RecordRun>(definition.runs.at(1).solver);
  ASSERT_EQ(record.time.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_DOUBLE_EQ(record.time[i], 0.1 * static_cast<double>(i) - 0.15);
}

TEST(RecordOfACase, MayBeOfAnElevationAndWithoutUncertainty) {
  const Workspace workspace;
  workspace.write("front.csv", "time_s,elevation@left_m\n0,0\n1,-0.1\n2,-0.2\n3,-0.3\n");
  const CaseDefinition definition = read_case(workspace.write("dam.toml", dam_text()));
  const auto& record = std::get<RecordRun>(definition.runs.at(1).solver);
  EXPECT_EQ(record.quantity, "elevation@left");
  EXPECT_FALSE(record.uncertainty);
}

TEST(RecordOfACase, IsRefusedByItsOwnLine) {
  const std::string head = "time_s,front_position_m\n";
  const std::vector<std::pair<std::string, std::string>> records{
      {"t,x\n",
       "front.csv:1: header = t,x: expected time_s and one of front_position_m, "
       "elevation@right_m, elevation@left_m, force_x_N/m, "},
      {"time_s,front_position_mm\n", "front.csv:1: header = time_s,front_position_mm: expected"},
      {"time_s,elevation@middle_m\n", "front.csv:1: header = time_s,elevation@middle_m: expected"},
      {head + "0,1\n1,2\n2,3\n", "front.csv:4: rows = 3: expected at least 4"},
      {head + "0,1\n1,nan\n2,3\n3,4\n",
       "front.csv:3: front_position_m = nan: expected a number, in m"},
      {head + "0,1\n1,inf\n2,3\n3,4\n", "front.csv:3: front_position_m = inf: expected"},
      {head + "0,1\nnan,2\n2,3\n3,4\n", "front.csv:3: time_s = nan: expected a number, in s"},
      {head + "0,1\n2,2\n2,3\n3,4\n",
       "front.csv:4: time_s = 2: expected a number above the last row's 2, in s"},
      {head + "0,1\n1;2\n", "front.csv:3: row = 1;2: expected 2 values"}};
  for (const auto& [csv, wanted] : records) {
    const std::string message = complaint_about(dam_text(), csv);
    EXPECT_TRUE(message.starts_with(wanted)) << "got:    " << message << "\nwanted: " << wanted;
  }
}

TEST(RecordOfACase, HasAFileAndAPositiveUncertainty) {
  const std::vector<std::pair<std::string, std::string>> keys{
      {"", "dam.toml:41: run.file is missing: expected a text that is not empty"},
      {"file = \"none.csv\"\n", "dam.toml:44: run.file = \"none.csv\": expected a file relative"},
      {"file = \"front.csv\"\nuncertainty = 0\n",
       "dam.toml:45: run.uncertainty = 0: expected a number > 0, in m"},
      {"file = \"front.csv\"\nscheme = \"any\"\n",
       "dam.toml:45: run.scheme = \"any\": expected only these keys here: name, solver, quick, "
       "file, time_offset_s, earlier_run, uncertainty"}};
  for (const auto& [record, wanted] : keys) {
    const std::string message = complaint_about(dam_text(record), front);
    EXPECT_TRUE(message.starts_with(wanted)) << "got:    " << message << "\nwanted: " << wanted;
  }
}

TEST(GateOnARecord, TakesTheRecordsQuantityOverTheWholeWindow) {
  const auto complaint_about_row = [](const std::string& row) {
    return complaint_about(dam_text() + row, front);
  };
  EXPECT_EQ(complaint_about_row(
                gate("particles", "published", "front_position", "whole", "normalised_rms", "1")),
            "");
  EXPECT_TRUE(complaint_about_row(
                  gate("published", "particles", "front_position", "whole", "normalised_rms", "1"))
                  .starts_with("dam.toml:46: gate.candidate = \"published\": expected a run, which "
                               "is particles"));
  EXPECT_TRUE(complaint_about_row(
                  gate("particles", "published", "elevation@left", "whole", "normalised_rms", "1"))
                  .starts_with("dam.toml:48: gate.quantity = \"elevation@left\": expected the "
                               "record's quantity, which is front_position"));
  EXPECT_TRUE(complaint_about_row(gate("particles", "published", "front_position", "natural_1",
                                       "decay_rate", "1/s"))
                  .starts_with("dam.toml:49: gate.mode = \"natural_1\": expected what decay_rate "
                               "is measured on, of which there is none"));
}

TEST(GateOnAFront, NeedsADam) {
  EXPECT_EQ(slosh::complaint_about({"elevation@right", "front_position"})
                .find("trial.toml:55: gate.quantity = \"front_position\": expected a compared "
                      "quantity, one of elevation@right, elevation@left"),
            0u);
}

}  // namespace
}  // namespace slosh::case_record_test
