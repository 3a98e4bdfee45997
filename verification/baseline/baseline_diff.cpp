#include "verification/baseline/baseline_diff.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "verification/case/campaign_definition.hpp"
#include "verification/case/changed_input.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/input/toml_reader.hpp"
#include "verification/runs/run_key.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

constexpr double unbounded = std::numeric_limits<double>::infinity();

double uncertainties_between(const BaselineValue& before, const BaselineValue& after) {
  if (!before.value || !after.value) return 0;
  const double moved = std::abs(*after.value - *before.value);
  return moved == 0 ? 0 : moved / std::hypot(before.half_width, after.half_width);
}

// Relative to the larger of the metric and its tolerance. Round-off that depends on the compiler's
// order of summation is smaller, unless the flow amplifies it, which the intervals then show.
constexpr double rounding = 1e-6;

double scale_of(const BaselineValue& one) {
  double scale = std::abs(one.value.value_or(0));
  for (const std::optional<double>& bound : {one.lower, one.upper})
    if (bound && std::isfinite(*bound)) scale = std::max(scale, std::abs(*bound));
  return scale;
}

bool has_moved(const BaselineValue& before, const BaselineValue& after) {
  return before.value && after.value &&
         std::abs(*after.value - *before.value) >
             rounding * std::max(scale_of(before), scale_of(after)) &&
         uncertainties_between(before, after) > 1;
}

// An interval that differs by less cannot decide between two verdicts, or is as good as the other.
constexpr double unseen_interval = 0.01, other_interval = 2;

