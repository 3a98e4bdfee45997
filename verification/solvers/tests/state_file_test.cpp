#include "verification/solvers/particles/state_file.hpp"

#include <gtest/gtest.h>

#include "verification/results/result_file.hpp"
#include "verification/tests/messages.hpp"
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
  const std::string complaint = message_of<ResultError>([&] { read_state("other", file); });
  EXPECT_TRUE(holds(complaint, "key = mine: expected other"));
  EXPECT_TRUE(holds(complaint, file.string()));
}

}  // namespace
}  // namespace slosh::state_file_test
