#include "verification/runs/run_case.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "verification/case/quantities.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/files/hdf5_handles.hpp"
#include "verification/solvers/particles/state_file.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/sample_case.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::run_case_test {
namespace {

namespace fs = std::filesystem;

const auto no_progress = [](double, double) {};
const RunDefinition linear =
    sample_run(LinearRun{.modes = 1000, .valid_elevation_over_depth = 0.1});
const RunDefinition coarse_sph = sample_run(SphRun{"li2010", 0.05, 0.05});

double at_time(const TimeSeries& series, double time) {
  const auto found = std::lower_bound(series.time.begin(), series.time.end(), time - 1e-9);
  return series.value.at(static_cast<std::size_t>(found - series.time.begin()));
}

// Elevations that Li et al.'s corrected series gives 0.05 m from the right wall, computed apart
// from this code.
TEST(LinearRunOfACase, GivesTheKnownElevationsOfAStartInTheEarthsFrame) {
  const RunResult result = execute(sample_case(), linear, {}, no_progress);
  EXPECT_NEAR(at_time(result.at("elevation@right"), 1), 8.80998e-3, 1e-6);
  EXPECT_NEAR(at_time(result.at("elevation@right"), 2), 3.41289e-3, 1e-6);
  EXPECT_NEAR(at_time(result.at("elevation@left"), 1), -8.80998e-3, 1e-6);
}

TEST(LinearRunOfACase, GivesTheKnownElevationsOfAStartInTheTanksFrame) {
  CaseDefinition definition = sample_case();
  definition.start = Start::tank;
  const RunResult result = execute(definition, linear, {}, no_progress);
  EXPECT_NEAR(at_time(result.at("elevation@right"), 1), 2.76672e-3, 1e-6);
  EXPECT_NEAR(at_time(result.at("elevation@right"), 2), 0.66208e-3, 1e-6);
}

TEST(LinearRunOfACase, GivesTheSameForASineAndForATableOfIt) {
  CaseDefinition tabulated = sample_case();
  const auto sine = std::get<SineMotion>(*tabulated.motion.surge);
  TableMotion table;
  for (double t = 0; t < 2.1; t += 0.005) {
    table.time.push_back(t);
    table.value.push_back(sine.amplitude * std::sin(sine.angular_frequency * t));
  }
  tabulated.motion.surge = table;
  const RunResult closed = execute(sample_case(), linear, {}, no_progress);
  const RunResult integrated = execute(tabulated, linear, {}, no_progress);
  for (const char* name : {"elevation@right", "force_x"}) {
    const TimeSeries &a = closed.at(name), &b = integrated.at(name);
    const double scale = name == std::string("force_x") ? 10 : 9e-3;
    for (std::size_t i = 0; i < a.value.size(); ++i)
      EXPECT_NEAR(a.value[i], b.value[i], 2e-3 * scale) << name << i;
  }
}

TEST(LinearRunOfACase, BeginsCalmlyWithARamp) {
  CaseDefinition ramped = sample_case();
  std::get<SineMotion>(*ramped.motion.surge).ramp_periods = 2;
  const RunResult result = execute(ramped, linear, {}, no_progress);
  EXPECT_LT(std::abs(at_time(result.at("elevation@right"), 0.1)), 1e-6);
  EXPECT_GT(std::abs(at_time(result.at("elevation@right"), 2)), 1e-5);
}

TEST(LinearRunOfACase, CountsTheGasWhenAsked) {
  const RunDefinition two_layer = sample_run(LinearRun{1000, true, 0.1});
  const RunResult with = execute(sample_case(), two_layer, {}, no_progress);
  const RunResult without = execute(sample_case(), linear, {}, no_progress);
  EXPECT_NE(with.at("elevation@right").value, without.at("elevation@right").value);
  EXPECT_EQ(with.active_terms.size(), without.active_terms.size() + 1);
  // What it leaves out is estimated for one layer alone.
  const std::string beyond = std::string("elevation@right") + nonlinear;
  EXPECT_NO_THROW(with.at(beyond));
  CaseDefinition dense = sample_case();
  dense.gas.density = 500;
  EXPECT_THROW(execute(dense, two_layer, {}, no_progress).at(beyond), ResultError);
}

TEST(LinearRunOfACase, TellsItsHighestElevationForTheRangeOfValidity) {
  const RunResult result = execute(sample_case(), linear, {}, no_progress);
  const double highest = result.diagnostics.at("highest_elevation_m");
  EXPECT_GT(highest, 8.8e-3);
  EXPECT_DOUBLE_EQ(result.diagnostics.at("highest_elevation_over_depth"), highest / 0.35);
}

TEST(LinearRunOfACase, SwingsAnInitialWaveInATankThatStands) {
  CaseDefinition waved = sample_case();
  waved.motion = {};
  waved.initial_wave = InitialWaveDefinition{2, -0.01};
  const RunResult result = execute(waved, sample_run(LinearRun{0, false, 0.1}), {}, no_progress);
  const double k = 2 * M_PI, omega = std::sqrt(9.81 * k * std::tanh(k * 0.35));
  EXPECT_NEAR(at_time(result.at("elevation@left"), 0), -0.01 * std::cos(0.05 * k), 1e-12);
  EXPECT_NEAR(at_time(result.at("elevation@right"), 1),
              -0.01 * std::cos(0.05 * k) * std::cos(omega), 1e-12);
  EXPECT_NEAR(result.diagnostics.at("highest_elevation_m"), 0.01, 1e-9);
  EXPECT_EQ(result.active_terms, (std::vector<std::string>{"linear potential flow",
                                                           "closed form of the standing wave"}));
}

TEST(LinearRunOfACase, AddsAnInitialWaveToTheTanksMotionOnStillWaterCountedOnce) {
  CaseDefinition both = sample_case();
  both.pressure_gauges = {{.name = "low", .wall = Wall::left, .position = 0.1}};
  CaseDefinition surge = both, wave = both;
  both.initial_wave = wave.initial_wave = InitialWaveDefinition{1, 0.01};
  wave.motion = {};
  const RunResult sum = execute(both, linear, {}, no_progress),
                  one = execute(surge, linear, {}, no_progress),
                  two = execute(wave, linear, {}, no_progress);
  for (const char* name : {"elevation@left", "force_x", "wall_pressure@low"}) {
    const double still = std::string(name) == "wall_pressure@low" ? 1000 * 9.81 * 0.25 : 0;
    for (const std::size_t i : {1u, 40u, 77u})
      EXPECT_NEAR(sum.at(name).value[i], one.at(name).value[i] + two.at(name).value[i] - still,
                  1e-8)
          << name;
  }
}

class ViscousWaveOfACase : public ::testing::Test {
 protected:
  ViscousWaveOfACase() {
    definition.motion = {};
    definition.liquid.kinematic_viscosity = 1e-3;
    definition.initial_wave = InitialWaveDefinition{1, 0.01};
  }
  CaseDefinition definition = sample_case();
  RunDefinition run = sample_run(ViscousWaveRun{0.1});
};

TEST_F(ViscousWaveOfACase, DecaysAtTheGauges) {
  const RunResult result = execute(definition, run, {}, no_progress);
  EXPECT_EQ(result.solver, "viscous_wave");
  EXPECT_NEAR(at_time(result.at("elevation@left"), 0), 0.01 * std::cos(0.05 * M_PI), 1e-12);
  EXPECT_NEAR(result.diagnostics.at("damping_1_s"), 2e-3 * M_PI * M_PI, 2e-3);
  EXPECT_DOUBLE_EQ(result.diagnostics.at("highest_elevation_over_depth"), 0.01 / 0.35);
  EXPECT_EQ(result.series.size(), 4u);  // two gauges, each also with what the theory leaves out
}

TEST_F(ViscousWaveOfACase, RefusesATankThatMovesOneWithoutAWaveAndAnInviscidLiquid) {
  CaseDefinition moving = definition, level = definition, inviscid = definition;
  moving.motion = sample_case().motion;
  level.initial_wave.reset();
  inviscid.liquid.kinematic_viscosity = 0;
  for (const CaseDefinition& wrong : {moving, level, inviscid}) {
    EXPECT_THROW(require_runnable(wrong, run), CaseFileError);
    EXPECT_THROW(execute(wrong, run, {}, no_progress), CaseFileError);
  }
  EXPECT_NO_THROW(require_runnable(definition, run));
}

TEST(RunOfACase, SamplesFromZeroToTheDurationInclusive) {
  CaseDefinition definition = sample_case();
  definition.duration = 0.7;
  definition.sample_interval = 0.1;
  const TimeSeries series = execute(definition, linear, {}, no_progress).at("elevation@right");
  ASSERT_EQ(series.time.size(), 8u);
  EXPECT_EQ(series.time.front(), 0);
  EXPECT_NEAR(series.time.back(), 0.7, 1e-12);
}

TEST(RunOfACase, RecordsWhatItWasAndWhatItTook) {
  RunSettings settings;
  settings.key = "abc";
  settings.command = "slosh run small_surge a_run";
  const RunResult result = execute(sample_case(), linear, settings, no_progress);
  EXPECT_EQ(result.case_name, "small_surge");
  EXPECT_EQ(result.run_name, "a_run");
  EXPECT_EQ(result.solver, "linear");
  EXPECT_EQ(result.case_text, sample_case().text);
  EXPECT_EQ(result.key, "abc");
  EXPECT_EQ(result.provenance.at("command"), settings.command);
  for (const char* name :
       {"slosh_version", "compiler", "compiler_flags", "processor", "date_utc"}) {
    EXPECT_FALSE(result.provenance.at(name).empty()) << name;
  }
  EXPECT_GT(result.cost.wall_time, 0);
  EXPECT_LE(result.cost.user_time + result.cost.system_time, 64 * result.cost.wall_time + 0.1);
  EXPECT_GT(result.cost.peak_memory, 1e6);
}

std::string refusal(const CaseDefinition& definition, const RunDefinition& run) {
  try {
    require_runnable(definition, run);
    return "";
  } catch (const CaseFileError& error) {
    EXPECT_THROW(execute(definition, run, {}, no_progress), CaseFileError);
    return error.what();
  }
}

TEST(RunOfACase, RefusesARollForWallsThatCannotTurnWithItsPlace) {
  CaseDefinition definition = sample_case();
  definition.motion.roll = {.angle = SineMotion{0.07, 2}, .axis_x = 0.5, .axis_z = 0};
  SphRun verlet{"recommended", 0.05, 0.05};
  verlet.variant = "verlet";
  EXPECT_TRUE(begins(refusal(definition, sample_run(verlet)),
                     "small_surge.toml:42: run a_run: motion.roll: expected none"));
}

TEST(RunOfACase, RefusesADamAndAnObstacleThatTheSolverDoesNotTake) {
  CaseDefinition dam = sample_case(), baffled = sample_case();
  dam.liquid.column_width = 0.25;
  baffled.obstacles = {{"baffle", 0.45, 0.55, 0, 0.2}};
  baffled.obstacles[0].left = 0.47;
  const RunDefinition mesh = sample_run(InterFoamRun{20, 20, 1});
  EXPECT_TRUE(begins(refusal(dam, linear),
                     "small_surge.toml:42: run a_run: linear theory takes no "
                     "liquid.column_width_m"));
  EXPECT_TRUE(begins(refusal(baffled, linear),
                     "small_surge.toml:42: run a_run: linear theory takes no "
                     "[[obstacle]]"));
  EXPECT_EQ(refusal(dam, mesh), "");
  EXPECT_TRUE(begins(refusal(baffled, mesh),
                     "small_surge.toml:42: run a_run: OpenFOAM tank: obstacle left = "
                     "0.47: expected a multiple of the cells'"));
}

TEST(RunOfACase, RefusesLinearTheoryOfATankThatStands) {
  CaseDefinition still = sample_case();
  still.motion = {};
  EXPECT_TRUE(holds(refusal(still, linear), "motion.still = true"));
  EXPECT_EQ(refusal(still, coarse_sph), "");
}

TEST(RecordRunOfACase, GivesTheRecordAsItIs) {
  const RecordRun record{"a.csv", "elevation@left", "m", {0.5, 0.7, 1.0, 1.1}, {1, 2, 3, 4}, 0.25};
  const RunResult result = execute(sample_case(), sample_run(record), {}, no_progress);
  EXPECT_EQ(result.solver, "record");
  ASSERT_EQ(result.series.size(), 1u);
  EXPECT_EQ(result.at("elevation@left").time, record.time);
  EXPECT_EQ(result.at("elevation@left").value, record.value);
  EXPECT_EQ(result.at("elevation@left").unit, "m");
  EXPECT_EQ(result.diagnostics.at("uncertainty_m"), 0.25);
}

TEST(RecordRunOfACase, StandsInACaseThatNoSolverTakes) {
  CaseDefinition rolling = sample_case();
  rolling.motion.roll = {.angle = SineMotion{0.07, 2}, .axis_x = 0.5, .axis_z = 0};
  const RecordRun record{"a.csv", "moment", "N", {0.5, 0.7, 1.0, 1.1}, {1, 2, 3, 4}, {}};
  EXPECT_EQ(execute(rolling, sample_run(record), {}, no_progress).at("moment").value, record.value);
}

// A stored result of 10 s of another code: 2 mm high where it begins.
class StoredRunOfACase : public ::testing::Test {
 protected:
  StoredRun written(const std::string& rows) const {
    std::ofstream(directory_.path() / "swl.csv") << "t,eta\n" << rows;
    std::ofstream(directory_.path() / "cost.json")
        << R"({"schema_version": 1, "software": "their SPH 5.4", "date": "2026-11-22",
               "machine": "one core", "simulated_time_s": 10, "processor_time_s": 776,
               "steps": 1000, "liquid_particles": 3500})";
    return {.series = {{.quantity = "elevation@left",
                        .file = directory_.path() / "swl.csv",
                        .format = "csv",
                        .column = "eta",
                        .unit = "m",
                        .time_column = "t",
                        .time_unit = "s",
                        .first_is_zero = true}},
            .method = "their_sph",
            .particle_spacing = 0.02,
            .facts = directory_.path() / "cost.json"};
  }

  std::string rows(double end) const {
    std::string text;
    for (int i = 0; 0.01 * i < end + 0.005; ++i)
      text += fmt::format("{:.2f},{}\n", 0.01 * i, 0.002 + 0.001 * i);
    return text;
  }

  TemporaryDirectory directory_;
};

