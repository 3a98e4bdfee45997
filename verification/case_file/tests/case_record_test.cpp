// Published records as references: read from a CSV file beside the case, or refused by its line.
#include <gtest/gtest.h>

#include "verification/case_file/tests/refusals.hpp"
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

const std::map<std::string, std::string> files{{"front.csv", front}};

RecordRun record_of(const std::string& keys, const std::string& csv = front) {
  return std::get<RecordRun>(
      read_trial({dam_text("file = \"front.csv\"\n" + keys), {{"front.csv", csv}}})
          .runs.at(1)
          .solver);
}

TEST(RecordOfACase, IsReadWithItsQuantityUnitAndUncertainty) {
  const RecordRun record = record_of("uncertainty = 0.01\n");
  EXPECT_EQ(record.quantity, "front_position");
  EXPECT_EQ(record.unit, "m");
  EXPECT_EQ(record.time, (std::vector<double>{0.1, 0.2, 0.3, 0.4}));
  EXPECT_EQ(record.value, (std::vector<double>{0.25, 0.3, 0.4, 0.52}));
  EXPECT_EQ(record.uncertainty, 0.01);
  const RecordRun later = record_of("time_offset_s = -0.25\n");
  ASSERT_EQ(later.time.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_DOUBLE_EQ(later.time[i], 0.1 * static_cast<double>(i) - 0.15);
}

TEST(RecordOfACase, MayBeOfAnElevationAndWithoutUncertainty) {
  const RecordRun record = record_of("", "time_s,elevation@left_m\n0,0\n1,-0.1\n2,-0.2\n3,-0.3\n");
  EXPECT_EQ(record.quantity, "elevation@left");
  EXPECT_FALSE(record.uncertainty);
}

TEST(RecordOfACase, IsRefusedByItsOwnLine) {
  expect_refusals_of("front.csv", dam_text(), R"(
t,x -> 1: header = t,x: expected time_s and one of front_position_m, elevation@right_m,
  elevation@left_m, force_x_N/m,
time_s,front_position_mm -> 1: header = time_s,front_position_mm: expected
time_s,elevation@middle_m -> 1: header = time_s,elevation@middle_m: expected
time_s,front_position_m | 0,1 | 1,2 | 2,3 -> 4: rows = 3: expected at least 4
time_s,front_position_m | 0,1 | 1,nan | 2,3 | 3,4 -> 3: front_position_m = nan: expected a number, in m
time_s,front_position_m | 0,1 | 1,inf | 2,3 | 3,4 -> 3: front_position_m = inf: expected
time_s,front_position_m | 0,1 | nan,2 | 2,3 | 3,4 -> 3: time_s = nan: expected a number, in s
time_s,front_position_m | 0,1 | 2,2 | 2,3 | 3,4 -> 4: time_s = 2: expected a number above the last
  row's 2, in s
time_s,front_position_m | 0,1 | 1;2 -> 3: row = 1;2: expected 2 values
)");
  expect_refusals({dam_text(), files}, R"(
run.file is missing: expected a text that is not empty
run.file = "none.csv": expected a file relative
run.uncertainty = 0: expected a number > 0, in m
run.scheme = "any": expected only these keys here: name, solver, quick, file, time_offset_s,
  earlier_run, uncertainty
)");
}

TEST(GateOnARecord, TakesTheRecordsQuantityOverTheWholeWindow) {
  const std::string row =
      "[[gate]]\ncandidate = \"particles\"\nreference = \"published\"\n"
      "quantity = \"front_position\"\nmode = \"whole\"\nmetric = \"normalised_rms\"\nunit = \"1\"\n"
      "limit = 0.1\nreason = \"r\"\nsource = \"s\"\n";
  expect_refusals({dam_text() + row, files}, R"(
gate.limit = 0.1: accepted
gate.reference = "particles" & gate.candidate = "published": expected a run, which is particles
gate.quantity = "elevation@left": expected the record's quantity, which is front_position
gate.metric = "decay_rate" & gate.unit = "1/s" & gate.mode = "natural_1": expected what decay_rate is
  measured on, of which there is none
)");
}

}  // namespace
}  // namespace slosh::case_record_test