bool has_other_interval(const BaselineValue& before, const BaselineValue& after) {
  if (!before.uncertainty || !after.uncertainty) return false;
  const auto [small, large] = std::minmax(*before.uncertainty, *after.uncertainty);
  return small < large && large > other_interval * small &&
         large - small > unseen_interval * std::max(scale_of(before), scale_of(after));
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
std::string evidence_of(const RunDefinition& run, const fs::path& case_file) {
  return std::visit(
      [&](const auto& solver) -> std::string {
        using Run = std::decay_t<decltype(solver)>;
        if constexpr (std::is_same_v<Run, RecordRun>)
          return fmt::format("; {}, the record {}", run.name, solver.file.filename().string()) +
                 (solver.uncertainty
                      ? fmt::format(" +- {:.6g} {}", *solver.uncertainty, solver.unit)
                      : "");
        else if constexpr (std::is_same_v<Run, ExternalRun>) {
          std::string inputs;
          for (const fs::path& one : solver.inputs) inputs += " " + from_case_file(case_file, one);
          if (!inputs.empty()) inputs = fmt::format("; inputs of {}:{}", run.name, inputs);
          return solver.directory.empty()
                     ? inputs
                     : fmt::format("{}; {} starts in {}", inputs, run.name,
                                   from_case_file(case_file, solver.directory));
        } else if constexpr (requires { solver.valid_elevation_over_depth; })
          return fmt::format("; {} up to {:.6g} depths", run.name,
                             solver.valid_elevation_over_depth);
        else
          return "";
      },
      run.solver);
}

std::set<std::string> runs_of(const GateRow& row) {
  return {row.candidate, row.reference, row.improves_on.value_or("")};
}

bool holds_any(const RefinementDefinition& path, const std::set<std::string>& names) {
  return std::any_of(path.runs.begin(), path.runs.end(),
                     [&](const std::string& run) { return names.contains(run); });
}

std::string evidence_of(const CaseDefinition& definition, const GateRow& row) {
  std::string text = fmt::format("{} natural modes", definition.natural_modes);
  const std::set<std::string> names = runs_of(row);
  for (const RefinementDefinition& one : definition.refinements)
    if (holds_any(one, names))
      text += fmt::format("; refinement {}: {}", one.name, fmt::join(one.runs, ", "));
  for (const RunDefinition& run : definition.runs)
    if (names.contains(run.name)) text += evidence_of(run, definition.file);
  return text;
}

// The runs that the verdict rests on beside the row's own: of its refinements, of inputs, and for a
// cost those of the candidate's family.
std::set<std::string> other_runs_of(const CaseDefinition& definition, const GateRow& row) {
  std::set<std::string> others;
  for (const RefinementDefinition& one : definition.refinements)
    if (holds_any(one, runs_of(row))) others.insert(one.runs.begin(), one.runs.end());
  for (const InputUncertainty& one : definition.inputs) others.insert(one.coarse_run);
  std::set<std::string> families;
  for (const RunDefinition& run : definition.runs)
    if (is_cost(row.metric) && run.name == row.candidate) families.insert(work_family(run));
  for (const RunDefinition& run : definition.runs)
    if (families.contains(work_family(run))) others.insert(run.name);
  return others;
}

// All that the case file says but for names, words, rows and runs, so that no key is forgotten; the
// settings of the other runs; and the table of repeats, of which the file says its name alone.
std::string hash_of_the_rest(const CaseDefinition& definition, const GateRow& row) {
  std::string rest = TomlTable(definition.text, definition.file)
                         .without({"schema_version", "name", "title", "source", "tags", "animation",
                                   "run", "refinement", "gate"})
                         .as_toml();
  const std::set<std::string> others = other_runs_of(definition, row);
  for (const RunDefinition& run : definition.runs)
    if (others.contains(run.name))
      rest += hashed_settings(run).dump() + evidence_of(run, definition.file);
  for (const RefinementDefinition& one : definition.refinements)
    if (holds_any(one, runs_of(row))) rest += fmt::format("{}", static_cast<int>(one.number));
  if (is_of_repeats(row.metric) && definition.impacts)
    rest += fmt::format("{}", definition.impacts->repeats);
  return content_hash(rest);
}

// Members of one ensemble as "NAME (count)".
std::string names_of(const CaseDefinition& definition, const std::set<std::string>& runs) {
  std::map<std::string, int> members;
  for (const RunDefinition& run : definition.runs)
    if (runs.contains(run.name)) ++members[run.ensemble.empty() ? run.name : run.ensemble];
  std::vector<std::string> names;
  for (const auto& [name, count] : members)
    names.push_back(count == 1 ? name : fmt::format("{} ({})", name, count));
  return fmt::format("{}", fmt::join(names, ", "));
}

RowTerms terms_of(const CaseDefinition& definition, const GateOutcome& outcome) {
  const GateRow& row = outcome.row;
  const auto [begin, end] = judged_time(row, definition);
  std::string inputs;
  for (const InputUncertainty& one : definition.inputs)
    inputs += fmt::format("{}{} +- {:.6g} {}{}", inputs.empty() ? "" : ", ", input_name(one.input),
                          one.half_width, input_unit(one.input, definition.motion),
                          one.coarse_run.empty() ? "" : " by " + one.coarse_run);
  const std::string measured_with = names_of(definition, outcome.measured_with);
  return {kind_name(row.kind),
          fmt::format("{:.6g} .. {:.6g} s", begin, end),
          inputs,
          setup_hash(definition, runs_of(row)) + "-" + hash_of_the_rest(definition, row) +
              (measured_with.empty() ? "" : "-" + setup_hash(definition, outcome.measured_with)),
          evidence_of(definition, row),
          measured_with,
          definition.tags};
}

// A row with a limit, a range or neither. A cost is measured on one machine and says nothing about
// another.
BaselineValue baseline_value(const GateOutcome& outcome) {
  BaselineValue value{{}, 0, {}, {}};
  const auto& [measured, half_width] = outcome.value;
  if (std::isfinite(measured) && !is_cost(outcome.row.metric)) {
    value.value = measured;
    value.half_width = std::isfinite(half_width) ? half_width : 0;
  }
  if (outcome.row.limit || outcome.row.between) {
    const std::optional<double>& limit = outcome.row.limit;
    std::tie(value.lower, value.upper) =
        limit ? std::pair(-*limit, *limit) : outcome.row.between.value();
  }
  if (value.value && outcome.judgement) {
    const bool is_whole = outcome.row.kind == RowKind::regression ||
                          missing_for_validation(outcome.judgement->contributions).empty();
    const double half_width = outcome.judgement->uncertainty;
    value.uncertainty = is_whole && std::isfinite(half_width) ? half_width : unbounded;
  }
  return value;
}

// An error of a problem is exact but for its round-off, which may be all of it: a thousandth of the
// bound stands for that.
BaselineValue baseline_value(const ProblemGateOutcome& outcome) {
  BaselineValue value{{}, 0, {}, {}, RowTerms{kind_name(outcome.row.kind), "", "", "", ""}};
  if (std::isfinite(outcome.value)) value.value = outcome.value;
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
  BaselineValue value;
  const CaseDefinition* of_case = nullptr;  // none of a problem's
  std::string candidate = {};
};

std::vector<PresentRow> present_rows(const JudgedCampaign& campaign) {
  std::vector<PresentRow> rows;
  for (const CaseAssessment& one : campaign.cases)
    for (const GateOutcome& outcome : one.gate) {
      rows.push_back({row_name(one.definition.name, outcome.row), outcome.row.unit, outcome.verdict,
                      baseline_value(outcome)});
      rows.back().value.terms = terms_of(one.definition, outcome);
      rows.back().of_case = &one.definition;
      rows.back().candidate = outcome.row.candidate;
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
  movement.verdict = row.verdict;
  if (before) {
    movement.uncertainties = uncertainties_between(*before, row.value);
    movement.loosened = is_loosened(*before, row.value);
  }
  return movement;
}

// Whether the selection leaves the row out, and would take it if its case had the tags that the
// baseline records.
bool has_lost_tag(const PresentRow& row, const Baseline& baseline, const JudgedCampaign& campaign) {
  const auto before = baseline.find(row.name);
  if (!campaign.selects || !row.of_case || before == baseline.end() || !before->second.terms)
    return false;
  CaseDefinition one = *row.of_case;
  const RunDefinition& candidate = run_named(*row.of_case, row.candidate);
  const bool is_selected = campaign.selects(one, candidate);
  one.tags = before->second.terms->tags;
  return !is_selected && campaign.selects(one, candidate);
}

// A record that is not supplied has no content, so that its setup says nothing.
std::string terms_text(const RowTerms& before, const RowTerms& after, bool lacks_record) {
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
  const bool are_measured = !before.measured_with.empty() && !after.measured_with.empty();
  if (!lacks_record && are_measured) add("measured with", &RowTerms::measured_with);
  const bool is_alike = after.setup.starts_with(before.setup) ||
                        (!are_measured && before.setup.starts_with(after.setup));
  if (!lacks_record && !is_alike) text += ", the case or the settings of the row's runs are others";
  if (!before.tags.empty() && before.tags != after.tags)
    text +=
        fmt::format(", tags: {} -> {}", fmt::join(before.tags, ", "),
                    after.tags.empty() ? "none" : fmt::format("{}", fmt::join(after.tags, ", ")));
  return text;
}

bool has_other_terms(const RowMovement& movement) {
  if (!movement.before->terms || !movement.after->terms) return false;
  return !terms_text(*movement.before->terms, *movement.after->terms, movement.lacks_record())
              .empty();
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
    if (!lost.lost()) continue;
    const auto found = std::find_if(movements.begin(), movements.end(), [&](const auto& one) {
      return !one.before && one.other_name.empty() && differ_in_one_name(one.row, lost.row);
    });
    if (found == movements.end()) continue;
    lost.other_name = found->row;
    found->other_name = lost.row;
  }
}

std::string width_text(const RowMovement& movement) {
  const BaselineValue &before = *movement.before, &after = *movement.after;
  if (!has_other_interval(before, after)) return "";
  const auto shown = [&](double half_width) {
    return std::isfinite(half_width) ? in_unit(half_width, movement.unit) : "unknown";
  };
  return fmt::format(", U: {} -> {}", shown(*before.uncertainty), shown(*after.uncertainty));
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
  if (!before || !after) return true;
  const bool has_value_alike = before->value.has_value() == after->value.has_value();
  return (!lacks_record() && !has_value_alike) || loosened || is_loosened(*after, *before) ||
         has_moved(*before, *after) || has_other_interval(*before, *after) ||
         has_other_terms(*this);
}

bool RowMovement::loses_validation() const {
  const std::string regression = kind_name(RowKind::regression);
  if (!before || (before->terms && before->terms->kind == regression)) return false;
  const bool rests_on_nothing = lacks_record() && before->value && has_other_terms(*this);
  return lost() || rests_on_nothing || (before->terms && after->terms->kind == regression);
}

std::string row_name(const std::string& case_name, const GateRow& row) {
  return case_name + ": " + row_name(row);
}

std::string row_name(const std::string& problem, const ProblemGateRow& row) {
  return problem + ": " + metric_name(row.metric) + " of " + row.measure;
}

std::vector<RowMovement> movements(const Baseline& baseline, const JudgedCampaign& campaign) {
  std::vector<RowMovement> found;
  std::set<std::string> kept, untagged;
  for (const PresentRow& row : present_rows(campaign)) {
    const bool left_out = row.verdict == Verdict::not_selected;
    if (left_out && has_lost_tag(row, baseline, campaign))
      untagged.insert(row.name);
    else if (!left_out || campaign.selects)
      kept.insert(row.name);
    if (left_out) continue;
    const auto known = baseline.find(row.name);
    found.push_back(
        movement_of(row, known == baseline.end() ? std::optional<BaselineValue>() : known->second));
  }
  for (const auto& [row, value] : baseline)
    if (!kept.contains(row))
      found.push_back({.row = row,
                       .unit = "",
                       .before = value,
                       .after = {},
                       .lost_tag = untagged.contains(row)});
  name_renamed_rows(found);
  return found;
}

std::vector<BaselineChange> proposed_changes(const std::vector<RowMovement>& movements) {
  std::vector<BaselineChange> changes;
  for (const RowMovement& one : movements) {
    const bool has_failed =
        one.after && !one.after->value && !one.lacks_record() &&
        ((one.before && one.before->value) || one.verdict == Verdict::solver_failed);
    if (has_failed) continue;
    if (one.has_changed())
      changes.push_back({one.row, one.before, one.after});
    else if (!one.lacks_record() && one.before->terms != one.after->terms) {
      changes.push_back({one.row, one.before, one.before});
      changes.back().after->terms = one.after->terms;
      if (!one.before->uncertainty) changes.back().after->uncertainty = one.after->uncertainty;
    }
  }
  return changes;
}

std::string movement_text(const RowMovement& movement) {
  const auto& [row, unit, before, after, uncertainties, loosened, verdict, other_name, lost_tag] =
      movement;
  if (lost_tag)
    return fmt::format("no row of this selection any more; its case had the tags {}",
                       fmt::join(before->terms->tags, ", "));
  if (!after)
    return std::string("no row of this form any more") +
           (other_name.empty() ? "" : "; it may be " + other_name + " now");
  const std::string value = after->value              ? signed_in_unit(*after->value, unit)
                            : movement.lacks_record() ? "not supplied"
                                                      : "no value";
  if (!before)
    return "new: " + value + (other_name.empty() ? "" : "; it may have been " + other_name);
  std::string text = value;
  if (before->value && after->value)
    text = *before->value == *after->value ? "unmoved"
           : std::isinf(uncertainties)
               ? change_text(*before->value, *after->value, unit) + " (no interval)"
               : fmt::format("{} ({:.2g} uncertainties)",
                             change_text(*before->value, *after->value, unit), uncertainties);
  else if (before->value && !movement.lacks_record())
    text = "no value any more";
  else if (after->value)
    text = "first value: " + value;
  return text + tolerance_text(movement) + width_text(movement) +
         (before->terms ? terms_text(*before->terms, *after->terms, movement.lacks_record()) : "");
}

std::string changed_lines(const std::vector<RowMovement>& movements) {
  std::string lines;
  for (const RowMovement& one : movements)
    if (one.has_changed())
      lines += fmt::format("{:<14} {}: {}\n",
                           one.lost()   ? "lost"
                           : one.before ? "moved"
                                        : "new",
                           one.row, movement_text(one));
  return lines;
}

std::string changes_sentence(const std::vector<RowMovement>& movements) {
  int lost = 0, lost_of_validation = 0, added = 0, changed = 0, demoted = 0;
  for (const RowMovement& one : movements) {
    lost += one.lost();
    (one.lost() ? lost_of_validation : demoted) += one.loses_validation();
    added += !one.before;
    changed += one.before && !one.lost() && one.has_changed();
  }
  std::vector<std::string> parts;
  if (lost > 0)
    parts.push_back(fmt::format("{} lost ({} of validation)", lost, lost_of_validation));
  if (added > 0) parts.push_back(fmt::format("{} new", added));
  if (changed > 0) parts.push_back(fmt::format("{} changed", changed));
  if (demoted > 0) parts.push_back(fmt::format("{} of validation no more", demoted));
  return parts.empty() ? "" : fmt::format("Rows since the baseline: {}.", fmt::join(parts, ", "));
}

}  // namespace slosh