TEST_F(StoredRunOfACase, GivesTheSeriesAndTheCostOfTheCodeThatMadeIt) {
  const CaseDefinition definition = sample_case();
  const StoredRun stored = written(rows(definition.duration));
  const RunResult result = execute(definition, sample_run(stored), {}, no_progress);
  EXPECT_EQ(result.solver, "stored");
  EXPECT_NEAR(result.at("elevation@left").value.at(3), 0.003, 1e-12) << "less the first reading";
  const double share = definition.duration / 10;
  EXPECT_DOUBLE_EQ(result.cost.user_time, 776 * share) << "not what reading it took";
  EXPECT_EQ(result.cost.elements, 3500);
  EXPECT_EQ(result.provenance.at("stored_software"), "their SPH 5.4");
  EXPECT_FALSE(result.provenance.contains("compiler_flags")) << "Slosh's compiled no other code";
}

TEST_F(StoredRunOfACase, FailsWhereASeriesIsCutShortOrPoisoned) {
  const CaseDefinition definition = sample_case();
  const auto failure = [&](const std::string& text) -> std::string {
    return message_of<SolverError>(
        [&] { execute(definition, sample_run(written(text)), {}, no_progress); });
  };
  const std::string whole = rows(definition.duration);
  EXPECT_EQ(failure(whole), "");
  EXPECT_TRUE(holds(failure(rows(definition.duration / 2)), "elevation@left ends at"));
  std::string poisoned = whole;
  poisoned.replace(poisoned.find("0.05,") + 5, 5, "nan\n0");
  EXPECT_TRUE(holds(failure(poisoned), "swl.csv:"));
}

