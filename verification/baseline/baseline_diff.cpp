#include "verification/baseline/baseline_diff.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "verification/case/campaign_definition.hpp"
#include "verification/case/changed_input.hpp"
#include "verification/runs/run_key.hpp"

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
                     : fmt::format("{:+.{}g}{}{}", value, digits, unit.empty() ? "" : " ", unit);
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

// Whether one end of a tolerance lies below another, by more than rounding.
bool is_below(double one, double other) {
  if (std::isinf(one) || std::isinf(other)) return one < other;
  return other - one > rounding * std::max(std::abs(one), std::abs(other));
}

// Whether the tolerance accepts more than the baseline's at either end.
bool is_loosened(const BaselineValue& before, const BaselineValue& after) {
  return is_below(after.lower.value_or(-unbounded), before.lower.value_or(-unbounded)) ||
         is_below(before.upper.value_or(unbounded), after.upper.value_or(unbounded));
}

// What the settings of a run do not say of it (hashed_settings()).
std::string evidence_of(const RunDefinition& run) {
  return std::visit(
      [&](const auto& solver) -> std::string {
        using Run = std::decay_t<decltype(solver)>;
        if constexpr (std::is_same_v<Run, RecordRun>)
          return solver.uncertainty
                     ? fmt::format("; {} +- {:.6g} {}", run.name, *solver.uncertainty, solver.unit)
                     : "";
        else if constexpr (std::is_same_v<Run, ExternalRun>) {
          std::string inputs;
          for (const auto& one : solver.inputs) inputs += " " + one.generic_string();
          return inputs.empty() ? "" : fmt::format("; inputs of {}:{}", run.name, inputs);
        } else if constexpr (requires { solver.valid_elevation_over_depth; })
          return fmt::format("; {} up to {:.6g} depths", run.name,
                             solver.valid_elevation_over_depth);
        else
          return "";
      },
      run.solver);
}

std::string evidence_of(const CaseDefinition& definition, const GateRow& row) {
  std::string text = fmt::format("{} natural modes", definition.natural_modes);
  const std::set<std::string> names{row.candidate, row.reference, row.improves_on.value_or("")};
  for (const RefinementDefinition& one : definition.refinements)
    if (std::any_of(one.runs.begin(), one.runs.end(),
                    [&](const std::string& run) { return names.contains(run); }))
      text += fmt::format("; refinement {}: {}", one.name, fmt::join(one.runs, ", "));
  for (const RunDefinition& run : definition.runs)
    if (names.contains(run.name)) text += evidence_of(run);
  return text;
}

RowTerms terms_of(const CaseDefinition& definition, const GateRow& row) {
  const auto [begin, end] =
      row.part.value_or(std::pair(definition.window_begin, definition.window_end));
  std::string inputs;
  for (const InputUncertainty& one : definition.inputs)
    inputs += fmt::format("{}{} +- {:.6g} {}{}", inputs.empty() ? "" : ", ", input_name(one.input),
                          one.half_width, input_unit(one.input, definition.motion),
                          one.coarse_run.empty() ? "" : " by " + one.coarse_run);
  return {kind_name(row.kind), fmt::format("{:.6g} .. {:.6g} s", begin, end), inputs,
          setup_hash(definition, {row.candidate, row.reference, row.improves_on.value_or("")}),
          evidence_of(definition, row)};
}

// An error of a problem is exact but for its round-off, which may be all of it: a thousandth of the
// bound stands for that.
std::optional<BaselineValue> baseline_value(const ProblemGateOutcome& outcome) {
  if (!std::isfinite(outcome.value)) return {};
  BaselineValue value{
      outcome.value, 0, {}, {}, RowTerms{kind_name(outcome.row.kind), "", "", "", ""}};
  const bool at_least = outcome.row.metric == ProblemMetric::order_at_least;
  (at_least ? value.lower : value.upper) = outcome.row.limit;
  if (const auto& between = outcome.row.between) std::tie(value.lower, value.upper) = *between;
  value.half_width = 1e-3 * std::abs(value.upper.value_or(value.lower.value_or(0)));
  return value;
}

