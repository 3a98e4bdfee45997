#include "verification/cli/limit_option.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <vector>

#include "verification/case/metric_table.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/nearest_name.hpp"

namespace slosh {
namespace {

// The three parts of "natural_1:frequency_error=0.01". The mode may be absent.
struct LimitText {
  std::string whole;
  std::optional<std::string> mode;
  std::string metric, value;
};

LimitText parts_of(const std::string& limit) {
  const std::size_t equals = std::min(limit.find('='), limit.size());
  const std::size_t colon = limit.find(':');
  const bool has_mode = colon < equals;
  const std::size_t begin = has_mode ? colon + 1 : 0;
  return {.whole = limit,
          .mode = has_mode ? std::optional(limit.substr(0, colon)) : std::nullopt,
          .metric = limit.substr(begin, equals - begin),
          .value = equals < limit.size() ? limit.substr(equals + 1) : ""};
}

[[noreturn]] void refuse(const LimitText& limit, const std::string& key,
                         const std::optional<std::string>& value, const std::string& expected) {
  throw CaseFileError(fmt::format("--limit {}: {} {}: expected {}", limit.whole, key,
                                  value ? "= " + *value : "is missing", expected));
}

const MetricEntry& metric_of(const LimitText& limit) {
  std::vector<std::string> names;
  for (const MetricEntry& entry : metric_table())
    if (is_of_a_pair(entry)) names.push_back(entry.name);
  if (std::find(names.begin(), names.end(), limit.metric) != names.end())
    return metric_entry(limit.metric);
  throw CaseFileError(fmt::format(
      "--limit {}: expected METRIC=VALUE or MODE:METRIC=VALUE with {}{}", limit.whole,
      one_of_text("a metric of two results", names), nearest_text(limit.metric, names)));
}

std::string where_modes_are_named(const MetricEntry& metric) {
  if (metric.measured_on == MeasuredOn::any_mode) return "; --case or --frequency names the modes";
  return metric.measured_on == MeasuredOn::natural_mode ? "; --case names the natural modes" : "";
}

// The metric's default mode where the limit names none.
std::string mode_of(const LimitText& limit, const MetricEntry& metric,
                    const Comparison& comparison) {
  std::vector<std::string> fitted;
  for (const ModeComparison& mode : comparison.modes) fitted.push_back(mode.mode);
  const std::vector<std::string> known = measured_modes(metric, fitted, fitted.empty());
  const auto is_known = [&](const std::string& mode) {
    return std::find(known.begin(), known.end(), mode) != known.end();
  };
  if (limit.mode && is_known(*limit.mode)) return *limit.mode;
  const std::optional<std::string> usual = default_mode(metric);
  if (!limit.mode && usual && is_known(*usual)) return *usual;
  const std::string expected = one_of_text(measured_on_text(metric), known);
  if (known.empty()) refuse(limit, "mode", limit.mode, expected + where_modes_are_named(metric));
  refuse(limit, "mode", limit.mode,
         expected + (limit.mode ? nearest_text(*limit.mode, known) : ""));
}

double value_of(const LimitText& limit, const Rule<double>& rule) {
  double value = 0;
  std::istringstream stream(limit.value);
  if (!(stream >> value) || !stream.eof() || !rule.holds(value))
    refuse(limit, "limit", limit.value, rule.expected);
  return value;
}

GateRow row_of(const LimitText& limit, const Comparison& comparison) {
  const MetricEntry& metric = metric_of(limit);
  GateRow row{};
  row.candidate = comparison.candidate;
  row.reference = comparison.reference;
  row.quantity = comparison.quantity;
  row.mode = mode_of(limit, metric, comparison);
  row.metric = metric.metric;
  row.unit = metric_unit(metric.metric, comparison.unit);
  const double window = comparison.window.end - comparison.window.begin;
  row.limit = value_of(limit, limit_rule(metric, row.unit, {.window = window}));
  return row;
}

GateOutcome judged(const GateRow& row, const Comparison& comparison,
                   const std::vector<std::string>& doubts_of_runs) {
  const std::map<std::string, RunStatus> runs{{comparison.candidate, {RunState::finished, ""}},
                                              {comparison.reference, {RunState::finished, ""}}};
  const FindComparison find = [&](const std::string&, const std::string&,
                                  const std::string&) -> const Comparison& { return comparison; };
  GateEvidence evidence{find, {}};
  if (!doubts_of_runs.empty())
    evidence.doubts_of_runs = [&](const GateRow&) {
      return RowDoubts{.text = fmt::format("; doubtful: {}", fmt::join(doubts_of_runs, "; ")),
                       .keep_from_passing = true,
                       .is_doubtful = true};
    };
  GateOutcome outcome = evaluate(row, runs, evidence);
  outcome.message += "; the uncertainties of both results are not counted";
  return outcome;
}

}  // namespace

std::vector<GateOutcome> judged_by_limits(const std::vector<std::string>& limits,
                                          const Comparison& comparison,
                                          const std::vector<std::string>& doubts_of_runs) {
  std::vector<GateOutcome> outcomes;
  for (const std::string& text : limits) {
    const LimitText limit = parts_of(text);
    const GateRow row = row_of(limit, comparison);
    for (const GateOutcome& other : outcomes)
      if (other.row.metric == row.metric && other.row.mode == row.mode)
        refuse(limit, "metric", limit.metric, "each metric of a mode once");
    outcomes.push_back(judged(row, comparison, doubts_of_runs));
  }
  return outcomes;
}

}  // namespace slosh