TEST(RecordRunOfACase, IsRefusedWhereItIsNotSupplied) {
  CaseDefinition definition = sample_case();
  definition.source = "a paper";
  const RunDefinition run =
      sample_run(RecordRun{"SLOSH_EXPERIMENTS/a.csv", "elevation@left", "m", {}, {}, {}, false});
  EXPECT_NO_THROW(require_runnable(definition, run)) << "the other runs of the case may go on";
  EXPECT_EQ(message_of<CaseFileError>([&] { execute(definition, run, {}, no_progress); }),
            "small_surge.toml:42: run a_run: expected SLOSH_EXPERIMENTS/a.csv, below the "
            "directory of --experiments or SLOSH_EXPERIMENTS; where to get the original: a "
            "paper");
}

TEST(RunOfACase, RefusesAnUnknownSchemeWithItsPlaceAndTheKnownOnes) {
  const std::string message = message_of<CaseFileError>([&] {
    execute(sample_case(), sample_run(SphRun{"li2011", 0.05, 0.05}), {}, no_progress);
  });
  EXPECT_TRUE(begins(message, "small_surge.toml:42: run a_run: scheme = \"li2011\""));
  EXPECT_TRUE(holds(message, "li2010"));
}

TEST(RunOfACase, IsKnownBeforeItRuns) {
  EXPECT_NO_THROW(require_runnable(sample_case(), coarse_sph));
  EXPECT_NO_THROW(require_runnable(sample_case(), linear));
  for (const SphRun& wrong : {SphRun{"li2011", 0.05, 0.05}, SphRun{"recommended", 0.05, 0.025},
                              SphRun{"recommended", 0.3, 0.3}})
    EXPECT_THROW(require_runnable(sample_case(), sample_run(wrong)), CaseFileError);
}

