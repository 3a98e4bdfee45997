// Restarts from saved states, and the last good state of a run that goes wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "sph/restart/resume.hpp"
#include "sph/restart/saved_state.hpp"
#include "sph/tests/surging_scene.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::sph::restart_test {
namespace {

struct Named {
  const char *scheme, *variant;
};

// Surging; and rolling where the scheme's walls can.
Scene scene_of(const Named& named, bool rolls, double spacing = 0.05) {
  Scene scene = surging_and_rolling_scene(spacing, 0.05);
  if (!rolls) scene.roll.reset();
  scene.variant = named.variant;
  scene.sample_interval = 0.005;
  scene.snapshot_interval = scene.state_interval = 0.01;
  return scene;
}

// A run with all that it leaves.
struct WholeRun {
  RunOutput output;
  std::vector<SavedState> states;
  Snapshot last;
};

WholeRun run_whole(const Named& named, Scene scene, const SavedState* resume = nullptr) {
  WholeRun whole;
  scene.save_state = [&](const SavedState& state) { whole.states.push_back(state); };
  scene.record_snapshot = [&](const Snapshot& snapshot) { whole.last = snapshot; };
  scene.resume = resume;
  whole.output = run(named.scheme, scene, {});
  return whole;
}

struct SameSeries {
  const RunOutput& expected;

