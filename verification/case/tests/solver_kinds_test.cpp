#include "verification/case/solver_kinds.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

namespace slosh::solver_kinds_test {
namespace {

RunDefinition run_of(decltype(RunDefinition::solver) solver) {
  return {.name = "one", .solver = std::move(solver), .where = {}};
}

const std::map<std::string, RunDefinition> runs{
    {"sph", run_of(SphRun{"recommended", 0.01, 0.01})},
    {"interfoam", run_of(InterFoamRun{50, 40, 2})},
    {"interisofoam", run_of(InterFoamRun{50, 40, 2, 0, 0, FoamProgram::inter_iso_foam})},
    {"compressible_interfoam",
     run_of(InterFoamRun{50, 40, 2, 0, 0, FoamProgram::compressible_inter_foam})},
    {"linear", run_of(LinearRun{.modes = 5, .valid_elevation_over_depth = 1})},
    {"viscous_wave", run_of(ViscousWaveRun{0.1})},
    {"potential", run_of(PotentialRun{})},
    {"record", run_of(RecordRun{"front.csv", "front_position", "m", {0.2}, {0.1}, {}})},
    {"external", run_of(ExternalRun{{"bin/my_sph"}, {}, {}, {}, {}})},
    {"stored", run_of(StoredRun{{}, "their_sph", 0.02, "cost.json"})}};

TEST(SolverKinds, AreFoundByTheirNames) {
  // OpenFOAM's three programs have one kind of run.
  EXPECT_EQ(runs.size(), std::variant_size_v<decltype(RunDefinition::solver)> + 2);
  for (const auto& [name, run] : runs) {
    EXPECT_EQ(solver_name(run), name);
    EXPECT_EQ(find_solver_kind(name), &solver_kind(run));
  }
  EXPECT_EQ(find_solver_kind("problems"), nullptr);
}

TEST(SolverKinds, HaveTextsAndSettingsOfTheirOwn) {
  std::set<std::string> texts, captions, settings;
  for (const auto& [name, run] : runs) {
    texts.insert(solver_text(run));
    captions.insert(caption_text(run));
    settings.insert(hashed_settings(run).dump());
  }
  EXPECT_EQ(texts.size(), runs.size());
  EXPECT_EQ(captions.size(), runs.size());
  EXPECT_EQ(settings.size(), runs.size());
}

TEST(SolverKinds, TellTheoryOfTheLiquidFromThatWithTheGas) {
  EXPECT_FALSE(sees_gas(runs.at("linear")));
  EXPECT_TRUE(sees_gas(run_of(LinearRun{5, true, 1})));
  EXPECT_TRUE(sees_gas(runs.at("interfoam")));
  EXPECT_FALSE(sees_gas(runs.at("sph")));
}

TEST(SolverKinds, GroupRunsInFamiliesByResolution) {
  EXPECT_EQ(family(runs.at("sph")), "recommended");
  EXPECT_EQ(family(runs.at("interfoam")), "interFoam");
  EXPECT_EQ(family(runs.at("linear")), "one");
  EXPECT_DOUBLE_EQ(resolution(runs.at("sph")), 1e4);
  EXPECT_DOUBLE_EQ(resolution(runs.at("interfoam")), 2000);
  EXPECT_EQ(resolution(runs.at("record")), 0);
}

TEST(SolverKinds, TellTheProgramsOfOpenFoamApart) {
  const RunDefinition sharp =
      run_of(InterFoamRun{.cells_x = 50, .cells_z = 40, .program = FoamProgram::inter_iso_foam});
  EXPECT_EQ(family(sharp), "interIsoFoam");
  EXPECT_EQ(caption_text(sharp), "interIsoFoam, 50 x 40 cells");
  EXPECT_EQ(family(runs.at("compressible_interfoam")), "compressibleInterFoam");
  const RunDefinition plain = run_of(InterFoamRun{50, 40});
  EXPECT_NE(hashed_settings(sharp), hashed_settings(plain));
  EXPECT_EQ(hashed_settings(plain).dump(), "{\"interfoam\":[50,40,1]}")
      << "the results of interFoam keep their keys";
}

TEST(SolverKinds, TellAMeshWithAnotherCourantNumberApart) {
  const RunDefinition usual = run_of(InterFoamRun{50, 40});
  InterFoamRun mesh{50, 40};
  mesh.courant_number = mesh.interface_courant_number = 0.25;
  EXPECT_EQ(work_family(run_of(mesh)), "interFoam, courant_number = 0.25");
  mesh.courant_number = 0.5;
  const RunDefinition shorter = run_of(mesh);
  EXPECT_EQ(family(shorter), "interFoam");
  EXPECT_EQ(work_family(shorter), "interFoam, interface_courant_number = 0.25");
  EXPECT_EQ(caption_text(shorter), "interFoam, 50 x 40 cells, interface_courant_number = 0.25");
  EXPECT_TRUE(is_changed(shorter));
  EXPECT_FALSE(is_changed(usual));
  EXPECT_NE(hashed_settings(shorter), hashed_settings(usual));
}

TEST(SolverKinds, TellAMeshWithNoSlipOrGradedCellsApart) {
  InterFoamRun graded{50, 40};
  graded.no_slip = true;
  graded.wall_cell = 0.001;
  EXPECT_EQ(work_family(run_of(graded)), "interFoam, no_slip, graded cells");
  InterFoamRun thinner = graded;
  thinner.wall_cell = 0.0005;
  EXPECT_NE(hashed_settings(run_of(graded)), hashed_settings(run_of(thinner)));
  EXPECT_EQ(work_family(run_of(graded)), work_family(run_of(thinner)))
      << "meshes of a refinement have wall cells of their own";
}

TEST(SolverKinds, TellAMeshInThreeDimensionsApart) {
  InterFoamRun across{50, 40};
  across.no_slip = true;
  const InterFoamRun plane = across;
  across.cells_y = 8;
  EXPECT_EQ(work_family(run_of(across)), "interFoam, no_slip, three dimensions");
  EXPECT_EQ(solver_text(run_of(across)), "interFoam, 50 x 8 x 40 cells, no_slip, three dimensions");
  EXPECT_NE(hashed_settings(run_of(across)), hashed_settings(run_of(plane)));
  EXPECT_EQ(number_of_cells(across), 16000);
}

TEST(SolverKinds, KnowAStoredResultByItsMethod) {
  const RunDefinition& stored = runs.at("stored");
  EXPECT_TRUE(is_stored(stored));
  EXPECT_FALSE(is_stored(runs.at("external")));
  EXPECT_TRUE(is_simulation(stored)) << "it is a candidate";
  EXPECT_EQ(family(stored), "their_sph");
  EXPECT_EQ(method_of(stored), "their_sph");
  EXPECT_EQ(method_of(runs.at("sph")), "");
  EXPECT_DOUBLE_EQ(resolution(stored), 2500);
  EXPECT_EQ(particle_spacing(stored), 0.02);
  EXPECT_EQ(solver_text(stored), "stored result, method `their_sph`, spacing 20 mm");
}

TEST(SolverKinds, TakeAnExternalProgramsMethodForAScheme) {
  ExternalRun mine{{"bin/my_sph"}, {}, {}, {}, {}, "my_sph", 0.02};
  EXPECT_EQ(family(run_of(mine)), "my_sph");
  EXPECT_DOUBLE_EQ(resolution(run_of(mine)), 2500);
  EXPECT_EQ(particle_spacing(run_of(mine)), 0.02);
  EXPECT_EQ(caption_text(run_of(mine)), "external program my_sph, method my_sph, spacing 20 mm");
  EXPECT_EQ(family(runs.at("external")), "one") << "it is its own family";
  EXPECT_FALSE(particle_spacing(runs.at("external")));
}

TEST(SolverKinds, HashAnExternalProgramsSpacingAndNotItsMethodsName) {
  const ExternalRun mine{{"bin/my_sph"}, {}, {}, {}, {}, "my_sph", 0.02};
  ExternalRun finer = mine, renamed = mine;
  finer.particle_spacing = 0.01;
  renamed.method = "our_sph";
  EXPECT_NE(hashed_settings(run_of(finer)), hashed_settings(run_of(mine)));
  EXPECT_EQ(hashed_settings(run_of(renamed)), hashed_settings(run_of(mine)));
}

}  // namespace
}  // namespace slosh::solver_kinds_test