TEST(RunOfACase, RefusesTwoSpacingsOfASchemeOfOneWithItsPlace) {
  const std::string message = message_of<CaseFileError>([&] {
    execute(sample_case(), sample_run(SphRun{"recommended", 0.05, 0.025}), {}, no_progress);
  });
  EXPECT_TRUE(begins(message, "small_surge.toml:42: run a_run: scheme recommended takes one"));
}

TEST(RunOfACase, RefusesWhatInterFoamDoesNotTakeWithItsPlace) {
  EXPECT_EQ(message_of<CaseFileError>([&] {
              execute(sample_case(), sample_run(InterFoamRun{1, 20, 1}), {}, no_progress);
            }),
            "small_surge.toml:42: run a_run: OpenFOAM tank: cells_x = 1: expected at least 2");
}

TEST(RunOfACase, RefusesWhatTheLinearReferenceDoesNotTake) {
  EXPECT_THROW(execute(sample_case(), sample_run(LinearRun{0, false, 0.1}), {}, no_progress),
               CaseFileError);
}

// At a step beyond what a lattice bears.
RunDefinition unstable_sph() {
  RunDefinition run = coarse_sph;
  auto& sph = std::get<SphRun>(run.solver);
  sph.scheme = "recommended";
  sph.numbers.courant_number = 2;
  return run;
}

