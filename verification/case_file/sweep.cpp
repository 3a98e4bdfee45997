#include "verification/case_file/sweep.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>

#include "verification/case_file/case_sections.hpp"
#include "verification/input/toml_reader.hpp"

namespace slosh {
namespace {

bool is_over(const TomlTable& sweep, const CaseDefinition& definition) {
  const std::vector<PlacedText> cases = sweep.texts("cases", any_text());
  return std::any_of(cases.begin(), cases.end(), [&](const PlacedText& one) {
    return fnmatch(one.text.c_str(), definition.name.c_str(), 0) == 0;
  });
}

// "{scheme}_{particle_spacing_m}" -> "recommended_0p025"
std::string run_name(const TomlTable& run) {
  const std::string pattern = run.get("name", any_text());
  std::string name;
  for (std::size_t at = 0; at < pattern.size();) {
    const std::size_t end = pattern.find('}', at);
    if (pattern[at] != '{' || end == std::string::npos) {
      name += pattern[at++];
      continue;
    }
    const std::string key = pattern.substr(at + 1, end - at - 1);
    if (key == "name" || !run.has(key))
      run.refuse("name", fmt::format("a pattern of this table's keys; there is no {}", key));
    std::string value = run.written(key);
    std::replace(value.begin(), value.end(), '.', 'p');
    name += value;
    at = end + 1;
  }
  return name;
}

void add_run(const TomlTable& run, const TomlTable& sweep, const std::filesystem::path& experiments,
             CaseDefinition& definition) {
  const std::string name = run_name(run);
  for (const RunDefinition& read : read_runs(run.with("name", name), definition, experiments)) {
    for (const RunDefinition& other : definition.runs)
      if (other.name == read.name)
        sweep.refuse("name", fmt::format("a pattern that names each run apart: {} has a run {}",
                                         definition.name, read.name));
    definition.runs.push_back(read);
  }
  for (const TomlTable& group : sweep.tables("gate"))
    for (const TomlTable& row : gate_rows(group, definition))
      definition.gate.push_back(read_gate_row(row.with("candidate", name), definition));
}

}  // namespace

void add_swept_runs(const CampaignDefinition& campaign, const std::filesystem::path& experiments,
                    CaseDefinition& definition) {
  const TomlTable root(campaign.text, campaign.file);
  for (const TomlTable& sweep : root.tables("sweep")) {
    if (!is_over(sweep, definition)) continue;
    for (const TomlTable& run : sweep.without({"cases", "gate"}).combinations())
      add_run(run, sweep, experiments, definition);
  }
}

void require_swept_cases(const CampaignDefinition& campaign,
                         const std::vector<CaseDefinition>& cases) {
  const TomlTable root(campaign.text, campaign.file);
  for (const TomlTable& sweep : root.tables("sweep"))
    if (std::none_of(cases.begin(), cases.end(),
                     [&](const CaseDefinition& one) { return is_over(sweep, one); }))
      sweep.refuse("cases", "names or globs of the campaign's cases, of which these match none");
}

}  // namespace slosh
