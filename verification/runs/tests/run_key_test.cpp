#include "verification/runs/run_key.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <set>
#include <string_view>

#include "verification/tests/sample_case.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::run_key_test {
namespace {

// Whether two keys have the same question, be it answered by different builds or versions.
bool asks_the_same(std::string_view key, std::string_view other) {
  return key.substr(0, key.find('-')) == other.substr(0, other.find('-'));
}

class RunKey : public ::testing::Test {
 protected:
  RunKey() {
    std::filesystem::create_directories(templates / "system");
    std::filesystem::create_directories(builds);
    for (const char* kind : {"sph", "interfoam", "linear", "potential", "viscous_wave", "record",
                             "external", "stored"})
      std::ofstream(builds / kind) << "one build of it";
    std::ofstream(templates / "system" / "fvSolution") << "nOuterCorrectors 1;";
  }
  std::string key(const CaseDefinition& definition, const RunDefinition& run) const {
    return run_key(definition, run, builds, templates);
  }

  TemporaryDirectory directory;
  const std::filesystem::path builds = directory.path() / "slosh.builds";
  const std::filesystem::path templates = directory.path() / "templates";
  const RunDefinition sph = sample_run(SphRun{"li2010", 0.02, 0.02});
  const RunDefinition interfoam = sample_run(InterFoamRun{50, 50, 1});
};

TEST_F(RunKey, IsTheSameForTheSameRun) {
  EXPECT_EQ(key(sample_case(), sph), key(sample_case(), sph));
  EXPECT_EQ(key(sample_case(), sph).size(), 65u);
}

TEST(SetupHash, ChangesWithThePhysicsAndTheNamedRunsAlone) {
  CaseDefinition definition = sample_case();
  definition.runs = {sample_run(SphRun{"li2010", 0.02, 0.02}),
                     sample_run(LinearRun{500, false, 0.2})};
  definition.runs[0].name = "sph";
  definition.runs[1].name = "theory";
  const auto hash = [&] { return setup_hash(definition, {"sph", "theory"}); };
  const std::string before = hash();
  EXPECT_EQ(before.size(), 32u);
  definition.window_begin += 1;
  definition.title = "Another title";
  EXPECT_EQ(hash(), before);
  std::get<LinearRun>(definition.runs[1].solver).modes = 1;
  EXPECT_NE(hash(), before);
  const std::string of_sph = setup_hash(definition, {"sph", ""});
  definition.runs.pop_back();
  EXPECT_EQ(setup_hash(definition, {"sph", ""}), of_sph) << "another run is none of the row's";
  definition.gravity = 9.0;
  EXPECT_NE(setup_hash(definition, {"sph"}), of_sph);
}

// The keys of results that were stored before tanks had outlines.
TEST_F(RunKey, OfARectangularTankDoesNotKnowOfOutlines) {
  CaseDefinition definition = sample_case();
  const std::string plain = key(definition, sph);
  EXPECT_EQ(plain.substr(0, 32), "5634662564c68da25d2960d3b52328cb");
  definition.pressure_gauges = {{"left", Wall::left, 0.1, 0.01, 10}};
  EXPECT_EQ(key(definition, sph).substr(0, 32), "5b9828da6c63ed72d2fea468c671cf06");
}

#define CHANGE(...) [](CaseDefinition& c) { __VA_ARGS__; }

TEST_F(RunKey, ChangesWithEveryPartOfThePhysics) {
  const std::string before = key(sample_case(), sph);
  const std::vector<std::function<void(CaseDefinition&)>> changes{
      CHANGE(c.gravity = 9.0),
      CHANGE(c.tank.length = 1.01),
      CHANGE(c.tank.height = 0.9),
      CHANGE(c.tank.breadth = 0.06),
      CHANGE(c.tank.outline = {{0, 0}, {1, 0}, {0.5, 1}}),
      CHANGE(c.tank.outline = {{0, 0}, {1, 0}, {0.6, 1}}),
      CHANGE(c.liquid.fill_depth = 0.36),
      CHANGE(c.liquid.density = 999),
      CHANGE(c.liquid.column_width = 0.3),
      CHANGE(c.obstacles.push_back({"baffle", 0.4, 0.5, 0, 0.2})),
      CHANGE(c.initial_wave = {1, 0.01}),
      CHANGE(c.initial_wave = {2, 0.01}),
      CHANGE(c.initial_wave = {1, -0.01}),
      CHANGE(c.motion = {}),
      CHANGE(c.liquid.kinematic_viscosity = 2e-6),
      CHANGE(std::get<SineMotion>(*c.motion.surge).amplitude += 1e-15),
      CHANGE(std::get<SineMotion>(*c.motion.surge).ramp_periods = 2),
      CHANGE(std::get<SineMotion>(*c.motion.surge).phase = 0.1),
      CHANGE(c.motion.surge = SumOfSines{{SineMotion{0.02, 2}, SineMotion{0.01, 3}}}),
      CHANGE(c.motion.surge = SumOfSines{{SineMotion{0.02, 2}, SineMotion{0.01, 3, 0, 0.1}}}),
      CHANGE(c.motion.surge = TableMotion{"table.csv", {0, 1, 2}, {0, 0.01, 0}}),
      CHANGE(c.motion = {.roll = RollDefinition{SineMotion{0.02, 0.3 * 4.94488}, 0.5, 0}}),
      CHANGE(c.motion.roll = RollDefinition{SineMotion{0.02, 2}, 0.5, 0}),
      CHANGE(c.motion.roll = RollDefinition{SineMotion{0.02, 2}, 0.5, 0.1}),
      CHANGE(c.motion.roll = RollDefinition{SineMotion{0.02, 2}, 0.4, 0}),
      CHANGE(c.motion.roll = RollDefinition{SineMotion{0.03, 2}, 0.5, 0}),
      CHANGE(c.pressure_gauges = {{"left", Wall::left, 0.1}}),
      CHANGE(c.pressure_gauges = {{"left", Wall::right, 0.1}}),
      CHANGE(c.pressure_gauges = {{"left", Wall::left, 0.2}}),
      CHANGE(c.pressure_gauges = {{"left", Wall::left, 0.1, 0.01}}),
      CHANGE(c.pressure_gauges = {{"left", Wall::left, 0.1, 0, 10}}),
      CHANGE(c.pressure_gauges =
                 {{.name = "left", .wall = Wall::left, .position = 0.1, .at = Corner{}}}),
      CHANGE(c.pressure_gauges =
                 {{.name = "left", .wall = Wall::left, .position = 0.1, .at = Corner{0, 0.2}}}),
      CHANGE(c.start = Start::tank),
      CHANGE(c.duration = 3),
      CHANGE(c.sample_interval = 0.01),
      CHANGE(c.gauges[1].x = 0.9),
      CHANGE(c.gauges.pop_back())};
  std::set<std::string> keys{before};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    CaseDefinition changed = sample_case();
    changes[i](changed);
    EXPECT_TRUE(keys.insert(key(changed, sph)).second) << "change " << i;
  }
}