class SphRunOfACase : public ::testing::Test {
 protected:
  SphRunOfACase() {
    definition.duration = 0.1;
    definition.sample_interval = 0.05;
    settings.work_directory = directory.path();
  }
  TemporaryDirectory directory;
  CaseDefinition definition = sample_case();
  RunSettings settings;
};

TEST_F(SphRunOfACase, LeavesItsSeriesInTheirUnits) {
  double reported = 0;
  const RunResult result =
      execute(definition, coarse_sph, settings, [&](double time, double) { reported = time; });
  EXPECT_EQ(result.at("elevation@left").unit, "m");
  EXPECT_EQ(result.at("elevation@right").unit, "m");
  EXPECT_EQ(result.at("force_x").unit, "N/m");
  EXPECT_EQ(result.at("kinetic_energy").unit, "J/m");
  EXPECT_EQ(result.at("potential_energy").unit, "J/m");
  EXPECT_EQ(result.at("elevation@right").time.size(), 3u);
  for (const TimeSeries& series : result.series) {
    EXPECT_NEAR(series.time.back(), 0.1, 1e-3) << series.name;
  }
  EXPECT_EQ(result.cost.elements, 20 * 7);
  EXPECT_GT(result.cost.steps, 0);
  EXPECT_FALSE(result.active_terms.empty());
  EXPECT_TRUE(fs::is_empty(directory.path())) << "nobody asked for snapshots";
  EXPECT_LE(reported, 0.1);
}

