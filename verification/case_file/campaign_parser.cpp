#include "verification/case_file/campaign_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/definition_file.hpp"
#include "verification/input/input_files.hpp"
#include "verification/input/toml_reader.hpp"

namespace slosh {
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
        "below the directory above it",
        place, member.text));
  for (const fs::path& other : campaign.cases) {
    if (!fs::equivalent(other, file)) continue;
    throw CaseFileError(
        fmt::format("{}case = \"{}\": expected each case once", place, member.text));
  }
  return file;
}

TimingDefinition read_timing(const TomlTable& timing) {
  timing.allow_only(keys_of("timing"));
  TimingDefinition read;
  read.repeats = timing.get("repeats", at_least(1));
  read.longest_run = timing.find("longest_run_s", positive("s")).value_or(read.longest_run);
  if (timing.has("only"))
    for (const PlacedText& one : timing.texts("only", any_text())) read.only.push_back(one.text);
  return read;
}

void read_head(const TomlTable& head, CampaignDefinition& campaign) {
  head.allow_only(keys_of("campaign"));
  campaign.name = head.get("name", file_safe_name());
  campaign.title = head.get("title", any_text());
  campaign.source = head.get("source", any_text());
  campaign.paper = head.find("paper", known_paper()).value_or("");
}

const CaseDefinition& read_case_of_basket(const TomlTable& measure,
                                          const std::vector<CaseDefinition>& cases) {
  std::vector<std::string> names;
  for (const CaseDefinition& one : cases) names.push_back(one.name);
  const std::string name = measure.choice("case", "a case of the campaign", names);
  return *std::find_if(cases.begin(), cases.end(),
                       [&](const CaseDefinition& one) { return one.name == name; });
}

// A measure that stands twice would count twice in every mean.
void refuse_second_measure(const TomlTable& table, const BasketMeasure& measure,
                           const std::vector<BasketMeasure>& others) {
  const auto subject = [](const BasketMeasure& of) {
    return std::tie(of.case_name, of.run_suffix, of.row.reference, of.row.quantity, of.row.mode,
                    of.row.metric);
  };
  for (const BasketMeasure& other : others)
    if (subject(other) == subject(measure))
      table.refuse_table(
          fmt::format("{} of {} a second time", metric_name(measure.row.metric), measure.case_name),
          fmt::format("each measure once; the first is on line {}", other.row.where.line));
}

BasketMeasure read_measure(const TomlTable& table, const std::vector<CaseDefinition>& cases) {
  table.allow_only(keys_of("basket"));
  const CaseDefinition& definition = read_case_of_basket(table, cases);
  return {definition.name, table.find("title", any_text()).value_or(definition.name),
          read_basket_row(table, definition), table.find("run_suffix", any_text()).value_or("")};
}

bool is_of_one_case(const std::vector<BasketMeasure>& basket) {
  return std::all_of(basket.begin(), basket.end(), [&](const BasketMeasure& one) {
    return one.case_name == basket.front().case_name;
  });
}

}  // namespace

CampaignDefinition read_campaign(const fs::path& file, const fs::path& case_directory,
                                 const std::vector<KnownProblem>& known_problems) {
  CampaignDefinition campaign;
  campaign.file = file;
  campaign.text = read_definition_text("campaign", file);
  const TomlTable root(campaign.text, file);
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
          [&](const TomlTable& timing) { campaign.timing = read_timing(timing); });
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

std::vector<BasketMeasure> read_basket(const CampaignDefinition& campaign,
                                       const std::vector<CaseDefinition>& cases) {
  const TomlTable root(campaign.text, campaign.file);
  const std::vector<TomlTable> tables = root.tables("basket");
  std::vector<BasketMeasure> basket;
  Complaints complaints;
  for (const TomlTable& table : tables)
    complaints.allow([&] {
      table.read_all([&](const TomlTable& read) {
        BasketMeasure measure = read_measure(read, cases);
        refuse_second_measure(read, measure, basket);
        basket.push_back(std::move(measure));
      });
    });
  complaints.tell();
  if (!basket.empty() && is_of_one_case(basket))
    tables.back().refuse("case", "measures of two cases or more in a basket");
  return basket;
}

fs::path find_campaign(const std::string& name_or_path, const fs::path& directory) {
  return find_definition_file("campaign", name_or_path, directory, "");
}

}  // namespace slosh