#undef CHANGE

TEST_F(RunKey, OfARunAtTheEndOfAnInputIsThatOfTheCaseWithThisInput) {
  RunDefinition end = sph;
  end.at_input = InputEnd{Input::fill_depth, 0.001, sph.name};
  EXPECT_NE(key(sample_case(), end), key(sample_case(), sph));
  CaseDefinition deeper = sample_case();
  deeper.liquid.fill_depth += 0.001;
  EXPECT_EQ(key(sample_case(), end), key(deeper, sph));
}

TEST_F(RunKey, ChangesWithTheSnapshotTimesOfASolverThatLeavesFieldsAlone) {
  const RunDefinition linear = sample_run(LinearRun{500, false, 0.1});
  CaseDefinition definition = sample_case();
  definition.snapshot_times = {0.5, 1};
  EXPECT_NE(key(definition, sph), key(sample_case(), sph));
  EXPECT_NE(key(definition, interfoam), key(sample_case(), interfoam));
  EXPECT_EQ(key(definition, linear), key(sample_case(), linear));
}

TEST_F(RunKey, ChangesWithTheGasOfASolverThatReadsItAlone) {
  const auto changes_of = [&](const RunDefinition& run) {
    int changes = 0;
    for (double GasDefinition::*number :
         {&GasDefinition::density, &GasDefinition::kinematic_viscosity}) {
      CaseDefinition changed = sample_case();
      changed.gas.*number *= 1.1;
      changes += key(changed, run) != key(sample_case(), run);
    }
    return changes;
  };
  EXPECT_EQ(changes_of(interfoam), 2);
  EXPECT_EQ(changes_of(sample_run(LinearRun{500, true, 0.1})), 2) << "theory of two layers";
  EXPECT_EQ(changes_of(sph), 0);
  EXPECT_EQ(changes_of(sample_run(LinearRun{500, false, 0.1})), 0);
  EXPECT_EQ(changes_of(sample_run(PotentialRun{})), 0);
  EXPECT_EQ(changes_of(sample_run(ViscousWaveRun{0.1})), 0);
  EXPECT_EQ(changes_of(sample_run(RecordRun{"a.csv", "elevation@left", "m", {0, 1}, {0, 1}, {}})),
            0);
}