// A row of a case or of a problem as it stands.
struct PresentRow {
  std::string name, unit;
  Verdict verdict;
  std::optional<BaselineValue> value;
};

// A cost is measured on one machine and says nothing about another.
std::vector<PresentRow> present_rows(const JudgedCampaign& campaign) {
  std::vector<PresentRow> rows;
  for (const CaseAssessment& one : campaign.cases)
    for (const GateOutcome& outcome : one.gate) {
      if (is_cost(outcome.row.metric)) continue;
      PresentRow row{row_name(one.definition.name, outcome.row), outcome.row.unit, outcome.verdict,
                     baseline_value(outcome)};
      if (row.value) row.value->terms = terms_of(one.definition, outcome.row);
      rows.push_back(std::move(row));
    }
  for (const ProblemAssessment& one : campaign.problems)
    for (const ProblemGateOutcome& outcome : one.gate)
      rows.push_back({row_name(one.definition.name, outcome.row),
                      outcome.row.unit == "1" ? "" : outcome.row.unit, outcome.verdict,
                      baseline_value(outcome)});
  return rows;
}

RowMovement movement_of(const PresentRow& row, const std::optional<BaselineValue>& before) {
  RowMovement movement{.row = row.name, .unit = row.unit, .before = before, .after = row.value};
  if (before && movement.after) {
    movement.uncertainties = uncertainties_between(*before, *movement.after);
    movement.loosened = is_loosened(*before, *movement.after);
  }
  return movement;
}

std::string terms_text(const RowTerms& before, const RowTerms& after) {
  std::string text;
  const auto add = [&](const char* name, std::string RowTerms::*term) {
    if (before.*term == after.*term) return;
    const auto shown = [](const std::string& of) { return of.empty() ? "none" : of; };
    text += fmt::format(", {}: {} -> {}", name, shown(before.*term), shown(after.*term));
  };
  add("kind", &RowTerms::kind);
  add("window", &RowTerms::window);
  add("inputs", &RowTerms::inputs);
  if (!before.evidence.empty()) add("rests on", &RowTerms::evidence);
  if (before.setup != after.setup)
    text += ", the case or the settings of the row's runs are others";
  return text;
}

bool has_other_terms(const RowMovement& movement) {
  if (!movement.before->terms || !movement.after->terms) return false;
  return !terms_text(*movement.before->terms, *movement.after->terms).empty();
}

// The case, the runs and the metric that a row's name tells.
std::vector<std::string> parts_of(std::string name) {
  for (const char* between : {": ", " against ", ", below that of ", ", "})
    boost::replace_all(name, between, "\n");
  std::vector<std::string> parts;
  return boost::split(parts, name, [](char c) { return c == '\n'; });
}

// Whether the names differ in that of the case or of one run alone.
bool differ_in_one_name(const std::string& one, const std::string& other) {
  const std::vector<std::string> a = parts_of(one), b = parts_of(other);
  if (a.size() != b.size()) return false;
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool is_metric = a[i].find(" of ") != std::string::npos;
    if (a[i] != b[i]) different += is_metric ? a.size() : 1;
  }
  return different == 1;
}

void name_renamed_rows(std::vector<RowMovement>& movements) {
  for (RowMovement& lost : movements) {
    if (!lost.lost) continue;
    const auto found = std::find_if(movements.begin(), movements.end(), [&](const auto& one) {
      return !one.before && one.after && one.other_name.empty() &&
             differ_in_one_name(one.row, lost.row);
    });
    if (found == movements.end()) continue;
    lost.other_name = found->row;
    found->other_name = lost.row;
  }
}

std::string tolerance_text(const RowMovement& movement) {
  const BaselineValue &before = *movement.before, &after = *movement.after;
  const bool tightened = is_loosened(after, before);
  if (!movement.loosened && !tightened) return "";
  return fmt::format(", tolerance {}: {} -> {}",
                     movement.loosened && tightened ? "moved"
                     : tightened                    ? "tightened"
                                                    : "loosened",
                     range(before, movement.unit), range(after, movement.unit));
}

}  // namespace

