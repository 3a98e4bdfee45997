#include "verification/baseline/baseline_figures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "verification/baseline/baseline_diff.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;

constexpr std::size_t most_rows = 6;        // the number of colours in a figure
constexpr std::size_t most_approvals = 12;  // the latest
constexpr std::size_t most_labels = 6;      // dates that fit side by side

// The baseline after an approval; approvals are numbered from one.
struct ApprovedState {
  std::size_t number;
  const Approval* approval;
  Baseline baseline;
};

std::vector<ApprovedState> approved_states(const std::vector<Approval>& approvals) {
  std::vector<ApprovedState> found;
  const std::size_t first = approvals.size() - std::min(approvals.size(), most_approvals);
  for (std::size_t i = first; i < approvals.size(); ++i)
    found.push_back(
        {i + 1, &approvals[i],
         baseline_of({approvals.begin(), approvals.begin() + static_cast<long>(i) + 1})});
  return found;
}

// The value's place in its tolerance: 0 in the middle, 1 and -1 at the ends. Returns nullopt for a
// tolerance without two ends.
std::optional<Estimate> in_tolerance(const BaselineValue& one) {
  if (!one.lower || !one.upper) return std::nullopt;
  const double half = (*one.upper - *one.lower) / 2;
  if (!(half > 0) || !std::isfinite(half)) return std::nullopt;
  return Estimate{(one.value - *one.lower) / half - 1, one.half_width / half};
}

// The rows of the case that are closest to their tolerance or furthest beyond it, worst first.
std::vector<const RowMovement*> worst_rows(const std::vector<RowMovement>& moved,
                                           const std::string& case_name) {
  std::vector<const RowMovement*> rows;
  for (const RowMovement& one : moved)
    if (one.row.starts_with(case_name + ": ") && one.after && in_tolerance(*one.after))
      rows.push_back(&one);
  std::stable_sort(rows.begin(), rows.end(), [](const RowMovement* a, const RowMovement* b) {
    return std::abs(in_tolerance(*a->after)->value) > std::abs(in_tolerance(*b->after)->value);
  });
  rows.resize(std::min(rows.size(), most_rows));
  return rows;
}

void add_point(double place, const std::optional<BaselineValue>& value, Curve& curve) {
  const std::optional<Estimate> at = value ? in_tolerance(*value) : std::nullopt;
  curve.x.push_back(place);
  curve.y.push_back(at ? at->value : not_a_number);
  curve.y_error.push_back(at ? at->half_width : 0);
}

Curve history_of(const RowMovement& row, const std::string& label,
                 const std::vector<ApprovedState>& past) {
  Curve curve{label, {}, {}, {}, Curve::Style::line_points};
  for (const ApprovedState& one : past) {
    const auto found = one.baseline.find(row.row);
    add_point(static_cast<double>(one.number),
              found == one.baseline.end() ? std::nullopt : std::optional(found->second), curve);
  }
  add_point(static_cast<double>(past.back().number) + 1, row.after, curve);
  return curve;
}

std::vector<std::pair<double, std::string>> ticks_of(const std::vector<ApprovedState>& past) {
  std::vector<std::pair<double, std::string>> ticks;
  const std::size_t every = (past.size() + most_labels - 1) / most_labels;
  for (std::size_t i = 0; i < past.size(); i += every)
    ticks.emplace_back(past[i].number, fmt::format("{}: {}", past[i].number,
                                                   past[i].approval->when_utc.substr(0, 10)));
  ticks.emplace_back(past.back().number + 1, "now");
  return ticks;
}

std::string approvals_text(const std::vector<ApprovedState>& past) {
  std::vector<std::string> texts;
  for (const ApprovedState& one : past)
    texts.push_back(fmt::format("{}: {}, {}", one.number, one.approval->who, one.approval->reason));
  return fmt::format("{}.", fmt::join(texts, "; "));
}

Figure figure_of(const std::string& case_name, const std::vector<const RowMovement*>& rows,
                 const std::vector<ApprovedState>& past) {
  Figure figure;
  figure.id = case_name + "-baselines";
  figure.title = "Gate rows over their baselines";
  figure.caption = fmt::format(
      "The {} rows that are now closest to their tolerance or furthest beyond it: each value with "
      "its 95 % interval at the campaign's approvals and now, divided by half the width of its "
      "tolerance at that time. Baselines are this project's own earlier results: they show what "
      "has moved, not what is right. Approvals: {}",
      rows.size(), approvals_text(past));
  figure.x_label = "approval";
  figure.y_label = "place in the tolerance [1]";
  figure.bands = {{"tolerance", -1, 1}};
  figure.x_ticks = ticks_of(past);
  for (const RowMovement* row : rows)
    figure.curves.push_back(history_of(*row, row->row.substr(case_name.size() + 2), past));
  return figure;
}

}  // namespace

void add_baseline_figures(const std::vector<Approval>& approvals,
                          const std::vector<CaseAssessment>& cases, reports::Report& report) {
  if (approvals.empty()) return;
  const std::vector<ApprovedState> past = approved_states(approvals);
  const std::vector<RowMovement> moved = movements(past.back().baseline, cases);
  for (const CaseAssessment& one : cases) {
    const std::string& name = one.definition.name;
    const std::vector<const RowMovement*> rows = worst_rows(moved, name);
    const bool known = std::any_of(rows.begin(), rows.end(), [&](const RowMovement* row) {
      return std::any_of(past.begin(), past.end(), [&](const ApprovedState& state) {
        return state.baseline.contains(row->row);
      });
    });
    const auto section =
        std::find_if(report.sections.begin(), report.sections.end(),
                     [&](const reports::Section& section) { return section.id == name; });
    if (known && section != report.sections.end())
      section->figures.push_back(figure_of(name, rows, past));
  }
}

}  // namespace slosh