TEST_F(RunKey, ChangesWithTheContentOfAMotionTable) {
  CaseDefinition a = sample_case(), b = sample_case();
  a.motion.surge = TableMotion{"table.csv", {0, 1, 2}, {0, 0.01, 0}};
  b.motion.surge = TableMotion{"table.csv", {0, 1, 2}, {0, 0.02, 0}};
  EXPECT_NE(key(a, sph), key(b, sph));
  a.motion = {.roll = RollDefinition{*a.motion.surge, 0, 0}};
  b.motion = {.roll = RollDefinition{*b.motion.surge, 0, 0}};
  EXPECT_NE(key(a, sph), key(b, sph));
}

TEST_F(RunKey, ChangesWithTheSolverAndItsSettings) {
  const CaseDefinition definition = sample_case();
  const RecordRun record{"a.csv", "elevation@left", "m", {0, 1, 2, 3}, {0, 1, 2, 3}, {}};
  RecordRun later = record, surer = record;
  later.time[3] = 4;
  surer.uncertainty = 0.1;
  const std::vector<RunDefinition> runs{sph,
                                        sample_run(SphRun{"recommended", 0.02, 0.02}),
                                        sample_run(SphRun{"li2010", 0.01, 0.01}),
                                        sample_run(SphRun{"li2010", 0.02, 0.01}),
                                        sample_run(SphRun{"li2010", 0.02, 0.02, "a_variant"}),
                                        interfoam,
                                        sample_run(InterFoamRun{50, 100, 1}),
                                        sample_run(InterFoamRun{50, 50, 2}),
                                        sample_run(LinearRun{500, false, 0.1}),
                                        sample_run(LinearRun{500, true, 0.1}),
                                        sample_run(LinearRun{600, false, 0.1}),
                                        sample_run(ViscousWaveRun{0.1}),
                                        sample_run(record),
                                        sample_run(later),
                                        sample_run(surer)};
  std::set<std::string> keys;
  for (const RunDefinition& run : runs) keys.insert(key(definition, run));
  for (const auto& [name, number] : sph_number_names)
    for (const double value : {0.0, 1.0}) {
      SphRun changed{"li2010", 0.02, 0.02};
      changed.numbers.*number = value;
      keys.insert(key(definition, sample_run(changed)));
    }
  EXPECT_EQ(keys.size(), runs.size() + 2 * std::size(sph_number_names));
  for (const auto& [disorder, seed] : {std::pair{0.05, 0}, {0.05, 1}, {0.1, 1}}) {
    SphRun repeat{"li2010", 0.02, 0.02};
    repeat.start_disorder = disorder;
    repeat.start_seed = seed;
    EXPECT_TRUE(keys.insert(key(definition, sample_run(repeat))).second) << disorder << " " << seed;
  }
  SphRun measured{"li2010", 0.02, 0.02};
  measured.speed_from_coarse_run = true;
  EXPECT_TRUE(keys.insert(key(definition, sample_run(measured))).second);
}

TEST_F(RunKey, OfInterFoamChangesWithTheDisturbanceOfItsStartAndNotWithTheSeedOfNone) {
  const auto key_of = [&](double disorder, int seed) {
    return key(sample_case(), sample_run(InterFoamRun{50, 50, 1, disorder, seed}));
  };
  EXPECT_EQ(key_of(0, 0), key(sample_case(), interfoam));
  const std::set<std::string> keys{key_of(0, 0), key_of(1e-3, 0), key_of(1e-3, 1), key_of(1e-4, 0)};
  EXPECT_EQ(keys.size(), 4u);
}

TEST_F(RunKey, DoesNotChangeWithWhatOnlyNamesOrJudgesARun) {
  CaseDefinition definition = sample_case();
  definition.title = "another title";
  definition.window_begin = 1;
  definition.declared_forcing_frequency = 3.8;
  definition.impacts.emplace();
  definition.impacts->gauge = "B";
  definition.gate.push_back({});
  definition.text += "# a comment";
  RunDefinition run = sph;
  run.name = "another_name";
  run.quick = true;
  EXPECT_EQ(key(definition, run), key(sample_case(), sph));
}

