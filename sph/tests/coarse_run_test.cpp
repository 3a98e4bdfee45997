#include "sph/coarse_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "sph/restart/saved_state.hpp"
#include "sph/scheme.hpp"
#include "sph/tests/surging_scene.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::sph::coarse_run_test {
namespace {

constexpr double depth = 0.35;
const double wave_speed = std::sqrt(9.81 * depth);

// A column of water that collapses, as wide as it is high.
Scene dam(double dp, double duration) {
  Scene scene = still_scene(dp, duration);
  scene.column_width = depth;
  scene.speed_from_coarse_run = true;
  return scene;
}

TEST(SpeedCounts, TellTheSpeedThatAShareExceeds) {
  SpeedCounts counts(0.5);
  for (int i = 0; i < 1000; ++i) counts.add(i + 0.25);
  EXPECT_EQ(counts.exceeded_by(0), 999.5);
  EXPECT_EQ(counts.exceeded_by(0.01), 989.5);  // 990.25 to 999.25 are ten
  EXPECT_EQ(counts.exceeded_by(0.0105), 989.5);
  EXPECT_EQ(counts.exceeded_by(1), 0);
}

TEST(SpeedCounts, DoNotFollowASingleSplash) {
  SpeedCounts counts(0.001);
  for (int i = 0; i < 5000; ++i) counts.add(1.0005);
  const double calm = counts.exceeded_by(faster_share);
  counts.add(50);
  EXPECT_EQ(counts.exceeded_by(faster_share), calm);
  for (int i = 0; i < 5; ++i) counts.add(50);  // above a thousandth
  EXPECT_NEAR(counts.exceeded_by(faster_share), 50, 0.002);
}

TEST(SpeedCounts, RefuseToTellOfNothing) {
  EXPECT_THROW(SpeedCounts(1).exceeded_by(0.5), std::logic_error);
}

// A run whose particles have the tank's velocity and one more, in components along its axes.
RunScene flow_of(double u, double w) {
  return [=](const Scene& scene) -> RunOutput {
    if (!scene.takes_steps) return {};
    for (double t = 0; t <= scene.duration; t += scene.sample_interval) {
      Snapshot at{t, {0.1, 0.9}, {0.05, 0.3}, {}, {}, {}, {}};
      const double angle = roll_of(scene).angle(t), rate = roll_of(scene).rate(t),
                   surge = scene.velocity(t);
      for (std::size_t i = 0; i < at.x.size(); ++i) {
        at.velocity_x.push_back(u + surge * std::cos(angle) -
                                rate * (at.z[i] - roll_of(scene).axis_z));
        at.velocity_z.push_back(w - surge * std::sin(angle) +
                                rate * (at.x[i] - roll_of(scene).axis_x));
      }
      scene.record_snapshot(at);
    }
    return {};
  };
}

TEST(CoarseRun, MeasuresTheSpeedRelativeToTheTank) {
  for (const bool rolls : {false, true}) {
    Scene scene = surging_and_rolling_scene(0.01, 1);
    if (!rolls) scene.roll.reset();
    const double resolution = 1e-3 * expected_speed(scene);
    EXPECT_NEAR(coarse_run(scene, flow_of(3, -4)).expected_speed, 5, resolution);
  }
}

TEST(CoarseRun, GivesAtLeastTheSpeedOfALongWave) {
  const Scene scene = surging_scene(0.01, 1);
  EXPECT_EQ(coarse_run(scene, flow_of(0.3, 0)).expected_speed, wave_speed);
}

TEST(CoarseRun, IsThreeTimesCoarserWithAtLeastEightParticlesAcrossTheLiquid) {
  const auto spacing = [](const Scene& scene) {
    return coarse_run(scene, flow_of(1, 0)).particle_spacing;
  };
  EXPECT_NEAR(spacing(surging_scene(0.0025, 0.02)), depth / 47, 1e-12);
  EXPECT_NEAR(spacing(surging_scene(0.035 / 3, 0.02)), 0.035, 1e-12);
  EXPECT_NEAR(spacing(surging_scene(0.02, 0.02)), depth / 8, 1e-12);
  EXPECT_EQ(spacing(surging_scene(0.05, 0.02)), 0.05);
  Scene narrow = dam(0.005, 0.02);
  narrow.column_width = 0.16;
  EXPECT_NEAR(spacing(narrow), 0.16 / 11, 1e-12);
}

// A coarse spacing that divides the depth need not divide the column's width.
TEST(CoarseRun, PassesOverSpacingsThatDoNotFitTheTank) {
  Scene scene = dam(0.01, 0);
  scene.column_width = 0.4;
  scene.sample_interval = 0.01;
  scene.fill_depth = 0.37;  // 13 rows of 28.5 mm; 14.05 columns of these fit
  const auto coarse = [&](const RunScene& run) { return coarse_run(scene, run).particle_spacing; };
  const double first = coarse(flow_of(1, 0));
  EXPECT_NEAR(first, 0.37 / 13, 1e-12);
  const double next = coarse([&](const Scene& tried) -> RunOutput {
    if (tried.particle_spacing > 0.0275) throw std::invalid_argument("particle_spacing");
    return flow_of(1, 0)(tried);
  });
  EXPECT_NEAR(next, 0.37 / 14, 1e-12);
  const double own = coarse([&](const Scene& tried) -> RunOutput {
    if (tried.particle_spacing > 0.01) throw std::invalid_argument("particle_spacing");
    return flow_of(1, 0)(tried);
  });
  EXPECT_EQ(own, 0.01);
}

// The front of a dam on a dry bed runs at 2 sqrt(g h) in shallow water (Ritter 1892), which a
// column that is as high as wide does not quite reach.
TEST(CoarseRun, FindsTheSpeedOfABreakingDam) {
  const RunOutput output = run("recommended", dam(0.02, 0.4), {});
  const double speed = output.diagnostics.at("expected_speed_m_s");
  EXPECT_GT(speed, 1.2 * wave_speed);
  EXPECT_LT(speed, 2 * wave_speed);
  EXPECT_EQ(output.diagnostics.at("speed_of_sound_m_s"), 10 * speed);
  EXPECT_EQ(output.diagnostics.at("coarse_run_spacing_m"), depth / 8);
}

TEST(CoarseRun, IsRefusedWhereNothingFlows) {
  Scene scene = still_scene(0.05, 0.02);
  scene.speed_from_coarse_run = true;
  EXPECT_EQ(message_of<std::invalid_argument>([&] { run("recommended", scene, {}); }),
            "expected_speed = coarse_run: expected a motion of the tank, an initial wave or a "
            "dam; without them there is no flow whose speed could be measured");
}

TEST(CoarseRun, NamesItselfWhereItFails) {
  const RunScene fails = [](const Scene& scene) -> RunOutput {
    if (scene.takes_steps) throw SimulationError("the density of particle 3 is out of range");
    return {};
  };
  EXPECT_EQ(message_of<SimulationError>([&] { coarse_run(dam(0.01, 1), fails); }),
            "the coarse run at a spacing of 0.02917 m, which measures the expected speed, "
            "failed: the density of particle 3 is out of range");
}

struct Recorded {
  RunOutput output;
  std::vector<SavedState> states;
};

Recorded record(Scene scene) {
  Recorded recorded;
  scene.state_interval = 0.02;
  scene.save_state = [&](const SavedState& state) { recorded.states.push_back(state); };
  recorded.output = run("recommended", scene, {});
  return recorded;
}

void expect_same_flow(const RunOutput& found, const RunOutput& expected) {
  EXPECT_EQ(found.steps, expected.steps);
  for (const char* gauge : {"left", "right"})
    EXPECT_EQ(found.elevation.at(gauge).value, expected.elevation.at(gauge).value);
  EXPECT_EQ(found.kinetic_energy.value, expected.kinetic_energy.value);
  EXPECT_EQ(found.force_x.value, expected.force_x.value);
}

// The ratio by which the estimate gives the measured speed of sound, to the last bit.
double ratio_for(double speed_of_sound, double estimate) {
  double ratio = speed_of_sound / estimate;
  for (int i = 0; i < 8 && ratio * estimate != speed_of_sound; ++i)
    ratio = std::nextafter(
        ratio, ratio * estimate < speed_of_sound ? std::numeric_limits<double>::infinity() : 0.0);
  return ratio;
}

TEST(CoarseRun, ChangesNothingButTheSpeedOfSound) {
  Scene scene = dam(0.025, 0.1);
  const Recorded measured = record(scene);
  const double c0 = measured.output.diagnostics.at("speed_of_sound_m_s");
  scene.speed_from_coarse_run = false;
  scene.numbers.sound_speed_ratio = ratio_for(c0, expected_speed(scene));
  const Recorded given = record(scene);
  ASSERT_EQ(given.output.diagnostics.at("speed_of_sound_m_s"), c0);
  expect_same_flow(given.output, measured.output);
  EXPECT_EQ(given.states.back().fields, measured.states.back().fields);
  EXPECT_EQ(given.output.active_terms.size() + 1, measured.output.active_terms.size());
}

TEST(CoarseRun, IsNotRepeatedByARestart) {
  const Scene scene = dam(0.025, 0.1);
  const Recorded whole = record(scene);
  Scene rest = scene;
  rest.resume = &whole.states[1];
  rest.column_width = scene.column_width;
  const Recorded resumed = record(rest);
  expect_same_flow(resumed.output, whole.output);
  EXPECT_EQ(resumed.output.diagnostics, whole.output.diagnostics);
  EXPECT_EQ(resumed.states.back().fields, whole.states.back().fields);
  // The state's own speed counts, which shows that none was measured.
  SavedState other = whole.states[1];
  other.setting["coarse_run_speed"] *= 2;
  other.setting["speed_of_sound"] *= 2;
  // The liquid is compressed by a quarter as much.
  double& density = other.setting.at("rest_density");
  density = scene.rest_density / (1 + (scene.rest_density / density - 1) / 4);
  rest.resume = &other;
  EXPECT_EQ(record(rest).output.diagnostics.at("expected_speed_m_s"),
            2 * whole.output.diagnostics.at("expected_speed_m_s"));
}

TEST(CoarseRun, IsNotTakenFromAStateOfARunWithoutOne) {
  Scene scene = dam(0.025, 0.04);
  scene.speed_from_coarse_run = false;
  const Recorded estimated = record(scene);
  scene.speed_from_coarse_run = true;
  scene.resume = &estimated.states[0];
  EXPECT_THROW(run("recommended", scene, {}), std::invalid_argument);
}

TEST(CoarseRun, IsTheSameForRepeatsThatDifferInTheirDisorder) {
  Scene scene = dam(0.025, 0.05);
  scene.start_disorder = 0.1;
  const double one = run("recommended", scene, {}).diagnostics.at("expected_speed_m_s");
  scene.start_seed = 7;
  EXPECT_EQ(run("recommended", scene, {}).diagnostics.at("expected_speed_m_s"), one);
}

}  // namespace
}  // namespace slosh::sph::coarse_run_test
