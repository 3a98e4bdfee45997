#include "verification/results/result_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "verification/files/content_hash.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::result_file_test {
namespace {

namespace fs = std::filesystem;

RunResult sample_result() {
  return {.case_name = "small_surge",
          .run_name = "sph_10mm",
          .solver = "sph",
          .case_text = "name = \"small_surge\"  # Schwappen: über Größe\n",
          .key = "0123456789abcdef0123456789abcdef",
          .provenance = {{"command", "slosh run \"a b\""}, {"compiler", ""}},
          .active_terms = {"Wendland C2 kernel", "δ-SPH density diffusion"},
          .diagnostics = {{"relative_mass_loss", -1e-9}, {"speed_of_sound_m_s", 18.5}},
          .cost = {1.5, 2.25, 0.125, 1 << 20, 4000, 3500},
          .series = {{"elevation@right", "m", {0, 0.01, 0.02}, {0, 1e-3, -2.5e-3}},
                     {"pressure@left/0.1 m 5%", "Pa", {0, 0.5}, {1.0 / 3.0, 1e300}},
                     {"empty", "1", {}, {}}},
          .snapshots = {{.time = 0.5,
                         .width = 0.01,
                         .height = 0.02,
                         .x = {0.1, 0.2},
                         .z = {0.3, 0.4},
                         .velocity_x = {-1, 1e-3},
                         .velocity_z = {2, 0},
                         .pressure = {1000, -1.0 / 3.0}},
                        {.time = 1,
                         .width = 0.01,
                         .height = 0.02,
                         .x = {},
                         .z = {},
                         .velocity_x = {},
                         .velocity_z = {},
                         .pressure = {}}}};
}

void expect_equal(const RunResult& a, const RunResult& b) {
  EXPECT_EQ(a.case_name, b.case_name);
  EXPECT_EQ(a.run_name, b.run_name);
  EXPECT_EQ(a.solver, b.solver);
  EXPECT_EQ(a.case_text, b.case_text);
  EXPECT_EQ(a.key, b.key);
  EXPECT_EQ(a.provenance, b.provenance);
  EXPECT_EQ(a.active_terms, b.active_terms);
  EXPECT_EQ(a.diagnostics, b.diagnostics);
  EXPECT_EQ(a.cost.wall_time, b.cost.wall_time);
  EXPECT_EQ(a.cost.user_time, b.cost.user_time);
  EXPECT_EQ(a.cost.system_time, b.cost.system_time);
  EXPECT_EQ(a.cost.peak_memory, b.cost.peak_memory);
  EXPECT_EQ(a.cost.steps, b.cost.steps);
  EXPECT_EQ(a.cost.elements, b.cost.elements);
  ASSERT_EQ(a.series.size(), b.series.size());
  for (std::size_t i = 0; i < a.series.size(); ++i) {
    EXPECT_EQ(a.series[i].name, b.series[i].name);
    EXPECT_EQ(a.series[i].unit, b.series[i].unit);
    EXPECT_EQ(a.series[i].time, b.series[i].time);
    EXPECT_EQ(a.series[i].value, b.series[i].value);
  }
  ASSERT_EQ(a.snapshots.size(), b.snapshots.size());
  for (std::size_t i = 0; i < a.snapshots.size(); ++i) {
    const FieldSnapshot &one = a.snapshots[i], &two = b.snapshots[i];
    EXPECT_EQ(one.time, two.time);
    EXPECT_EQ(one.width, two.width);
    EXPECT_EQ(one.height, two.height);
    EXPECT_EQ(one.x, two.x);
    EXPECT_EQ(one.z, two.z);
    EXPECT_EQ(one.velocity_x, two.velocity_x);
    EXPECT_EQ(one.velocity_z, two.velocity_z);
    EXPECT_EQ(one.pressure, two.pressure);
  }
}

void put_bytes(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

// The message that reading the file ends with; empty where it is taken.
std::string refusal(const fs::path& file) {
  try {
    read_result(file);
  } catch (const ResultError& error) {
    return error.what();
  }
  return "";
}

class ResultFile : public ::testing::Test {
 protected:
  TemporaryDirectory directory;
  const fs::path file = directory.path() / "a run.h5";
};

// sealed_file_test.cpp has the files that were cut, altered or are of another version.
TEST_F(ResultFile, GivesBackAllThatWasWrittenWhateverItsPath) {
  for (const fs::path& place : {file, directory.path() / "Größe δ 水" / "run ö.h5"}) {
    write_result(sample_result(), place);
    expect_equal(read_result(place), sample_result());
  }
  EXPECT_EQ(sample_result().at("pressure@left/0.1 m 5%").unit, "Pa");
  EXPECT_THROW(sample_result().at("elevation@left"), ResultError);
}

TEST_F(ResultFile, KeepsValuesThatAreNoNumbers) {
  RunResult result = sample_result();
  result.series[0].value[1] = std::numeric_limits<double>::quiet_NaN();
  write_result(result, file);
  EXPECT_TRUE(std::isnan(read_result(file).at("elevation@right").value[1]));
}

TEST_F(ResultFile, RefusesFaultySeriesAndKeepsWhatWasThere) {
  RunResult unequal = sample_result(), twice = unequal, unnamed = unequal;
  unequal.series[0].value.pop_back();
  twice.series.push_back(twice.series[0]);
  unnamed.series[0].name = "";
  for (const RunResult& faulty : {unequal, twice, unnamed}) {
    EXPECT_THROW(write_result(faulty, file), ResultError);
    EXPECT_TRUE(fs::is_empty(directory.path()));
  }
  write_result(sample_result(), file);
  EXPECT_THROW(write_result(unnamed, file), ResultError);
  expect_equal(read_result(file), sample_result());
}

TEST_F(ResultFile, IsRefusedWithItsNameWhenAbsentOrADirectory) {
  EXPECT_TRUE(holds(refusal(file), file.string()));
  EXPECT_TRUE(holds(refusal(directory.path()), "directory"));
}

TEST_F(ResultFile, OfAForeignKindIsRefusedEvenWithAFittingChecksum) {
  const std::string content = "time,elevation\n0,0\n";
  put_bytes(file, content + "\nslosh result 002 " + content_hash(content) + "\n");
  EXPECT_TRUE(holds(refusal(file), "HDF5 cannot open the image"));
}

}  // namespace
}  // namespace slosh::result_file_test