TEST_F(RunKey, ChangesWithItsOwnSolversBuildAlone) {
  const std::string before = key(sample_case(), sph), other = key(sample_case(), interfoam);
  std::ofstream(builds / "sph") << "another build of it";
  EXPECT_NE(key(sample_case(), sph), before);
  EXPECT_EQ(key(sample_case(), interfoam), other);
}

TEST_F(RunKey, TellsAnotherBuildFromAnotherQuestion) {
  const std::string before = key(sample_case(), sph);
  CaseDefinition heavier = sample_case();
  heavier.gravity = 9.9;
  EXPECT_FALSE(asks_the_same(key(heavier, sph), before));
  EXPECT_FALSE(asks_the_same(key(sample_case(), interfoam), before));
  std::ofstream(builds / "sph") << "another build of it";
  EXPECT_TRUE(asks_the_same(key(sample_case(), sph), before));
}

TEST_F(RunKey, IsToldFromThatOfAnEarlierBuildWithoutItsCase) {
  std::ofstream(builds / "sph") << "a build of it alone";
  const std::string before = key(sample_case(), sph), other = key(sample_case(), interfoam);
  EXPECT_TRUE(present_answers(builds, templates).gave(before));
  EXPECT_TRUE(present_answers(builds, templates).gave(other));
  std::ofstream(builds / "sph") << "another build of it";
  const PresentAnswers present = present_answers(builds, templates);
  EXPECT_FALSE(present.gave(before));
  EXPECT_TRUE(present.gave(other));
  EXPECT_TRUE(present.unknown_solvers.contains("external")) << "their program counts too";
  EXPECT_FALSE(present.unknown_solvers.contains("sph"));
}

TEST_F(RunKey, ChangesWithTheTemplatesOfInterFoamAlone) {
  const std::string interfoam_before = key(sample_case(), interfoam);
  const std::string sph_before = key(sample_case(), sph);
  std::ofstream(templates / "system" / "fvSolution") << "nOuterCorrectors 2;";
  EXPECT_NE(key(sample_case(), interfoam), interfoam_before);
  EXPECT_EQ(key(sample_case(), sph), sph_before);
}

TEST_F(RunKey, IsRefusedWithoutTheSolversBuildOrTemplates) {
  EXPECT_THROW(run_key(sample_case(), sph, directory.path() / "absent", templates),
               std::filesystem::filesystem_error);
  EXPECT_THROW(run_key(sample_case(), interfoam, builds, directory.path() / "absent"),
               std::filesystem::filesystem_error);
}

// What was asked: arguments, inputs and how the files are read; what answered: the program.
TEST_F(RunKey, OfAnExternalRunChangesWithItsProgramItsInputsAndWhatIsReadOfIt) {
  const std::filesystem::path program = directory.path() / "solve", input = directory.path() / "in";
  std::ofstream(program) << "first build";
  std::ofstream(input) << "dp = 0.01";
  CaseDefinition definition = sample_case();
  definition.file = directory.path() / "small.toml";
  ExternalRun external;
  external.command = {"./solve", "--fast"};
  external.inputs = {input};
  external.series = {{"elevation@right", "swl.csv", "csv", "eta"}};
  const auto key_of = [&](const ExternalRun& run) { return key(definition, sample_run(run)); };
  const std::string before = key_of(external);
  EXPECT_EQ(key_of(external), before);
  ExternalRun limited = external;
  limited.time_limit = 10;
  EXPECT_EQ(key_of(limited), before);

  ExternalRun slower = external, scaled = external;
  slower.command[1] = "--slow";
  scaled.series[0].scale = 2;
  for (const ExternalRun& changed : {slower, scaled})
    EXPECT_FALSE(asks_the_same(key_of(changed), before));
  std::ofstream(program) << "second build";
  const std::string rebuilt = key_of(external);
  EXPECT_NE(rebuilt, before);
  EXPECT_TRUE(asks_the_same(rebuilt, before));
  std::ofstream(input) << "dp = 0.02";
  EXPECT_FALSE(asks_the_same(key_of(external), before));
}

