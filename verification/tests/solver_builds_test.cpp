// What the keys of results rest on: the sources in each file of slosh.builds.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace slosh::solver_builds_test {
namespace {

// Paths from the source tree's root, as "sph/liquid.hpp".
std::set<std::string> files_behind(const std::string& kind) {
  std::set<std::string> files;
  std::ifstream text(SLOSH_BUILDS "/" + kind);
  for (std::string line; std::getline(text, line);)
    if (line.starts_with("== ")) files.insert(line.substr(3));
  return files;
}

bool any_in(const std::set<std::string>& files, const std::string& folder) {
  const auto first = files.lower_bound(folder);
  return first != files.end() && first->starts_with(folder);
}

const std::vector<std::string> kinds{"sph",          "interfoam", "linear",   "potential",
                                     "viscous_wave", "record",    "external", "stored"};

TEST(SolverBuilds, RestOnNoGateMetricReportOrCampaign) {
  const std::vector<std::string> others{
      "verification/gate/",        "verification/evidence/", "verification/assessment/",
      "verification/sensitivity/", "verification/fits/",     "verification/metrics/",
      "verification/convergence/", "verification/campaign/", "verification/engine/",
      "verification/papers/",      "verification/baseline/", "verification/cli/texts/",
      "verification/case_file/",   "verification/cli/",      "verification/engine/",
      "verification/runs/",        "verification/problems/", "reports/"};
  for (const std::string& folder : others)
    EXPECT_TRUE(std::filesystem::is_directory(SLOSH_SOURCE_DIR "/" + folder)) << folder;
  for (const std::string& kind : kinds) {
    const std::set<std::string> files = files_behind(kind);
    EXPECT_TRUE(files.contains("verification/solvers/" + kind + "_run.cpp")) << kind;
    EXPECT_TRUE(files.contains("verification/results/result_file.hpp")) << kind;
    for (const std::string& folder : others)
      EXPECT_FALSE(any_in(files, folder)) << kind << " rests on " << folder;
  }
}

TEST(SolverBuilds, RestOnTheirOwnSolverAlone) {
  const std::vector<std::pair<std::string, std::string>> folders{{"sph", "sph/"},
                                                                 {"interfoam", "openfoam_cases/"}};
  for (const auto& [owner, folder] : folders)
    for (const std::string& kind : kinds)
      EXPECT_EQ(any_in(files_behind(kind), folder), kind == owner) << kind << ": " << folder;
  const std::set<std::string> importing{"external", "stored"};
  for (const std::string& kind : kinds)
    EXPECT_EQ(any_in(files_behind(kind), "verification/import/"), importing.contains(kind)) << kind;
  for (const std::string kind : {"linear", "potential", "viscous_wave"})
    EXPECT_TRUE(any_in(files_behind(kind), "reference/")) << kind;
  for (const std::string kind : {"sph", "interfoam", "external"})
    EXPECT_FALSE(
        files_behind(kind).contains("reference/potential_flow/nonlinear_potential_flow.cpp"))
        << kind;
}

TEST(SolverBuilds, OfProblemsRestOnSphAlone) {
  EXPECT_TRUE(any_in(files_behind("problems"), "sph/"));
  EXPECT_FALSE(any_in(files_behind("problems"), "verification/fits/harmonic_fit.cpp"));
}

}  // namespace
}  // namespace slosh::solver_builds_test
