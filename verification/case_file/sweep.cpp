#include "verification/case_file/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/groups/run_group.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/input/toml_reader.hpp"

namespace slosh {
namespace {

bool is_over(const TomlTable& sweep, const CaseDefinition& definition) {
  const std::vector<PlacedText> cases = sweep.texts("cases", any_text());
  return std::any_of(cases.begin(), cases.end(), [&](const PlacedText& one) {
    return matches_pattern(one.text, definition.name);
  });
}

void add_run(const TomlTable& run, const TomlTable& sweep, const std::filesystem::path& experiments,
             CaseDefinition& definition) {
  for (const RunDefinition& read : read_runs(run, definition, experiments)) {
    for (const RunDefinition& other : definition.runs)
      if (other.name == read.name)
        sweep.refuse("name", fmt::format("a pattern that names each run apart: {} has a run {}",
                                         definition.name, read.name));
    definition.runs.push_back(read);
  }
  for (const TomlTable& group : sweep.tables("gate")) {
    for (const char* key : {"candidate", "candidates"})
      if (group.has(key))
        group.refuse(key, "no such key in [[sweep.gate]]: its rows are of each run of the sweep");
    for (const TomlTable& row : gate_rows(group, definition))
      definition.gate.push_back(
          read_gate_row(row.with("candidate", run.written("name")), definition));
  }
}

}  // namespace

void add_swept_runs(const CampaignDefinition& campaign, const std::filesystem::path& experiments,
                    CaseDefinition& definition) {
  const TomlTable root(campaign.text, campaign.file);
  for (const TomlTable& sweep : root.tables("sweep")) {
    if (!is_over(sweep, definition)) continue;
    for (const TomlTable& run : runs_of_group(sweep.without({"cases", "gate"})))
      add_run(run, sweep, experiments, definition);
  }
}

void require_swept_cases(const CampaignDefinition& campaign,
                         const std::vector<CaseDefinition>& cases) {
  std::vector<std::string> names;
  for (const CaseDefinition& one : cases) names.push_back(one.name);
  const Rule<std::string> known{
      one_of_text("a case of the campaign or a pattern of them", names),
      [&](const std::string& pattern) {
        return std::any_of(names.begin(), names.end(),
                           [&](const std::string& name) { return matches_pattern(pattern, name); });
      }};
  const TomlTable root(campaign.text, campaign.file);
  for (const TomlTable& sweep : root.tables("sweep"))
    if (sweep.texts("cases", known).empty()) sweep.refuse("cases", known.expected);
}

}  // namespace slosh