TEST_F(RunKey, OfAnExternalRunChangesWithWhatLiesBelowADirectoryOfItsInputs) {
  const std::filesystem::path modules = directory.path() / "modules";
  std::filesystem::create_directories(modules / "deep");
  const auto write = [&](const char* name, const char* text) {
    std::ofstream(modules / name) << text;
  };
  write("a.py", "first");
  write("deep/b.py", "first");
  CaseDefinition definition = sample_case();
  definition.file = directory.path() / "small.toml";
  ExternalRun external;
  external.command = {"python3", "-m", "a"};
  external.inputs = {modules};
  external.series = {{"elevation@right", "swl.csv", "csv", "eta"}};
  const auto changed_by = [&](const auto& change) {
    const std::string before = key(definition, sample_run(external));
    change();
    return !asks_the_same(key(definition, sample_run(external)), before);
  };
  EXPECT_TRUE(changed_by([&] { write("deep/b.py", "second"); }));
  EXPECT_TRUE(changed_by([&] { write("deep/c.py", ""); }));
  EXPECT_TRUE(changed_by([&] { std::filesystem::remove(modules / "a.py"); }));
  EXPECT_TRUE(changed_by(
      [&] { std::filesystem::rename(modules / "deep" / "b.py", modules / "deep" / "d.py"); }));
  EXPECT_FALSE(changed_by([&] { write(".hidden", "first"); }));
}

TEST_F(RunKey, OfAnExternalRunChangesWithTheDirectoryThatItStartsInAndNotWithThatOfItsCase) {
  CaseDefinition definition = sample_case();
  definition.file = "/here/small.toml";
  ExternalRun external;
  external.command = {"sh"};
  const auto key_of = [&](const char* directory) {
    external.directory = directory;
    return key(definition, sample_run(external));
  };
  const std::string first = key_of("/here/v1/tables");
  EXPECT_NE(key_of("/here/v2/tables"), first) << "of the same last name";
  EXPECT_NE(key_of(""), first);
  definition.file = "/there/small.toml";
  EXPECT_EQ(key_of("/there/v1/tables"), first);
}

TEST_F(RunKey, OfAStoredResultChangesWithEachOfItsFiles) {
  const std::filesystem::path facts = directory.path() / "cost.json",
                              series = directory.path() / "swl.csv";
  std::ofstream(facts) << "{}";
  std::ofstream(series) << "t,eta";
  const RunDefinition run =
      sample_run(StoredRun{{{"elevation@right", series, "csv", "eta"}}, "their_sph", 0.02, facts});
  const std::string before = key(sample_case(), run);
  EXPECT_EQ(key(sample_case(), run), before);
  std::ofstream(facts) << "{ }";
  const std::string after = key(sample_case(), run);
  EXPECT_FALSE(asks_the_same(after, before));
  std::ofstream(series) << "t,swl";
  EXPECT_FALSE(asks_the_same(key(sample_case(), run), after));
}

TEST_F(RunKey, OfAnExternalRunChangesWithAnArgumentThatIsAFile) {
  const std::filesystem::path elsewhere = directory.path() / "elsewhere";
  std::filesystem::create_directories(elsewhere);
  CaseDefinition definition = sample_case();
  definition.file = directory.path() / "small.toml";
  std::ofstream(definition.file) << "limit = 1";
  ExternalRun external;
  external.command = {"python3",
                      "gen.py",
                      "{case_directory}/table.csv",
                      "--settings=fine.cfg",
                      "@more.cfg",
                      "--most=@most.cfg",
                      "{case_file}",
                      "{work_directory}/out.csv"};
  external.directory = elsewhere;
  external.series = {{"elevation@right", "swl.csv", "csv", "eta"}};
  const auto changes_with = [&](const std::filesystem::path& file) {
    std::ofstream(file) << "first";
    const std::string before = key(definition, sample_run(external));
    std::ofstream(file) << "second";
    return !asks_the_same(key(definition, sample_run(external)), before);
  };
  EXPECT_TRUE(changes_with(directory.path() / "gen.py")) << "relative to the case file";
  EXPECT_TRUE(changes_with(elsewhere / "gen.py")) << "relative to the run's directory";
  EXPECT_TRUE(changes_with(directory.path() / "table.csv"));
  for (const char* file : {"fine.cfg", "more.cfg", "most.cfg"})
    EXPECT_TRUE(changes_with(elsewhere / file)) << file;
  EXPECT_FALSE(changes_with(definition.file)) << "of it the physics counts";
  EXPECT_FALSE(changes_with(directory.path() / "unnamed.cfg"));
}

}  // namespace
}  // namespace slosh::run_key_test
