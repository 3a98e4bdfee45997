#include "verification/baseline/gate_trends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "verification/baseline/baseline_diff.hpp"

namespace slosh {
namespace {

using reports::Trend;

constexpr std::size_t most_earlier = 30;  // more are no line any more beside a row

// The values of all rows at one moment.
struct Moment {
  std::string when_utc;
  bool is_approval;
  Baseline values;
};

// The baseline after each approval, and each state, in the order of time.
std::vector<Moment> moments_of(const std::vector<Approval>& approvals,
                               const std::vector<CampaignState>& history) {
  std::vector<Moment> moments;
  for (std::size_t i = 0; i < approvals.size(); ++i)
    moments.push_back(
        {approvals[i].when_utc, true,
         baseline_of({approvals.begin(), approvals.begin() + static_cast<long>(i) + 1})});
  for (const CampaignState& state : history) {
    moments.push_back({state.when_utc, false, {}});
    for (const auto& [row, judged] : state.rows) moments.back().values[row] = judged.value;
  }
  // Dates in ISO 8601 follow one another as texts do.
  std::stable_sort(moments.begin(), moments.end(),
                   [](const Moment& a, const Moment& b) { return a.when_utc < b.when_utc; });
  return moments;
}

// The value of one row at one moment.
struct RowMoment {
  std::string when_utc;
  bool is_approved;
  BaselineValue value;
};

// Returns the row's values before the present one. An approval of the value that an earlier run of
// the campaign left is no further value, and neither is the present run's own state.
std::vector<RowMoment> earlier_values(const std::string& row, const BaselineValue& now,
                                      const std::vector<Moment>& moments) {
  std::vector<RowMoment> found;
  for (const Moment& moment : moments) {
    const auto value = moment.values.find(row);
    if (value == moment.values.end()) continue;
    if (moment.is_approval && !found.empty() && found.back().value == value->second)
      found.back().is_approved = true;
    else
      found.push_back({moment.when_utc, moment.is_approval, value->second});
  }
  if (!found.empty() && !found.back().is_approved && found.back().value == now) found.pop_back();
  return found;
}

Trend::Point point_of(const BaselineValue& value, bool is_approved) {
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  return {value.value, value.half_width, value.lower.value_or(-unbounded),
          value.upper.value_or(unbounded), is_approved};
}

// Returns the value that was approved last, or else the last one.
const RowMoment& compared_with(const std::vector<RowMoment>& earlier) {
  const auto approved = std::find_if(earlier.rbegin(), earlier.rend(),
                                     [](const RowMoment& one) { return one.is_approved; });
  return approved == earlier.rend() ? earlier.back() : *approved;
}

Trend trend_of(const std::string& case_name, const GateOutcome& outcome,
               const std::vector<Moment>& moments) {
  const std::optional<BaselineValue> now = baseline_value(outcome);
  if (!now) return {};
  const std::vector<RowMoment> earlier =
      earlier_values(row_name(case_name, outcome.row), *now, moments);
  if (earlier.empty()) return {};
  Trend trend;
  for (std::size_t i = earlier.size() - std::min(earlier.size(), most_earlier); i < earlier.size();
       ++i)
    trend.points.push_back(point_of(earlier[i].value, earlier[i].is_approved));
  trend.points.push_back(point_of(*now, false));
  const RowMoment& before = compared_with(earlier);
  const RowMovement movement = movement_of(case_name, outcome, before.value);
  trend.has_changed = movement.has_changed();
  trend.text = fmt::format("{} {}: {}", before.is_approved ? "approved" : "run on",
                           before.when_utc.substr(0, 10),
                           trend.has_changed ? movement_text(movement) : "unmoved since");
  return trend;
}

}  // namespace

void add_gate_trends(const std::vector<Approval>& approvals,
                     const std::vector<CampaignState>& history,
                     const std::vector<CaseAssessment>& cases, reports::Report& report) {
  const std::vector<Moment> moments = moments_of(approvals, history);
  for (const CaseAssessment& one : cases)
    for (reports::Section& section : report.sections)
      for (reports::Table& table : section.tables) {
        if (table.id != one.definition.name + "-gate") continue;
        std::vector<Trend> trends;
        for (const GateOutcome& outcome : one.gate)
          trends.push_back(trend_of(one.definition.name, outcome, moments));
        const bool is_known = std::any_of(trends.begin(), trends.end(),
                                          [](const Trend& trend) { return !trend.points.empty(); });
        if (is_known) table.trends = std::move(trends);
      }
}

}  // namespace slosh
