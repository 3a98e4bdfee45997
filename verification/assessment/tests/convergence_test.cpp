#include "verification/assessment/convergence.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "verification/case/ensemble.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/made_cases.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/runs/run_key.hpp"
#include "verification/tests/surge_results.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::convergence_test {
namespace {

namespace fs = std::filesystem;

// 1 + h^order at h = 1, 2, 4, of equal noise.
std::vector<ValueAtStep> power_law(double order, double noise) {
  std::vector<ValueAtStep> values;
  for (const double step : {4.0, 2.0, 1.0})
    values.push_back({step, 1 + std::pow(step, order), noise});
  return values;
}

TEST(Convergence, TellsHowFarTheOrderMovesWithItsValuesAndLeavesItOpenWhereThereMayBeNone) {
  EXPECT_NEAR(order_half_width(power_law(1.5, 0)).value(), 0, 1e-9);
  // p = log2((f3 - f2) / (f2 - f1)): with f = 2, 3, 5 and noise n the derivatives by f1, f2, f3 are
  // 1, -3/2 and 1/2 over ln 2.
  const double noise = 1e-4;
  EXPECT_NEAR(order_half_width(power_law(1, noise)).value(),
              noise * std::sqrt(1 + 2.25 + 0.25) / std::log(2), 1e-2 * noise);
  EXPECT_TRUE(order_half_width(power_law(1, 0.3)).has_value());
  EXPECT_FALSE(order_half_width(power_law(1, 0.9)).has_value());
  EXPECT_FALSE(order_half_width({{1, 3, 0}, {2, 2, 0}, {4, 0, 0}}).has_value() &&
               order_half_width({{1, 0, 0}, {2, 1, 0}, {4, 1.5, 0}}).has_value())
      << "differences that grow as the step falls have no order";
}

// "particles" at 10 mm and at the two coarser spacings, each too high by error(h).
template <class Error>
Convergence convergence_over(const std::vector<double>& spacings, Error error) {
  CaseDefinition definition = surge_case();
  definition.gate.clear();
  CaseRuns runs = surge_runs();
  definition.refinements = {{"spacing", RefinedNumber::particle_spacing, {"particles"}}};
  runs.results["particles"] = result_of("particles", scaled(elevation_of({}), 1 + error(0.01)));
  for (const double spacing : spacings) {
    RunDefinition coarse = definition.runs.at(2);
    coarse.name = fmt::format("particles_{}", definition.runs.size());
    auto& sph = std::get<SphRun>(coarse.solver);
    sph.particle_spacing = sph.surface_particle_spacing = spacing;
    definition.runs.push_back(coarse);
    definition.refinements[0].runs.push_back(coarse.name);
    runs.results[coarse.name] =
        result_of(coarse.name, scaled(elevation_of({}), 1 + error(spacing)));
    runs.status[coarse.name] = {RunState::finished, ""};
  }
  return convergence_of(assess(definition, runs), {"particles", "theory", surge_quantity});
}

TEST(Convergence, SaysThatARefinementChangedNothing) {
  const auto second_order = [](double h) { return 100 * h * h; };
  EXPECT_FALSE(convergence_over({0.02, 0.04}, second_order).metrics.empty());
  const auto says = [](const Convergence& found, const char* what) {
    EXPECT_TRUE(found.metrics.empty());
    ASSERT_FALSE(found.not_measured.empty());
    EXPECT_NE(found.not_measured[0].find(what), std::string::npos) << found.not_measured[0];
  };
  says(convergence_over({0.02, 0.04}, [](double) { return 0.05; }),
       "have the same elevation@right: the refinement changed nothing");
  says(convergence_over({0.0100000000001, 0.02}, second_order),
       "fewer than three spacings have it that differ by a factor of 1.1 or more");
}

class SpacingStudies : public ::testing::Test {
 protected:
  CaseDefinition made(const CaseDefinition& definition, const SpacingStudy& study) const {
    const fs::path file = temporary_.path() / (definition.name + ".toml");
    const StudyText made = spacing_study_text(definition, study);
    std::ofstream(file) << made.text;
    for (const auto& [source, place] : made.tables) {
      fs::create_directories((temporary_.path() / place).parent_path());
      fs::copy_file(source, temporary_.path() / place, fs::copy_options::overwrite_existing);
    }
    return read_case(file);
  }
  std::string key(const CaseDefinition& definition, const std::string& run) const {
    const fs::path builds = temporary_.path() / "builds";
    fs::create_directory(builds);
    for (const char* kind : {"sph", "interfoam", "linear", "potential", "viscous_wave", "record"})
      std::ofstream(builds / kind) << "a build";
    return run_key(definition, run_named(definition, run), builds, temporary_.path());
  }

  TemporaryDirectory temporary_;
};

TEST_F(SpacingStudies, AskTheSameOfTheReferenceAndOfARunAtItsOwnSpacingInEveryShippedCase) {
  int studied = 0;
  for (const auto& entry : fs::directory_iterator(SLOSH_SOURCE_DIR "/verification/cases")) {
    if (entry.path().extension() != ".toml") continue;
    const CaseDefinition definition = read_case(entry.path());
    const RunDefinition& reference = definition.runs.front();
    const RunDefinition& last =
        *std::find_if_not(definition.runs.rbegin(), definition.runs.rend(), is_later_member);
    for (const RunDefinition& run : definition.runs) {
      if (is_later_member(run)) continue;  // of an ensemble that the file names once
      const auto* sph = std::get_if<SphRun>(&run.solver);
      if (!sph || sph->particle_spacing != sph->surface_particle_spacing) continue;
      const double spacing = sph->particle_spacing;
      const SpacingStudy study{.candidate = run.name,
                               .family = "",
                               .spacings = {spacing / 4, spacing / 2, spacing},
                               .reference = &run == &reference ? last.name : reference.name};
      const CaseDefinition case_of_study = made(definition, study);
      EXPECT_EQ(case_of_study.runs.size(), 4u);
      EXPECT_EQ(case_of_study.refinements.size(), 1u);
      EXPECT_TRUE(case_of_study.gate.empty());
      EXPECT_EQ(key(case_of_study, study.reference), key(definition, study.reference));
      EXPECT_EQ(key(case_of_study, study_run_name(study, spacing)), key(definition, run.name))
          << definition.name << "/" << run.name;
      ++studied;
      break;
    }
  }
  EXPECT_GT(studied, 30);
}

TEST_F(SpacingStudies, NameTheirRunsBySpacingAndDropTheImpactsAndWhatOnlyEnsemblesHave) {
  EXPECT_EQ(study_run_name({"", "li2010", {}, ""}, 0.0125), "li2010_12p5mm");
  EXPECT_EQ(study_run_name({"fine", "", {}, ""}, 0.02), "fine_at_20mm");
  const CaseDefinition oil = read_case(SLOSH_SOURCE_DIR "/verification/cases/spheric10_oil.toml");
  ASSERT_FALSE(oil.inputs.empty()) << "its ensemble draws them";
  const CaseDefinition study = made(oil, {.candidate = "inputs_drawn_4mm",
                                          .family = "",
                                          .spacings = {0.004, 0.006, 0.008},
                                          .reference = "interfoam_90x51"});
  EXPECT_EQ(study.runs.size(), 4U);
  EXPECT_FALSE(study.impacts);
}

}  // namespace
}  // namespace slosh::convergence_test
