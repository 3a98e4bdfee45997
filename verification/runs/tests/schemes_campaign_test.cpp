// The shipped campaigns: `schemes` leaves out none of the schemes and variants that there are.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "sph/simulation.hpp"
#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"

namespace slosh::schemes_campaign_test {
namespace {

namespace fs = std::filesystem;

const fs::path verification = fs::path(SLOSH_SOURCE_DIR) / "verification";

std::vector<CaseDefinition> cases_of(const std::string& campaign) {
  std::vector<CaseDefinition> cases;
  for (const fs::path& file :
       read_campaign(verification / "campaigns" / (campaign + ".toml"), verification / "cases", {})
           .cases)
    cases.push_back(read_case(file));
  return cases;
}

std::vector<SphRun> sph_runs(const CaseDefinition& definition) {
  std::vector<SphRun> runs;
  for (const RunDefinition& run : definition.runs)
    if (const auto* sph = std::get_if<SphRun>(&run.solver)) runs.push_back(*sph);
  return runs;
}

bool changes_numbers(const SphRun& run) {
  return std::any_of(std::begin(sph_number_names), std::end(sph_number_names),
                     [&](const auto& entry) { return (run.numbers.*entry.second).has_value(); });
}

TEST(SchemesCampaign, SetsEveryVariantBesideTheUnchangedRunOfItsSpacing) {
  const std::vector<SphRun> runs = sph_runs(cases_of("schemes").front());
  for (const std::string& variant : sph::variant_names())
    EXPECT_TRUE(std::any_of(runs.begin(), runs.end(), [&](const SphRun& run) {
      return run.variant == variant && !changes_numbers(run) &&
             run.surface_particle_spacing == 0.01;
    })) << variant;
  EXPECT_TRUE(std::any_of(runs.begin(), runs.end(), [](const SphRun& run) {
    return run.scheme == "recommended" && run.variant.empty() && !changes_numbers(run) &&
           run.particle_spacing == 0.01;
  }));
}

TEST(ShippedCampaigns, RunEveryScheme) {
  std::vector<SphRun> runs;
  for (const char* campaign : {"schemes", "li2010", "zhao2021"})
    for (const CaseDefinition& definition : cases_of(campaign))
      for (const SphRun& run : sph_runs(definition)) runs.push_back(run);
  for (const std::string& scheme : sph::scheme_names())
    EXPECT_TRUE(std::any_of(runs.begin(), runs.end(), [&](const SphRun& run) {
      return run.scheme == scheme;
    })) << scheme;
}

TEST(SchemesCampaign, ChangesEachNumberOfTheScheme) {
  const std::vector<SphRun> runs = sph_runs(cases_of("schemes").front());
  for (const auto& [name, number] : sph_number_names)
    EXPECT_GE(std::count_if(runs.begin(), runs.end(),
                            [number = number](const SphRun& run) {
                              return run.variant.empty() && (run.numbers.*number).has_value();
                            }),
              2)
        << name;
}

}  // namespace
}  // namespace slosh::schemes_campaign_test
