// Published records as references: read from a CSV file beside the case, or refused by its line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::record_section_test {
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

RecordRun front_record(const std::string& keys, const std::string& csv = front) {
  return std::get<RecordRun>(
      read_trial({dam_text("file = \"front.csv\"\n" + keys), {{"front.csv", csv}}})
          .runs.at(1)
          .solver);
}

TEST(RecordOfACase, IsReadWithItsQuantityUnitAndUncertainty) {
  const RecordRun record = front_record("uncertainty = 0.01\n");
  EXPECT_EQ(record.quantity, "front_position");
  EXPECT_EQ(record.unit, "m");
  EXPECT_EQ(record.time, (std::vector<double>{0.1, 0.2, 0.3, 0.4}));
  EXPECT_EQ(record.value, (std::vector<double>{0.25, 0.3, 0.4, 0.52}));
  EXPECT_EQ(record.uncertainty, 0.01);
  const RecordRun later = front_record("time_offset_s = -0.25\n");
  ASSERT_EQ(later.time.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_DOUBLE_EQ(later.time[i], 0.1 * static_cast<double>(i) - 0.15);
  const RecordRun elevation =
      front_record("", "time_s,elevation@left_m\n0,0\n1,-0.1\n2,-0.2\n3,-0.3\n");
  EXPECT_EQ(elevation.quantity, "elevation@left");
  EXPECT_FALSE(elevation.uncertainty);
}

TEST(RecordOfACase, IsRefusedByItsOwnLine) {
  expect_refusals_of("front.csv", dam_text(), R"(
t,x -> 1: header = t,x: expected time_s and one of front_position_m, elevation@right_m,
  elevation@left_m, force_x_N/m,
time_s,front_position_mm -> 1: header = time_s,front_position_mm: expected
time_s,elevation@middle_m -> 1: header = time_s,elevation@middle_m: expected
time_s,front_position_m | 0,1 | 1,nan | 2,3 | 3,4 -> 3: front_position_m = nan: expected a number, in m
)");
  expect_refusals({dam_text(), files}, R"(
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

// Records that the user supplies: they are read from the given directory, count as not supplied if
// they are absent, and are refused with their line if they differ from what the case says.

namespace fs = std::filesystem;

const std::string columns = "time_column = \"t_s\"\nvalue_column = \"p\"\n";
const std::string experiment =
    "experiment = \"probe.csv\"\nquantity = \"wall_pressure@b\"\nunit = \"kPa\"\n" + columns;

// The trial case with a pressure gauge and a record.
std::string text_with(const std::string& record) {
  std::string text = edited({"[comparison]",
                             "[[pressure_gauge]]\nname = \"b\"\nwall = \"left\"\n"
                             "position_m = 0.17\n[comparison]"});
  text = text.substr(0, text.find("[[gate]]"));
  return text + "[[run]]\nname = \"probe\"\nsolver = \"record\"\n" + record;
}

RecordRun record_of(const CaseDefinition& definition) {
  return std::get<RecordRun>(definition.runs.back().solver);
}

RecordRun read_record(const std::string& record, const std::string& csv) {
  return record_of(read_trial({text_with(record), {{"probe.csv", csv}}}));
}

constexpr const char* probe = "t_s,p\n0.036,3.226\n0.418,3.491\n0.5,-0.1\n0.61,0\n";

TEST(ExperimentRecord, IsReadInSiUnits) {
  const RecordRun record = read_record(experiment + "uncertainty = 0.05\n", probe);
  EXPECT_TRUE(record.supplied);
  EXPECT_EQ(record.quantity, "wall_pressure@b");
  EXPECT_EQ(record.unit, "Pa");
  EXPECT_EQ(record.time, (std::vector<double>{0.036, 0.418, 0.5, 0.61}));
  EXPECT_EQ(record.value, (std::vector<double>{3226, 3491, -100, 0}));
  EXPECT_EQ(record.uncertainty, 50);
  EXPECT_EQ(read_record(experiment + "time_offset_s = 2\n", probe).time.back(), 2.61);
}

TEST(ExperimentRecord, MayBeWrittenInAnyUnitOfItsQuantity) {
  const auto first_value = [](const std::string& quantity, const std::string& unit) {
    const std::string keys = "experiment = \"probe.csv\"\nquantity = \"" + quantity +
                             "\"\nunit = \"" + unit + "\"\n" + columns;
    return read_record(keys, "t_s,p\n0,2\n1,3\n2,4\n3,5\n").value.at(0);
  };
  EXPECT_EQ(first_value("wall_pressure@b", "Pa"), 2);
  EXPECT_EQ(first_value("wall_pressure@b", "kPa"), 2000);
  EXPECT_EQ(first_value("wall_pressure@b", "mbar"), 200);
  EXPECT_EQ(first_value("wall_pressure@b", "bar"), 200000);
  EXPECT_EQ(first_value("elevation@right", "m"), 2);
  EXPECT_EQ(first_value("elevation@right", "mm"), 0.002);
}

TEST(ExperimentRecord, IsTakenFromAFileOfMoreColumns) {
  const RecordRun record =
      read_record(experiment, "p,note,t_s\r\n1,first peak,0\r\n2,,0.5\r\n3,,1\r\n4,,2\r\n");
  EXPECT_EQ(record.time, (std::vector<double>{0, 0.5, 1, 2}));
  EXPECT_EQ(record.value, (std::vector<double>{1000, 2000, 3000, 4000}));
}

TEST(ExperimentRecord, IsNotSuppliedWhereNoDirectoryIsNamedOrTheFileIsNotThere) {
  const Workspace workspace, empty;
  workspace.write("probe.csv", probe);
  const fs::path file =
      workspace.write("trial.toml", text_with(experiment + "uncertainty = 0.05\n"));
  const RecordRun unnamed = record_of(read_case(file));
  EXPECT_FALSE(unnamed.supplied);
  EXPECT_EQ(unnamed.file, "SLOSH_EXPERIMENTS/probe.csv");
  EXPECT_EQ(unnamed.quantity, "wall_pressure@b");
  EXPECT_EQ(unnamed.uncertainty, 50);
  EXPECT_TRUE(unnamed.time.empty() && unnamed.value.empty());
  const RecordRun absent = record_of(read_case(file, empty.path()));
  EXPECT_FALSE(absent.supplied);
  EXPECT_EQ(absent.file, empty.path() / "probe.csv");
  EXPECT_TRUE(record_of(read_case(file, workspace.path())).supplied);
}

TEST(ExperimentRecord, IsRefusedByItsOwnLine) {
  expect_refusals_of("probe.csv", text_with(experiment), R"(
t,p -> 1: time_column = t_s: expected one of the file's 2 columns; nearest: t
t_s,p | 0,1 | 1,2 | 2,3 -> 4: rows = 3: expected at least 4
t_s,p | 0,1 | 1,x -> 3: p = x: expected a number, in kPa
t_s,p | 0,1 | 0,2 -> 3: t_s = 0: expected a number above the last row's 0, in s
)");
}

TEST(ExperimentRecord, HasKeysThatMakeSenseEvenWhereItIsNotSupplied) {
  expect_refusals(text_with(experiment), R"(
run.quantity is missing: expected a compared quantity, one of elevation@right, elevation@left,
  wall_pressure@b, force_x
run.quantity = "wall_pressure@a": expected a compared quantity
run.unit = "psi": expected a unit of wall_pressure@b, one of Pa, kPa, mbar, bar; nearest:
run.quantity = "elevation@left" -> run.unit = "kPa": expected a unit of elevation@left, one of m, cm, mm
run.uncertainty = 0: expected a number > 0, in kPa
run.file = "a.csv": expected only these keys here: name, solver, quick, experiment, time_column
run.experiment = "../none.csv": expected a CSV file's path below the directory of the experiments
)");
  expect_refusals(text_with("experimnt = \"none.csv\"\n"), R"(
-> run.experimnt = "none.csv": expected only these keys here: ... nearest known key: experiment
)");
}

// The real records, if they are beside the source tree or in the directory that the user names.
fs::path experiments() {
  const char* named = std::getenv("SLOSH_EXPERIMENTS");
  return named ? fs::path(named) : fs::path(SLOSH_SOURCE_DIR) / "../shared/experiments";
}

TEST(PublishedRecord, OfTheLateralImpactHasItsFirstPeak) {
  const Workspace workspace;
  const RecordRun record = record_of(read_case(
      workspace.write("trial.toml",
                      text_with("experiment = "
                                "\"spheric_test10/pressure_sensor1_lateral_water_1kHz.csv\"\n"
                                "quantity = \"wall_pressure@b\"\nunit = \"Pa\"\n"
                                "time_column = \"t_s\"\nvalue_column = \"p_Pa\"\n")),
      experiments()));
  if (!record.supplied) GTEST_SKIP() << "not supplied: " << record.file;
  ASSERT_EQ(record.time.size(), 8351u);
  EXPECT_EQ(record.time.back(), 8.35);
  EXPECT_EQ(record.value.front(), 9.9928);
  // The impact at 2.375 s; nothing comes near it before.
  for (std::size_t i = 0; record.time[i] < 2.35; ++i) EXPECT_LT(record.value[i], 500);
  EXPECT_GT(*std::max_element(record.value.begin() + 2370, record.value.begin() + 2390), 1000);
}

const std::string band = "lower_column = \"low\"\nupper_column = \"high\"\n";
constexpr const char* banded =
    "t_s,low,p,high\n0,0.9,1,1.2\n1,1.9,2,2.2\n2,2.9,3,3.2\n3,3.9,4,4.2\n";

TEST(ExperimentRecord, MayHaveABandOfQuantilesAndAScale) {
  const RecordRun record = read_record(experiment + band + "scale = 2\n", banded);
  EXPECT_TRUE(record.has_band);
  EXPECT_EQ(record.value, (std::vector<double>{2000, 4000, 6000, 8000}));
  EXPECT_EQ(record.lower.at(0), 1800);
  EXPECT_EQ(record.upper.at(3), 8400);
  EXPECT_FALSE(read_record(experiment, banded).has_band);
}

TEST(ExperimentRecord, IsRefusedWithABandThatIsNone) {
  expect_refusals({text_with(experiment), {{"probe.csv", banded}}}, R"(
run.lower_column = "high" & run.upper_column = "low": expected a column whose values are nowhere
  below those of lower_column; at 0 s they are
run.lower_column = "low" -> run.upper_column is missing: expected
)");
}

const std::string band_row =
    "[[gate]]\ncandidate = \"coarse\"\nreference = \"probe\"\nmetric = \"outside_band\"\n"
    "limit = 0.2\nreason = \"a reason\"\nsource = \"a source\"\n";

TEST(ExperimentRecord, WithABandServesRowsOnItEvenWhereItIsNotSupplied) {
  const CaseDefinition definition =
      read_text(text_with(experiment + band + band_row + "part_begin_s = 2\npart_end_s = 3.5\n"));
  const GateRow row = definition.gate.back();
  EXPECT_EQ(row.metric, Metric::outside_band);
  EXPECT_EQ(row.part, std::pair(2.0, 3.5));
  EXPECT_EQ(row.quantity, "wall_pressure@b");
  EXPECT_FALSE(read_text(text_with(experiment + band + band_row)).gate.back().part);
}

TEST(ExperimentRecord, HasRowsOnItsBandAlone) {
  expect_refusals({text_with(experiment + band_row), {{"probe.csv", probe}}}, R"(
-> gate.reference = "probe": expected a record with lower_column and upper_column: outside_band is
  measured on their band
)");
}

TEST(ExperimentRecord, ServesRowsOnPartsOfTheRun) {
  const auto part_of = [](const std::string& keys) {
    std::string row = band_row;
    row.replace(row.find("outside_band"), 12, "rms_error");
    return read_text(text_with(experiment + band + row + keys)).gate.back().part;
  };
  EXPECT_EQ(part_of("part_begin_s = 0.5\npart_end_s = 3\n"), std::pair(0.5, 3.0));
  EXPECT_EQ(part_of("part_begin_s = 5\n"), std::pair(5.0, 20.0));
  EXPECT_EQ(part_of("part_end_s = 5\n"), std::pair(0.0, 5.0));
  expect_refusals({text_with(experiment + band + band_row), {{"probe.csv", banded}}}, R"(
gate.part_begin_s = 20: expected a number >= 0 and below 20, in s
gate.part_begin_s = 3 & gate.part_end_s = 3: expected a number above 3 and <= 20, in s
gate.metric = "cost_to_reach" & gate.error = 0.1 & gate.part_end_s = 4: expected no such key
)");
}

}  // namespace
}  // namespace slosh::record_section_test