bool RowMovement::has_changed() const {
  if (lost) return true;
  if (!before || !after) return before.has_value() != after.has_value();
  return loosened || is_loosened(*after, *before) || has_moved(*before, *after) ||
         has_other_terms(*this);
}

bool RowMovement::loses_validation() const {
  const std::string regression = kind_name(RowKind::regression);
  if (!before || (before->terms && before->terms->kind == regression)) return false;
  return lost || (before->terms && after && after->terms->kind == regression);
}

std::string row_name(const std::string& case_name, const GateRow& row) {
  return case_name + ": " + row_name(row);
}

std::string row_name(const std::string& problem, const ProblemGateRow& row) {
  return problem + ": " + metric_name(row.metric) + " of " + row.measure;
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

std::vector<RowMovement> movements(const Baseline& baseline, const JudgedCampaign& campaign) {
  std::vector<RowMovement> found;
  std::set<std::string> kept;
  for (const PresentRow& row : present_rows(campaign)) {
    const bool left_out = row.verdict == Verdict::not_selected;
    if (!left_out || campaign.is_partial) kept.insert(row.name);
    if (left_out || row.verdict == Verdict::not_supplied) continue;
    const auto known = baseline.find(row.name);
    found.push_back(
        movement_of(row, known == baseline.end() ? std::optional<BaselineValue>() : known->second));
  }
  for (const auto& [row, value] : baseline)
    if (!kept.contains(row))
      found.push_back({.row = row, .unit = "", .before = value, .after = {}, .lost = true});
  name_renamed_rows(found);
  return found;
}

std::vector<BaselineChange> proposed_changes(const std::vector<RowMovement>& movements) {
  std::vector<BaselineChange> changes;
  for (const RowMovement& one : movements) {
    if (!one.after && !one.lost) continue;
    if (one.has_changed())
      changes.push_back({one.row, one.before, one.after});
    else if (!one.before->terms) {
      changes.push_back({one.row, one.before, one.before});
      changes.back().after->terms = one.after->terms;
    }
  }
  return changes;
}

std::string movement_text(const RowMovement& movement) {
  const auto& [row, unit, before, after, uncertainties, loosened, lost, other_name] = movement;
  if (lost)
    return std::string("no row of this form any more") +
           (other_name.empty() ? "" : "; it may be " + other_name + " now");
  if (!before && !after) return "no value";
  if (!after) return "no value any more";
  if (!before)
    return "new: " + signed_in_unit(after->value, unit) +
           (other_name.empty() ? "" : "; it may have been " + other_name);
  return (before->value == after->value ? "unmoved"
          : std::isinf(uncertainties)
              ? change_text(before->value, after->value, unit) + " (no interval)"
              : fmt::format("{} ({:.2g} uncertainties)",
                            change_text(before->value, after->value, unit), uncertainties)) +
         tolerance_text(movement) +
         (before->terms ? terms_text(*before->terms, *after->terms) : "");
}

std::string changes_sentence(const std::vector<RowMovement>& movements) {
  int lost = 0, lost_of_validation = 0, added = 0, changed = 0, demoted = 0;
  for (const RowMovement& one : movements) {
    lost += one.lost;
    (one.lost ? lost_of_validation : demoted) += one.loses_validation();
    added += !one.before && one.after;
    changed += one.before && !one.lost && one.has_changed();
  }
  std::vector<std::string> parts;
  if (lost > 0)
    parts.push_back(fmt::format("{} lost ({} of validation)", lost, lost_of_validation));
  if (added > 0) parts.push_back(fmt::format("{} new", added));
  if (changed > 0) parts.push_back(fmt::format("{} changed", changed));
  if (demoted > 0) parts.push_back(fmt::format("{} of validation now of regression", demoted));
  return parts.empty() ? "" : fmt::format("Rows since the baseline: {}.", fmt::join(parts, ", "));
}

}  // namespace slosh
