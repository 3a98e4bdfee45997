// Each solver, coarse, against linear theory on the same case: a sign, a frame or a gauge
// translated wrongly shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "openfoam_cases/surging_tank.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/tests/sample_case.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh {
namespace {

// Linear theory is the truth to a few percent here; 30 % lets a coarse solver pass, a wrong sign or
// frame errs by 100 %.
constexpr double allowed = 0.3;

RunResult run(const CaseDefinition& definition, const decltype(RunDefinition::solver)& solver) {
  const TemporaryDirectory directory;
  const RunSettings settings{.work_directory = directory.path(),
                             .openfoam_templates = SLOSH_SOURCE_DIR "/openfoam_cases/surging_tank",
                             .key = {},
                             .command = {}};
  return execute(definition, sample_run(solver), settings, [](double, double) {});
}

double normalised_difference(const TimeSeries& a, const TimeSeries& b) {
  double difference = 0, norm = 0;
  const std::size_t count = std::min(a.value.size(), b.value.size());
  for (std::size_t i = 5; i < count; ++i) {  // the first samples see the impulse of an abrupt start
    EXPECT_NEAR(a.time[i], b.time[i], 5e-3);
    difference += std::pow(a.value[i] - b.value[i], 2);
    norm += std::pow(b.value[i], 2);
  }
  return std::sqrt(difference / norm);
}

void expect_linear_theory(Start start, const decltype(RunDefinition::solver)& solver) {
  CaseDefinition definition = sample_case();
  definition.start = start;
  const RunResult exact =
      run(definition, LinearRun{.modes = 500, .valid_elevation_over_depth = 0.1});
  const RunResult result = run(definition, solver);
  for (const char* name : {"elevation@left", "elevation@right"}) {
    const double difference = normalised_difference(result.at(name), exact.at(name));
    EXPECT_TRUE(difference <= allowed) << name << ": " << difference;
  }
}

TEST(SolverTranslation, SphFollowsLinearTheoryFromAStartInTheEarthsFrame) {
  expect_linear_theory(Start::earth, SphRun{"low_dissipation_wendland", 0.025, 0.025});
}

TEST(SolverTranslation, InterFoamFollowsLinearTheoryFromEitherStart) {
  if (openfoam::installed_version().empty()) GTEST_SKIP() << "interFoam is not installed";
  expect_linear_theory(Start::earth, InterFoamRun{40, 80, 1});
  expect_linear_theory(Start::tank, InterFoamRun{40, 80, 1});
}

TEST(SolverTranslation, InterFoamLeavesItsSeriesAndDiagnostics) {
  if (openfoam::installed_version().empty()) GTEST_SKIP() << "interFoam is not installed";
  CaseDefinition definition = sample_case();
  definition.duration = 0.1;
  const RunResult result = run(definition, InterFoamRun{20, 20, 1});
  EXPECT_EQ(result.solver, "interfoam");
  EXPECT_EQ(result.at("horizontal_force").unit, "N/m");
  EXPECT_NEAR(result.at("liquid_volume").value.front(), 0.35, 1e-6);
  EXPECT_LT(std::abs(result.diagnostics.at("relative_mass_loss")), 1e-3);
  EXPECT_GT(result.cost.steps, 10);
  EXPECT_EQ(result.cost.elements, 400);
  EXPECT_FALSE(result.provenance.at("openfoam_version").empty());
}

TEST(SolverTranslation, InterFoamWithoutItsTemplatesIsASolverError) {
  const TemporaryDirectory directory;
  EXPECT_THROW(execute(sample_case(), sample_run(InterFoamRun{20, 20, 1}),
                       {.work_directory = directory.path(),
                        .openfoam_templates = directory.path() / "absent",
                        .key = {},
                        .command = {}},
                       [](double, double) {}),
               SolverError);
}

}  // namespace
}  // namespace slosh
