#include "verification/baseline/baseline_diff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace slosh {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

double uncertainties_between(const BaselineValue& before, const BaselineValue& after) {
  const double moved = std::abs(after.value - before.value);
  return moved == 0 ? 0 : moved / std::hypot(before.half_width, after.half_width);
}

// Relative to the larger of the metric and its tolerance. Round-off that depends on the compiler's
// order of summation is smaller, unless the flow amplifies it, which the intervals then show.
constexpr double rounding = 1e-6;

double scale_of(const BaselineValue& one) {
  double scale = std::abs(one.value);
  for (const std::optional<double>& bound : {one.lower, one.upper})
    if (bound && std::isfinite(*bound)) scale = std::max(scale, std::abs(*bound));
  return scale;
}

bool has_moved(const BaselineValue& before, const BaselineValue& after) {
  return std::abs(after.value - before.value) >
             rounding * std::max(scale_of(before), scale_of(after)) &&
         uncertainties_between(before, after) > 1;
}

std::string signed_in_unit(double value, const std::string& unit, int digits = 3) {
  return unit == "1" ? fmt::format("{:+.{}g} %", 100 * value, digits)
                     : fmt::format("{:+.{}g} {}", value, digits, unit);
}

// Both values, with as many digits as tell them apart.
std::string change_text(double before, double after, const std::string& unit) {
  constexpr int most = std::numeric_limits<double>::max_digits10;
  int digits = 3;
  while (digits < most &&
         signed_in_unit(before, unit, digits) == signed_in_unit(after, unit, digits))
    ++digits;
  return signed_in_unit(before, unit, digits) + " -> " + signed_in_unit(after, unit, digits);
}

std::string range(const BaselineValue& value, const std::string& unit) {
  return fmt::format("{} .. {}", signed_in_unit(value.lower.value_or(-unbounded), unit),
                     signed_in_unit(value.upper.value_or(unbounded), unit));
}

bool is_judged_here(const GateOutcome& outcome) {
  return outcome.verdict != Verdict::not_selected && outcome.verdict != Verdict::not_supplied;
}

// Whether the tolerance accepts more than the baseline's at either end.
bool is_loosened(const BaselineValue& before, const BaselineValue& after) {
  return after.lower.value_or(-unbounded) < before.lower.value_or(-unbounded) ||
         after.upper.value_or(unbounded) > before.upper.value_or(unbounded);
}

RowMovement movement_of(const std::string& case_name, const GateOutcome& outcome,
                        const std::optional<BaselineValue>& before) {
  RowMovement movement{.row = row_name(case_name, outcome.row),
                       .unit = outcome.row.unit,
                       .before = before,
                       .after = baseline_value(outcome)};
  if (before && movement.after) {
    movement.uncertainties = uncertainties_between(*before, *movement.after);
    movement.loosened = is_loosened(*before, *movement.after);
  }
  return movement;
}

}  // namespace

bool RowMovement::has_changed() const {
  if (!before || !after) return before.has_value() != after.has_value();
  return before->lower != after->lower || before->upper != after->upper ||
         has_moved(*before, *after);
}

std::string row_name(const std::string& case_name, const GateRow& row) {
  return case_name + ": " + row_name(row);
}

std::optional<BaselineValue> baseline_value(const GateOutcome& outcome) {
  if (!std::isfinite(outcome.value.value)) return {};
  const double half_width = outcome.value.half_width;
  BaselineValue value{outcome.value.value, std::isfinite(half_width) ? half_width : 0, {}, {}};
  if (const auto& limit = outcome.row.limit) {
    value.lower = -*limit;
    value.upper = *limit;
  }
  if (const auto& between = outcome.row.between) {
    value.lower = between->first;
    value.upper = between->second;
  }
  return value;
}

std::vector<RowMovement> movements(const Baseline& baseline,
                                   const std::vector<CaseAssessment>& cases) {
  std::vector<RowMovement> found;
  std::set<std::string> declared;
  for (const CaseAssessment& one : cases)
    for (const GateOutcome& outcome : one.gate) {
      const std::string row = row_name(one.definition.name, outcome.row);
      declared.insert(row);
      // A cost is measured on one machine and says nothing about another.
      if (!is_judged_here(outcome) || is_cost(outcome.row.metric)) continue;
      const auto known = baseline.find(row);
      found.push_back(
          movement_of(one.definition.name, outcome,
                      known == baseline.end() ? std::optional<BaselineValue>() : known->second));
    }
  for (const auto& [row, value] : baseline)
    if (!declared.contains(row))
      found.push_back({.row = row, .unit = "", .before = value, .after = {}, .declared = false});
  return found;
}

std::vector<BaselineChange> proposed_changes(const std::vector<RowMovement>& movements) {
  std::vector<BaselineChange> changes;
  for (const RowMovement& movement : movements) {
    const bool lost = !movement.after && movement.declared;
    if (movement.has_changed() && !lost)
      changes.push_back({movement.row, movement.before, movement.after});
  }
  return changes;
}

std::string movement_text(const RowMovement& movement) {
  const auto& [row, unit, before, after, uncertainties, loosened, declared] = movement;
  if (!declared) return "no row any more";
  if (!before && !after) return "no value";
  if (!after) return "no value any more";
  if (!before) return "new: " + signed_in_unit(after->value, unit);
  std::string text =
      before->value == after->value ? "unmoved"
      : std::isinf(uncertainties)
          ? change_text(before->value, after->value, unit) + " (no interval)"
          : fmt::format("{} ({:.2g} uncertainties)", change_text(before->value, after->value, unit),
                        uncertainties);
  if (loosened)
    text +=
        fmt::format(", tolerance {}: {} -> {}", is_loosened(*after, *before) ? "moved" : "loosened",
                    range(*before, unit), range(*after, unit));
  return text;
}

}  // namespace slosh
