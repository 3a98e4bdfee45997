#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/groups/row_group.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/input/case_file_error.hpp"

namespace slosh {
namespace {

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name);
  return names;
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
  ProblemGateRow gate_row{};
  gate_row.measure = row.choice("measure", fmt::format("a measure of {}", problem.name),
                                names_of(problem.measures));
  gate_row.metric = row.choice("metric", "a metric", problem_metric_names);
  const std::string unit =
      is_order(gate_row.metric) ? "1" : named(problem.measures, gate_row.measure).unit;
  if (row.has("unit"))
    row.choice("unit", fmt::format("the unit of {}", metric_name(gate_row.metric)), {unit});
  gate_row.unit = unit;
  read_bounds(row, gate_row);
  gate_row.kind = read_row_kind(row);
  gate_row.reason = row.get("reason", any_text());
  gate_row.source = read_row_source(row, gate_row.kind);
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

}  // namespace

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

}  // namespace slosh
