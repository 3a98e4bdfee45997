#include "verification/case_file/campaign_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/input_files.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/input/toml_reader.hpp"

namespace slosh {

using namespace key;
using namespace needed;

namespace {

namespace fs = std::filesystem;

constexpr int campaign_schema_version = 1;

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

bool is_over(const TomlTable& sweep, const CaseDefinition& definition) {
  const std::vector<PlacedText> cases = sweep.texts("cases", any_text());
  return std::any_of(cases.begin(), cases.end(), [&](const PlacedText& one) {
    return matches_pattern(one.text, definition.name);
  });
}

void add_run(const TomlTable& run, const TomlTable& sweep, CaseDefinition& definition) {
  for (const RunDefinition& read : read_runs(run, definition)) {
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
      definition.gate.push_back(gate_keys(row.with("candidate", run.written("name")), definition));
  }
}

// The name must be known.
template <class Named>
const Named& named(const std::vector<Named>& all, const std::string& name) {
  return *std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
}

bool is_order(ProblemMetric metric) {
  return metric == ProblemMetric::order_at_least || metric == ProblemMetric::order_within;
}

constexpr double widest_order_range = 2;

// An order has no upper bound. An error without unit is relative to the exact solution.
Rule<double> limit_rule(const ProblemGateRow& row) {
  if (is_order(row.metric)) return positive(row.unit);
  const double widest = row.unit == "1" ? 1 : 1e9;
  return {fmt::format("a number > 0 and below {:g}, {}: a wider limit holds any error", widest,
                      in(row.unit)),
          [widest](double value) { return value > 0 && value < widest; }};
}

void read_bounds(const TomlTable& row, ProblemGateRow& gate_row) {
  const bool within = gate_row.metric == ProblemMetric::order_within;
  for (const char* key : {"limit", "lower", "upper"})
    if (row.has(key) != (within != (std::string(key) == "limit")))
      row.refuse(key, within ? "lower and upper, and no limit, with order_within"
                             : "limit alone, neither lower nor upper");
  if (!within) {
    // The limit must be > 0, so that a method that does not converge fails.
    gate_row.limit = row.get("limit", limit_rule(gate_row));
    return;
  }
  const double lower = row.get("lower", any_number(gate_row.unit));
  const double widest = lower + widest_order_range;
  const Rule<double> above_lower{
      fmt::format("a number above lower ({}) and below {:.4g}: a wider range holds any order",
                  lower, widest),
      [lower, widest](double value) { return value > lower && value < widest; }};
  gate_row.between = {lower, row.get("upper", above_lower)};
}

ProblemGateRow read_row(const TomlTable& row, const KnownProblem& problem) {
  ProblemGateRow gate_row = problem_gate_keys(row, {});
  if (gate_row.source.empty()) gate_row.source = measured_before;
  gate_row.measure = row.choice("measure", fmt::format("a measure of {}", problem.name),
                                names_of(problem.measures));
  const std::string unit =
      is_order(gate_row.metric) ? "1" : named(problem.measures, gate_row.measure).unit;
  if (row.has("unit"))
    row.choice("unit", fmt::format("the unit of {}", metric_name(gate_row.metric)), {unit});
  gate_row.unit = unit;
  read_bounds(row, gate_row);
  gate_row.where = row.where();
  return gate_row;
}

// Refuses a second bound on the same metric of the same measure.
void add_row(const TomlTable& table, const KnownProblem& known, ProblemDefinition& problem) {
  ProblemGateRow row = read_row(table, known);
  for (const ProblemGateRow& other : problem.gate)
    if (other.measure == row.measure && other.metric == row.metric)
      table.refuse_table(
          fmt::format("a second bound on {} of {}", metric_name(row.metric), row.measure),
          fmt::format("each metric of a measure once; the first is on line {}", other.where.line));
  problem.gate.push_back(std::move(row));
}

// Refuses a problem that is one of `others`, and one without a gate row, which could not fail.
ProblemDefinition read_problem(const TomlTable& table, const std::vector<KnownProblem>& known,
                               const std::vector<ProblemDefinition>& others) {
  table.allow_only(keys_of("problem"));
  ProblemDefinition problem;
  problem.name = table.choice("name", "a problem", names_of(known));
  for (const ProblemDefinition& other : others)
    if (other.name == problem.name) table.refuse("name", "each problem once");
  Complaints complaints;
  const KnownProblem& itself = named(known, problem.name);
  const RowSubjects measures{.key = "measure",
                             .key_of_several = "measures",
                             .what = "a measure of " + problem.name,
                             .names = names_of(itself.measures),
                             .metrics = all_names(problem_metric_names),
                             .table = "problem.gate"};
  for (const TomlTable& group : table.tables("gate"))
    complaints.allow([&] {
      for (const TomlTable& row : rows_of_group(group, measures))
        complaints.allow(
            [&] { row.read_all([&](const TomlTable& read) { add_row(read, itself, problem); }); });
    });
  complaints.tell();
  if (problem.gate.empty()) table.refuse("gate", "at least one gate row, [[problem.gate]]");
  return problem;
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

const FieldTable<CampaignDefinition> campaign_keys{
    {"campaign", "Top level of a campaign file", "yes",
     "A campaign names what is run, gated and reported together: at least one case or problem."},
    {{{"schema_version", constant("1"), yes, "The version of this format."}},
     field("name", &CampaignDefinition::name, name(), yes, "The name of the campaign."),
     field("title", &CampaignDefinition::title, text(), yes, "The title in reports."),
     field("source", &CampaignDefinition::source, text(), yes, "Where the campaign comes from."),
     field("paper", &CampaignDefinition::paper, one_of({"li2010", "zhao2021"}, "a paper"), no,
           "The paper whose figures and claims the report shows beside its own."),
     {{"cases", list("list of texts"), where("where no problem is named"),
       "Names of shipped cases, or paths relative to the campaign file: a path has a / or ends in "
       ".toml."}},
     {{"problem", table("[[problem]]"), no}},
     {{"sweep", table("[[sweep]]"), no}},
     {{"timing", table("[timing]"), no}}}};

const FieldTable<ProblemGateRow> problem_gate_keys{
    {"problem.gate", "[[problem.gate]]", "one or more",
     "One requirement on one measure of the problem, or with measures and limits several, as in "
     "[[gate]]: each metric of a measure once."},
    with_origin<ProblemGateRow>(
        {{{"measure", text(), where("where measures is absent"), "One of the problem's measures."}},
         {{"measures", list("list of measures or patterns"), no,
           "In place of measure: measures, or patterns such as slope_*, each of which must match "
           "one."}},
         field("metric", &ProblemGateRow::metric, problem_metric_names, "a metric",
               where("where limits is absent").when(yes.in)),
         {{"limits", KeyValue{KeyKind::limits, "table of metrics"}, no,
           "In place of metric and its bound, as in [[gate]]: limits.order_at_least = 1.9."}},
         {{"unit", text(), no,
           "1 of an order, else the measure's unit. Default: the unit that it must be."}},
         {{"limit", number().above(0), where("yes, but refused with order_within"),
           "The bound. On an error it is below 1 where the error has no unit, and below 1e9 "
           "elsewhere."}},
         {{"lower", number(), beside("order_within")}},
         {{"upper", number().above(Bound("lower")).below(Bound("lower + 2")),
           beside("order_within")}}})};

const FieldTable<TimingDefinition> timing_keys{
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
  complaints.allow([&] {
    root.read_all([&](const TomlTable& head) { campaign_keys.read_into(head, {}, campaign); });
  });
  std::vector<TomlTable> problems;
  complaints.allow([&] { problems = root.tables("problem"); });
  for (const TomlTable& table : problems)
    complaints.allow([&] {
      campaign.problems.push_back(read_problem(table, known_problems, campaign.problems));
    });
  if (root.has("timing"))
    complaints.allow([&] {
      root.table("timing").read_all(
          [&](const TomlTable& timing) { campaign.timing = timing_keys(timing, {}); });
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

void add_swept_runs(const CampaignDefinition& campaign, CaseDefinition& definition) {
  const TomlTable root(campaign.text, campaign.file);
  for (const TomlTable& sweep : root.tables("sweep")) {
    if (!is_over(sweep, definition)) continue;
    for (const TomlTable& run : runs_of_group(sweep.without({"cases", "gate"})))
      add_run(run, sweep, definition);
  }
}

void require_swept_cases(const CampaignDefinition& campaign,
                         const std::vector<CaseDefinition>& cases) {
  const std::vector<std::string> names = names_of(cases);
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