  void operator()(const std::string& name, const History& found) const {
    RunOutput::for_each_series(expected, [&](const std::string& other, const auto& series) {
      if constexpr (std::is_same_v<decltype(series), const History&>)
        if (name == other) expect(name, found, series);
    });
  }
  void operator()(const std::string& name, const std::map<std::string, History>& found) const {
    RunOutput::for_each_series(expected, [&](const std::string& other, const auto& series) {
      if constexpr (std::is_same_v<decltype(series), const std::map<std::string, History>&>)
        if (name == other)
          for (const auto& [gauge, history] : series) expect(gauge, found.at(gauge), history);
    });
  }
  void operator()(const std::string& name, const std::vector<RecordedSeries>& found) const {
    RunOutput::for_each_series(expected, [&](const std::string& other, const auto& series) {
      if constexpr (std::is_same_v<decltype(series), const std::vector<RecordedSeries>&>)
        if (name == other)
          for (std::size_t i = 0; i < series.size(); ++i)
            expect(series[i].name, found.at(i).history, series[i].history);
    });
  }
  static void expect(const std::string& name, const History& found, const History& expected) {
    EXPECT_EQ(found.time, expected.time) << name;
    EXPECT_EQ(found.value, expected.value) << name;
  }
};

void expect_same_bits(const WholeRun& found, const WholeRun& expected) {
  RunOutput::for_each_series(found.output, SameSeries{expected.output});
  EXPECT_EQ(found.output.steps, expected.output.steps);
  EXPECT_EQ(found.output.exchanged_at_walls, expected.output.exchanged_at_walls);
  EXPECT_EQ(found.output.diagnostics, expected.output.diagnostics);
  EXPECT_EQ(found.output.active_terms, expected.output.active_terms);
  EXPECT_EQ(found.output.particles, expected.output.particles);
  for (auto field : {&Snapshot::x, &Snapshot::z, &Snapshot::velocity_x, &Snapshot::velocity_z,
                     &Snapshot::pressure, &Snapshot::density})
    EXPECT_EQ(found.last.*field, expected.last.*field);
  const SavedState &a = found.states.back(), &b = expected.states.back();
  EXPECT_EQ(a.numbers, b.numbers);
  EXPECT_EQ(a.fields, b.fields);
}

struct Resumed : Named {
  bool rolls;
};

class Resume : public testing::TestWithParam<Resumed> {};
INSTANTIATE_TEST_SUITE_P(
    Of, Resume,
    testing::Values(Resumed{{"recommended", ""}, false}, Resumed{{"recommended", ""}, true},
                    Resumed{{"li2010", ""}, false}, Resumed{{"li2010", ""}, true},
                    Resumed{{"delta_sph", ""}, false}, Resumed{{"delta_sph", ""}, true},
                    Resumed{{"zhao2021_moving", ""}, false}, Resumed{{"zhao2021_moving", ""}, true},
                    Resumed{{"zhao2021_fixed", ""}, false}, Resumed{{"zhao2021_fixed", ""}, true},
                    Resumed{{"recommended", "verlet"}, false},
                    Resumed{{"recommended", "dynamic_walls"}, true}),
    [](const auto& of) {
      const Resumed& r = of.param;
      return std::string(r.scheme) + (*r.variant ? "_" : "") + r.variant +
             (r.rolls ? "_rolling" : "");
    });

TEST_P(Resume, GoesOnBitForBitWithOneAndTwoThreads) {
  Scene scene = scene_of(GetParam(), GetParam().rolls);
  scene.record_energy_budget = scene.record_still_water = true;
  const WholeRun whole = run_whole(GetParam(), scene);
  ASSERT_EQ(whole.states.size(), 5);
  for (const int threads : {1, 2}) {
    scene.threads = threads;
    // A few steps: threads that wait for one another on a busy machine take many times as long.
    const WholeRun resumed = run_whole(GetParam(), scene, &whole.states[threads == 1 ? 0 : 3]);
    expect_same_bits(resumed, whole);
  }
}

// Each particle then has a spacing of its own.
TEST(Resume, GoesOnBitForBitWithTwoSpacings) {
  const Named named{"li2010", ""};
  Scene scene = scene_of(named, false, 0.04);
  scene.surface_particle_spacing = 0.5 * scene.particle_spacing;
  const WholeRun whole = run_whole(named, scene);
  ASSERT_TRUE(whole.states.front().fields.contains("spacing"));
  expect_same_bits(run_whole(named, scene, &whole.states.front()), whole);
}

TEST(Resume, GoesOnFromTheEndOfAShorterRun) {
  const Named named{"zhao2021_moving", ""};
  Scene scene = scene_of(named, true);
  const WholeRun whole = run_whole(named, scene);
  scene.duration = 0.02;
  const WholeRun first = run_whole(named, scene);
  scene.duration = 0.05;
  expect_same_bits(run_whole(named, scene, &first.states.back()), whole);
}

// The tool's message for a state that a run of `scheme` in `scene` cannot go on from.
std::string refusal(const char* scheme, const Scene& scene, const SavedState& state) {
  return message_of<std::invalid_argument>([&] { run_whole({scheme, ""}, scene, &state); });
}

class RefusedState : public testing::Test {
 protected:
  const Scene scene = scene_of({"recommended", ""}, true);
  const SavedState state = run_whole({"recommended", ""}, scene).states.front();
};

TEST_F(RefusedState, OfAnotherScheme) {
  EXPECT_TRUE(slosh::holds(refusal("delta_sph", scene, state), "the state's terms are"));
  EXPECT_TRUE(slosh::holds(refusal("zhao2021_fixed", scene, state), "the state's terms are"));
  Scene changed = scene;
  changed.numbers.artificial_viscosity = 0.01;
  EXPECT_TRUE(slosh::holds(refusal("recommended", changed, state),
                           "artificial_viscosity = 0.0005: expected 0.01"));
}

TEST_F(RefusedState, OfAnotherScene) {
  Scene changed = scene;
  changed.fill_depth = 0.26;
  EXPECT_TRUE(
      slosh::holds(refusal("recommended", changed, state), "fill_depth = 0.24: expected 0.26"));
  changed = scene;
  changed.gauges.pop_back();
  EXPECT_TRUE(slosh::holds(refusal("recommended", changed, state),
                           "gauges are left, right: expected left"));
  changed = scene;
  changed.record_energy_budget = true;
  EXPECT_TRUE(slosh::holds(refusal("recommended", changed, state), "numbers are"));
  changed = scene;
  changed.duration = 0.005;
  EXPECT_TRUE(slosh::holds(refusal("recommended", changed, state),
                           "expected a time within the run's 0.005 s"));
}

TEST_F(RefusedState, WithANumberThatIsNotFinite) {
  for (const auto& [name, values] : state.fields) {
    SavedState bad = state;
    bad.fields[name][7] = std::nan("");
    EXPECT_TRUE(
        slosh::holds(refusal("recommended", scene, bad), "state's " + name + " number 7 is nan"));
  }
  for (const auto& [name, value] : state.numbers) {
    SavedState bad = state;
    bad.numbers[name] = INFINITY;
    EXPECT_TRUE(slosh::holds(refusal("recommended", scene, bad), "inf"));
  }
  SavedState bad = state;
  bad.output.kinetic_energy.value[1] = std::nan("");
  EXPECT_TRUE(
      slosh::holds(refusal("recommended", scene, bad), "state's kinetic_energy number 1 is nan"));
  bad = state;
  bad.setting["gravity"] = std::nan("");
  EXPECT_TRUE(slosh::holds(refusal("recommended", scene, bad), "gravity = nan"));
}

TEST_F(RefusedState, WithAPartThatIsMissingOrOfAnotherLength) {
  SavedState bad = state;
  bad.fields["density"].pop_back();
  EXPECT_TRUE(slosh::holds(refusal("recommended", scene, bad),
                           "state's density has 79 numbers: expected 80"));
  bad = state;
  bad.fields.erase("mass");
  EXPECT_TRUE(slosh::holds(refusal("recommended", scene, bad), "fields are"));
  bad = state;
  bad.output.elevation["left"].value.pop_back();
  EXPECT_TRUE(slosh::holds(refusal("recommended", scene, bad),
                           "elevation of left has 3 times and 2 values"));
  bad = state;
  bad.numbers["sample"] += 1;
  EXPECT_TRUE(
      slosh::holds(refusal("recommended", scene, bad), "the state is of sample 3 at 0.01 s"));
}

// A tank whose motion is no number from a time on, sampled every 0.01 s.
Scene scene_that_goes_wrong(std::optional<SavedState>& last_good, double from = 0.125) {
  Scene scene = surging_scene(0.05, 0.2);
  for (auto* motion : {&scene.displacement, &scene.velocity, &scene.acceleration})
    *motion = [of = *motion, from](double t) {
      return t > from ? std::numeric_limits<double>::quiet_NaN() : of(t);
    };
  scene.save_last_good_state = [&](const SavedState& state) { last_good = state; };
  return scene;
}

class LastGoodStateOf : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Schemes, LastGoodStateOf,
                         testing::Values("li2010", "recommended", "zhao2021_moving"),
                         [](const auto& scheme) { return std::string(scheme.param); });

