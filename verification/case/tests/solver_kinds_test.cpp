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

TEST(SolverKinds, TellMeshesApartByTheirProgramAndWhatIsChangedOfThem) {
  struct Row {
    InterFoamRun mesh;
    const char *caption, *work_family, *settings;
  };
  const InterFoamRun usual{50, 40};
  InterFoamRun sharp = usual, shorter = usual, fewer = usual, graded = usual, across = usual;
  sharp.program = FoamProgram::inter_iso_foam;
  shorter.interface_courant_number = 0.25;
  fewer.courant_number = fewer.interface_courant_number = 0.25;
  graded.no_slip = across.no_slip = true;
  graded.wall_cell = 0.001;
  across.cells_y = 8;
  for (const auto& [mesh, caption, family_of_work, settings] :
       {Row{usual, "interFoam, 50 x 40 cells", "interFoam", R"({"interfoam":[50,40,1]})"},
        {sharp, "interIsoFoam, 50 x 40 cells", "interIsoFoam",
         R"({"interfoam":[50,40,1],"program":"interIsoFoam"})"},
        {shorter, "interFoam, 50 x 40 cells, interface_courant_number = 0.25",
         "interFoam, interface_courant_number = 0.25",
         R"({"changes":[0.5,0.25,1,false,0.0],"interfoam":[50,40,1]})"},
        {fewer, "interFoam, 50 x 40 cells, courant_number = 0.25",
         "interFoam, courant_number = 0.25",
         R"({"changes":[0.25,0.25,1,false,0.0],"interfoam":[50,40,1]})"},
        {graded, "interFoam, 50 x 40 cells, no_slip, graded cells",
         "interFoam, no_slip, graded cells",
         R"({"changes":[0.5,0.5,1,true,0.001],"interfoam":[50,40,1]})"},
        {across, "interFoam, 50 x 8 x 40 cells, no_slip, three dimensions",
         "interFoam, no_slip, three dimensions",
         R"({"cells_y":8,"changes":[0.5,0.5,1,true,0.0],"interfoam":[50,40,1]})"}}) {
    const RunDefinition run = run_of(mesh);
    EXPECT_EQ(caption_text(run), caption);
    EXPECT_EQ(work_family(run), family_of_work);
    EXPECT_EQ(hashed_settings(run).dump(), settings) << "the results keep their keys";
    EXPECT_EQ(is_changed(run), work_family(run) != family(run));
  }
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

TEST(SolverKinds, TakeAnExternalProgramsMethodForASchemeAndHashItsSpacingAlone) {
  const ExternalRun mine{{"bin/my_sph"}, {}, {}, {}, {}, "my_sph", 0.02};
  EXPECT_EQ(family(run_of(mine)), "my_sph");
  EXPECT_DOUBLE_EQ(resolution(run_of(mine)), 2500);
  EXPECT_EQ(particle_spacing(run_of(mine)), 0.02);
  EXPECT_EQ(caption_text(run_of(mine)), "external program my_sph, method my_sph, spacing 20 mm");
  EXPECT_EQ(family(runs.at("external")), "one") << "it is its own family";
  EXPECT_FALSE(particle_spacing(runs.at("external")));
  ExternalRun finer = mine, renamed = mine;
  finer.particle_spacing = 0.01;
  renamed.method = "our_sph";
  EXPECT_NE(hashed_settings(run_of(finer)), hashed_settings(run_of(mine)));
  EXPECT_EQ(hashed_settings(run_of(renamed)), hashed_settings(run_of(mine)));
}

}  // namespace
}  // namespace slosh::solver_kinds_test