TEST_F(SphRunOfACase, GoesOnFromASavedStateToTheSameBits) {
  definition.pressure_gauges = {{.name = "low", .wall = Wall::left, .position = 0.1}};
  definition.duration = 0.15;
  settings.state_interval = 0.1;
  settings.key = "a key";
  const RunResult whole = execute(definition, coarse_sph, settings, no_progress);
  RunSettings again = settings;
  again.resume = state_file(directory.path(), "a_run");
  const RunResult resumed = execute(definition, coarse_sph, again, no_progress);
  ASSERT_EQ(whole.series.size(), resumed.series.size());
  for (std::size_t i = 0; i < whole.series.size(); ++i) {
    EXPECT_EQ(whole.series[i].name, resumed.series[i].name);
    EXPECT_EQ(whole.series[i].time, resumed.series[i].time) << whole.series[i].name;
    EXPECT_EQ(whole.series[i].value, resumed.series[i].value) << whole.series[i].name;
  }
  again.key = "another key";
  EXPECT_THROW(execute(definition, coarse_sph, again, no_progress), ResultError);
}

TEST_F(SphRunOfACase, LeavesItsLastGoodStateWhereItGoesWrongAndSaysWhere) {
  definition.duration = 4;
  settings.key = "a key";
  const fs::path file = last_good_state_file(directory.path(), "a_run");
  const std::string message =
      message_of<SolverError>([&] { execute(definition, unstable_sph(), settings, no_progress); });
  EXPECT_TRUE(holds(message, "is " + file.string()));
  const sph::SavedState state = read_state("a key", file);
  EXPECT_LT(state.numbers.at("time"), 4);
}

TEST_F(SphRunOfACase, SaysWhatWentWrongWhereItsLastGoodStateCannotBeSaved) {
  definition.duration = 4;
  settings.work_directory = "/proc/nowhere";
  const std::string complaint =
      message_of<SolverError>([&] { execute(definition, unstable_sph(), settings, no_progress); });
  EXPECT_TRUE(holds(complaint, "particle "));
  EXPECT_TRUE(holds(complaint, "could not be saved: "));
}

