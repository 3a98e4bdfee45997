#include "verification/case_file/campaign_parser.hpp"

#include <fmt/format.h>

#include "verification/case_file/case_sections.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/input_files.hpp"
#include "verification/input/toml_reader.hpp"

namespace slosh {

using namespace key;
using namespace needed;

namespace {

namespace fs = std::filesystem;

constexpr int campaign_schema_version = 1;

Rule<std::string> known_paper() {
  return {"one of li2010 | zhao2021",
          [](const std::string& paper) { return paper == "li2010" || paper == "zhao2021"; },
          "li2010"};
}

// The messages begin with the member's place in the campaign file.
fs::path find_member(const PlacedText& member, const CampaignDefinition& campaign,
                     const fs::path& case_directory) {
  const std::string place = fmt::format("{}:{}: ", member.where.file, member.where.line);
  fs::path file;
  try {
    file = find_definition_file("case", member.text, case_directory, campaign.file.parent_path());
  } catch (const CaseFileError& error) {
    throw CaseFileError(place + error.what());
  }
  if (file.parent_path() != case_directory && !is_data_of(campaign.file, file))
    throw CaseFileError(fmt::format(
        "{}case = \"{}\": expected a case file in the repository of the campaign file, or "
        "without one below its directory or a current one that holds it",
        place, member.text));
  for (const fs::path& other : campaign.cases) {
    if (!fs::equivalent(other, file)) continue;
    throw CaseFileError(
        fmt::format("{}case = \"{}\": expected each case once", place, member.text));
  }
  return file;
}

void read_head(const TomlTable& head, CampaignDefinition& campaign) {
  head.allow_only(keys_of("campaign"));
  campaign.name = head.get("name", file_safe_name());
  campaign.title = head.get("title", any_text());
  campaign.source = head.get("source", any_text());
  campaign.paper = head.find("paper", known_paper()).value_or("");
}

// A case that stands for a campaign of its own.
CampaignDefinition campaign_of_case(const TomlTable& root, CampaignDefinition campaign) {
  campaign.name = root.get("name", file_safe_name());
  campaign.title = root.get("title", any_text());
  campaign.source = root.get("source", any_text());
  campaign.cases = {campaign.file};
  return campaign;
}

}  // namespace

const FieldTable<TimingDefinition> timing_table{
    {"timing", "[timing]", "no",
     "Repeats of the runs, each alone on the machine after all other runs."},
    {field("repeats", &TimingDefinition::repeats, integer().at_least(1), yes,
           "The number of repeats of each run."),
     field("longest_run_s", &TimingDefinition::longest_run, number("s").above(0), no,
           "Runs that took more processor time than this are not repeated. Default: 60."),
     field("only", &TimingDefinition::only, list("list of texts"), no,
           "Patterns CASE or CASE/RUN of what is repeated. Default: all.")}};

CampaignDefinition read_campaign(const fs::path& file, const fs::path& case_directory,
                                 const std::vector<KnownProblem>& known_problems) {
  CampaignDefinition campaign;
  campaign.file = file;
  campaign.text = read_definition_text("campaign", file);
  const TomlTable root(campaign.text, file);
  if (root.has("tank")) return campaign_of_case(root, campaign);
  root.get("schema_version", exactly(campaign_schema_version));  // another version has other rules
  Complaints complaints;
  complaints.allow(
      [&] { root.read_all([&](const TomlTable& head) { read_head(head, campaign); }); });
  std::vector<TomlTable> problems;
  complaints.allow([&] { problems = root.tables("problem"); });
  for (const TomlTable& table : problems)
    complaints.allow([&] {
      campaign.problems.push_back(read_problem(table, known_problems, campaign.problems));
    });
  if (root.has("timing"))
    complaints.allow([&] {
      root.table("timing").read_all(
          [&](const TomlTable& timing) { campaign.timing = timing_table.read_all(timing, {}); });
    });
  if (root.has("cases") || !root.has("problem")) {
    std::vector<PlacedText> members;
    complaints.allow([&] {
      members = root.texts("cases", any_text());
      if (members.empty()) root.refuse("cases", "at least one case");
    });
    for (const PlacedText& member : members)
      complaints.allow(
          [&] { campaign.cases.push_back(find_member(member, campaign, case_directory)); });
  }
  complaints.tell();
  return campaign;
}

fs::path find_campaign(const std::string& name_or_path, const fs::path& directory) {
  return find_definition_file("campaign", name_or_path, directory, "");
}

}  // namespace slosh
