// The subcommand list: lists the campaigns, the cases with their runs, and the problems, as text or
// as JSON.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "verification/campaign/run_selection.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/gate/gate.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct ListOptions {
  RunSelection selection;
  bool as_json = false;
};

struct ListedCase {
  CaseDefinition definition;
  std::vector<RunDefinition> runs;  // the selected ones
};

struct Listed {
  std::vector<CampaignDefinition> campaigns;
  std::vector<ListedCase> cases;
  std::vector<Problem> problems;
};

std::vector<fs::path> definitions_in(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// Throws CaseFileError for a pattern or a tag that matches nothing.
Listed selected(const RunSelection& selection, const Installation& installation) {
  std::vector<CaseDefinition> cases;
  for (const fs::path& file : definitions_in(installation.cases)) cases.push_back(read_case(file));
  std::vector<std::string> others;
  Listed listed;
  for (const fs::path& file : definitions_in(installation.campaigns)) {
    CampaignDefinition campaign = read_campaign(file, installation.cases, known_problems());
    others.push_back(campaign.name);
    if (names_problem(selection, campaign.name)) listed.campaigns.push_back(std::move(campaign));
  }
  for (const Problem& problem : all_problems()) {
    others.push_back(problem.name);
    if (names_problem(selection, problem.name)) listed.problems.push_back(problem);
  }
  require_matches(selection, {cases, others});
  for (CaseDefinition& definition : cases) {
    std::vector<RunDefinition> runs;
    std::copy_if(definition.runs.begin(), definition.runs.end(), std::back_inserter(runs),
                 [&](const RunDefinition& run) { return names_run(selection, definition, run); });
    if (!runs.empty()) listed.cases.push_back({std::move(definition), std::move(runs)});
  }
  return listed;
}

void print_text(const Listed& listed) {
  const auto print = [](const auto& named) {
    std::cout << fmt::format("  {:<36} {}", named.name, named.title);
  };
  if (!listed.campaigns.empty()) std::cout << "campaigns:\n";
  for (const CampaignDefinition& campaign : listed.campaigns) {
    print(campaign);
    std::cout << "\n";
  }
  if (!listed.cases.empty()) std::cout << "cases:\n";
  for (const auto& [definition, runs] : listed.cases) {
    print(definition);
    if (!definition.tags.empty())
      std::cout << fmt::format(" [{}]", fmt::join(definition.tags, ", "));
    std::cout << "\n";
    for (const RunDefinition& run : runs) std::cout << "      " << run.name << "\n";
  }
  if (!listed.problems.empty()) std::cout << "problems:\n";
  for (const Problem& problem : listed.problems) {
    print(problem);
    std::cout << "\n";
  }
}

void print_json(const Listed& listed) {
  ordered_json document{{"campaigns", ordered_json::array()},
                        {"cases", ordered_json::array()},
                        {"problems", ordered_json::array()}};
  for (const CampaignDefinition& one : listed.campaigns)
    document["campaigns"].push_back({{"name", one.name}, {"title", one.title}});
  for (const auto& [definition, selected_runs] : listed.cases) {
    ordered_json runs = ordered_json::array();
    for (const RunDefinition& run : selected_runs)
      runs.push_back({{"name", run.name}, {"solver", solver_name(run)}, {"quick", run.quick}});
    document["cases"].push_back({{"name", definition.name},
                                 {"title", definition.title},
                                 {"tags", definition.tags},
                                 {"runs", runs}});
  }
  for (const Problem& one : listed.problems)
    document["problems"].push_back({{"name", one.name}, {"title", one.title}});
  std::cout << document.dump(2) << "\n";
}

int list(const ListOptions& options, const Installation& installation) {
  const Listed listed = selected(options.selection, installation);
  (options.as_json ? print_json : print_text)(listed);
  return exit_pass;
}

}  // namespace

void add_list_command(const CommandTree& tree) {
  const auto [command, options] = add_command_with<ListOptions>(
      tree,
      {"list",
       "Lists campaigns, cases and their runs, and problems",
       {"./slosh list", "./slosh list 'li2010_*/recommended_*' rigid_rotation",
        "./slosh list --tag small_amplitude --json"}},
      list);
  add_option(command, "pattern", options.selection.only, pattern_type,
             "Only names, or runs as CASE/RUN, that one of these patterns matches");
  add_option(command, "--tag", options.selection.tags, tag_type,
             "Only cases with this tag; may be given again")
      ->allow_extra_args(false);
  command.add_flag("--json", options.as_json, "As JSON");
}

}  // namespace slosh