TEST_F(SphRunOfACase, LeavesSnapshotsAtTheCasesTimesWithVelocitiesAgainstTheTank) {
  definition.snapshot_times = {0.05, 0.1};
  definition.start = Start::tank;
  const RunResult result = execute(definition, coarse_sph, settings, no_progress);
  ASSERT_EQ(result.snapshots.size(), 2u);
  EXPECT_EQ(result.snapshots[0].time, 0.05);
  EXPECT_EQ(result.snapshots[1].time, 0.1);
  const FieldSnapshot& first = result.snapshots[0];
  EXPECT_EQ(first.x.size(), 20u * 7u);
  EXPECT_EQ(first.width, 0.05);
  // A tank of 0.03 m/s whose liquid has not left it yet: next to nothing is left of that.
  for (std::size_t i = 0; i < first.x.size(); ++i) EXPECT_LT(std::abs(first.velocity_x[i]), 5e-3);
  EXPECT_TRUE(fs::is_empty(directory.path())) << "nobody asked for files";
}

TEST(RunOfACase, RefusesStatesOfASolverThatHasNone) {
  for (const auto& change : {+[](RunSettings& s) { s.state_interval = 1; },
                             +[](RunSettings& s) { s.resume = "a.state.h5"; }}) {
    RunSettings settings;
    change(settings);
    EXPECT_THROW(execute(sample_case(), linear, settings, no_progress), CaseFileError);
  }
}

// Mean velocity along x of the particles in the first snapshot.
double initial_velocity(const fs::path& file) {
  const hdf5::Handle data(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                          "open the snapshots");
  const auto velocity = hdf5::read_numbers(data, "snapshot_00000/velocity");
  double sum = 0;
  for (std::size_t i = 0; i < velocity.size(); i += 3) sum += velocity[i];
  return sum / static_cast<double>(velocity.size() / 3);
}

TEST_F(SphRunOfACase, SetsTheLiquidOffWithTheFrameThatItStartsIn) {
  settings.snapshot_interval = 0.05;
  execute(definition, coarse_sph, settings, no_progress);
  EXPECT_NEAR(initial_velocity(directory.path() / "a_run.snapshots.h5"), 0, 1e-12);
  definition.start = Start::tank;
  execute(definition, coarse_sph, settings, no_progress);
  const auto sine = std::get<SineMotion>(*definition.motion.surge);
  EXPECT_NEAR(initial_velocity(directory.path() / "a_run.snapshots.h5"),
              sine.amplitude * sine.angular_frequency, 1e-12);
}

TEST_F(SphRunOfACase, LeavesNoSnapshotsWhereTheyAreRefused) {
  settings.snapshot_interval = 0.07;
  EXPECT_THROW(execute(definition, coarse_sph, settings, no_progress), CaseFileError);
  EXPECT_TRUE(fs::is_empty(directory.path()));
}

// The start of such a run leaves the scheme's range before its first step.
TEST(RequireRunnable, NamesTheRunWhoseStartFails) {
  RunDefinition run = sample_run(SphRun{"recommended", 0.05, 0.05});
  std::get<SphRun>(run.solver).numbers.sound_speed_ratio = 0.001;
  run.name = "slow_sound";
  const std::string message =
      message_of<CaseFileError>([&] { require_runnable(sample_case(), run); });
  EXPECT_TRUE(holds(message, "run slow_sound: the start fails: "));
}

TEST(Execute, NamesTheRunThatNeedsMoreMemoryThanThereIs) {
#if defined(__SANITIZE_ADDRESS__) || \
    defined(__clang__)  // which builds the tests for the sanitizers alone
  GTEST_SKIP() << "the address sanitizer ends a program that asks for too much";
#endif
  CaseDefinition definition = sample_case();
  RunDefinition run = sample_run(LinearRun{2000000000, false, 0.1});
  run.name = "endless";
  const std::string message =
      message_of<SolverError>([&] { execute(definition, run, {}, [](double, double) {}); });
  EXPECT_TRUE(holds(message, "endless: it needs more memory"));
}

}  // namespace
}  // namespace slosh::run_case_test
