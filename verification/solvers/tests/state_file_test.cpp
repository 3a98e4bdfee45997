#include "verification/solvers/particles/state_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "verification/results/result_file.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::state_file_test {
namespace {

sph::SavedState sample_state() {
  sph::SavedState state;
  state.terms = {"Wendland C2 kernel", "leapfrog"};
  state.setting = {{"particle_spacing", 0.01}, {"c0", 1.0 / 3.0}};
  state.numbers = {{"time", 0.5}, {"previous_dt", 1e-4}};
  state.fields = {{"x", {0.1, 0.2, 1.0 / 7.0}}, {"solid_density", {}}};
  state.output.elevation["left"] = {{0, 0.1}, {1e-3, -2e-3}};
  state.output.force_x = {{0.1}, {12.5}};
  state.output.energy = {{"wall_work", "J/m", {{0, 0.1}, {0, 3}}}};
  return state;
}

std::string refusal(const std::string& key, const std::filesystem::path& file) {
  try {
    read_state(key, file);
  } catch (const ResultError& error) {
    return error.what();
  }
  return "";
}

TEST(StateFile, GivesBackEveryPartToTheBit) {
  const TemporaryDirectory directory;
  const auto file = state_file(directory.path() / "new", "a_run");
  EXPECT_EQ(file.filename(), "a_run.state.h5");
  const sph::SavedState state = sample_state();
  write_state(state, "key", file);
  const sph::SavedState back = read_state("key", file);
  EXPECT_EQ(back.terms, state.terms);
  EXPECT_EQ(back.setting, state.setting);
  EXPECT_EQ(back.numbers, state.numbers);
  EXPECT_EQ(back.fields, state.fields);
  EXPECT_EQ(back.output.elevation.at("left").value, state.output.elevation.at("left").value);
  EXPECT_EQ(back.output.force_x.time, state.output.force_x.time);
  ASSERT_EQ(back.output.energy.size(), 1);
  EXPECT_EQ(back.output.energy[0].unit, "J/m");
  EXPECT_EQ(back.output.energy[0].history.value, state.output.energy[0].history.value);
}

TEST(StateFile, IsRefusedForAnotherRunWithBothKeys) {
  const TemporaryDirectory directory;
  const auto file = directory.path() / "a.state.h5";
  write_state(sample_state(), "mine", file);
  const std::string complaint = refusal("other", file);
  EXPECT_NE(complaint.find("key = mine: expected other"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find(file.string()), std::string::npos) << complaint;
}

TEST(StateFile, IsRefusedWhenTruncatedOrAltered) {
  const TemporaryDirectory directory;
  const auto file = directory.path() / "a.state.h5";
  write_state(sample_state(), "key", file);
  std::ifstream in(file, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  std::string altered = bytes;
  altered[bytes.size() / 2] ^= 1;
  for (const std::string& damaged : {bytes.substr(0, bytes.size() - 100), altered, std::string()}) {
    std::ofstream(file, std::ios::binary) << damaged;
    EXPECT_NE(refusal("key", file), "");
  }
}

}  // namespace
}  // namespace slosh::state_file_test
