// What the keys of results rest on, read from the build's own graph: the objects that each file of
// slosh.builds is made of, their sources and all headers that these include.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace slosh::solver_builds_test {
namespace {

std::vector<std::string> lines_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (const std::size_t got = fread(part.data(), 1, part.size(), pipe.get()))
    text.append(part.data(), got);
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

const std::string ninja = "ninja -C " SLOSH_BUILD_DIR " -t ";

// Paths from the source tree's root, as "sph/step.hpp".
std::set<std::string> files_behind(const std::string& kind) {
  std::set<std::string> files;
  const auto add = [&](const std::string& path) {
    const auto root = path.find(SLOSH_SOURCE_DIR "/");
    const std::string up = "../../";
    if (root != std::string::npos)
      files.insert(path.substr(root + sizeof SLOSH_SOURCE_DIR));
    else if (path.find(up) != std::string::npos)
      files.insert(path.substr(path.find(up) + up.size()));
  };
  std::string objects;
  for (const std::string& input : lines_of(ninja + "inputs verification/slosh.builds/" + kind)) {
    add(input);
    if (input.ends_with(".o")) objects += " " + input;
  }
  for (const std::string& line : lines_of(ninja + "deps" + objects)) add(line);
  return files;
}

bool any_in(const std::set<std::string>& files, const std::string& folder) {
  const auto first = files.lower_bound(folder);
  return first != files.end() && first->starts_with(folder);
}

const std::vector<std::string> kinds{"sph",          "interfoam", "linear",   "potential",
                                     "viscous_wave", "record",    "external", "stored"};

TEST(SolverBuilds, RestOnNoGateMetricReportOrCampaign) {
  const std::vector<std::string> others{"verification/gate/",
                                        "verification/evidence/",
                                        "verification/assessment/",
                                        "verification/sensitivity/",
                                        "verification/fits/",
                                        "verification/metrics/",
                                        "verification/convergence/",
                                        "verification/campaign/",
                                        "verification/engine/",
                                        "verification/papers/",
                                        "verification/baseline/",
                                        "verification/texts/",
                                        "verification/cli/",
                                        "verification/display/",
                                        "verification/runs/",
                                        "verification/problems/",
                                        "reports/"};
  for (const std::string& folder : others)
    EXPECT_TRUE(std::filesystem::is_directory(SLOSH_SOURCE_DIR "/" + folder)) << folder;
  for (const std::string& kind : kinds) {
    const std::set<std::string> files = files_behind(kind);
    EXPECT_TRUE(files.contains("verification/solvers/" + kind + "_run.cpp")) << kind;
    EXPECT_TRUE(files.contains("verification/case/case_definition.hpp")) << kind;
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

TEST(SolverBuilds, OfProblemsTellThoseOfTheMetricsApart) {
  EXPECT_TRUE(any_in(files_behind("metric_problems"), "verification/fits/harmonic_fit.cpp"));
  EXPECT_FALSE(any_in(files_behind("problems"), "verification/fits/harmonic_fit.cpp"));
  EXPECT_TRUE(any_in(files_behind("problems"), "sph/"));
}

}  // namespace
}  // namespace slosh::solver_builds_test