TEST_P(LastGoodStateOf, IsThatOfTheLastSampleBeforeTheRunWentWrong) {
  std::optional<SavedState> last_good;
  EXPECT_THROW(run(GetParam(), scene_that_goes_wrong(last_good), {}), SimulationError);
  ASSERT_TRUE(last_good);
  EXPECT_NEAR(last_good->numbers.at("time"), 0.12, 1e-9);
  EXPECT_EQ(last_good->numbers.at("sample"), 12);
  EXPECT_EQ(last_good->output.kinetic_energy.time.size(), 13u);
}

TEST_P(LastGoodStateOf, CanBeGoneOnFrom) {
  std::optional<SavedState> last_good;
  EXPECT_THROW(run(GetParam(), scene_that_goes_wrong(last_good), {}), SimulationError);
  Scene mended = surging_scene(0.05, 0.2);
  const RunOutput whole = run(GetParam(), mended, {});
  mended.resume = &last_good.value();
  const RunOutput resumed = run(GetParam(), mended, {});
  ASSERT_EQ(resumed.kinetic_energy.time.size(), 21u);
  // The neighbour lists are made anew, which changes the order of the sums.
  EXPECT_NEAR(resumed.kinetic_energy.value.back(), whole.kinetic_energy.value.back(),
              1e-9 * whole.kinetic_energy.value.back());
}

// The start can be made again.
TEST(LastGoodState, IsNotGivenWhereTheRunGoesWrongBeforeItsFirstSample) {
  std::optional<SavedState> last_good;
  EXPECT_THROW(run("recommended", scene_that_goes_wrong(last_good, 0.002), {}), SimulationError);
  EXPECT_FALSE(last_good);
}

TEST(LastGoodState, IsOfTheSampleBeforeTheOneThatShowsEnergyFromNowhere) {
  std::optional<SavedState> last_good;
  Scene scene = still_scene(0.04, 4);
  scene.initial_wave = InitialWave{1, 0.04};
  scene.numbers.sound_speed_ratio = 5;
  scene.numbers.courant_number = 1.8;
  scene.save_last_good_state = [&](const SavedState& state) { last_good = state; };
  EXPECT_THROW(run("recommended", scene, {}), SimulationError);
  ASSERT_TRUE(last_good);
  EXPECT_EQ(last_good->output.kinetic_energy.time.back(), last_good->numbers.at("time"));
  EXPECT_EQ(last_good->output.elevation.at("left").time.back(), last_good->numbers.at("time"));
}

TEST(LastGoodState, IsNotGivenOfARunThatEnds) {
  Scene scene = still_scene(0.05, 0.02);
  scene.save_last_good_state = [](const SavedState&) { FAIL(); };
  run("recommended", scene, {});
}

}  // namespace
}  // namespace slosh::sph::restart_test
