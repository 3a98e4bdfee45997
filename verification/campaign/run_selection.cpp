#include "verification/campaign/run_selection.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <set>

#include "verification/assessment/work_points.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/input_uncertainty.hpp"
#include "verification/evidence/repeat_spread.hpp"
#include "verification/evidence/row_uncertainty.hpp"
#include "verification/files/shell_word.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/nearest_name.hpp"

namespace slosh {
namespace {

bool matches(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), FNM_PATHNAME) == 0;
}

bool matches_run(const std::string& pattern, const std::string& case_name, const std::string& run) {
  return matches(pattern, case_name) || matches(pattern, case_name + "/" + run);
}

bool has(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

bool has_any_tag(const std::vector<std::string>& tags, const CaseDefinition& definition) {
  return tags.empty() || std::any_of(tags.begin(), tags.end(), [&](const std::string& tag) {
           return has(definition.tags, tag);
         });
}

bool refined_together(const CaseDefinition& definition, const std::string& one,
                      const std::string& other) {
  return std::any_of(definition.refinements.begin(), definition.refinements.end(),
                     [&](const RefinementDefinition& path) {
                       return has(path.runs, one) && has(path.runs, other);
                     });
}

bool are_repeats(const CaseDefinition& definition, const RunDefinition& run,
                 const std::string& other) {
  const auto* sph = std::get_if<SphRun>(&run.solver);
  const auto* candidate = std::get_if<SphRun>(&run_named(definition, other).solver);
  return sph && !run.varies_inputs && candidate && repeat_one_another(*sph, *candidate);
}

// Rows, refinements and patterns name an ensemble by its first member.
const std::string& ensemble_name(const RunDefinition& run) {
  return run.ensemble.empty() ? run.name : run.ensemble;
}

// Whether it may tell what the inputs do to the row. Which theory is in its range is not yet known.
bool predicts_inputs_of(const CaseDefinition& definition, const GateRow& row,
                        const RunDefinition& run) {
  return rests_on_input_bounds(definition, row) &&
         std::any_of(definition.inputs.begin(), definition.inputs.end(),
                     [&](const InputUncertainty& one) {
                       return one.coarse_run == run.name || may_predict(run, one.input);
                     });
}

// Returns whether the row's value, bounds or uncertainty (row_uncertainty.hpp) depend on the run.
bool rests_on(const CaseDefinition& definition, const GateRow& row, const RunDefinition& run) {
  if (run.at_input) return rests_on_input_bounds(definition, row);
  const std::string& name = ensemble_name(run);
  if (predicts_inputs_of(definition, row, run)) return true;
  if (row.candidate == name || row.reference == name) return true;
  if (row.improves_on) {
    GateRow other = row;
    other.candidate = *row.improves_on;
    other.improves_on.reset();
    if (rests_on(definition, other, run)) return true;
  }
  if (is_cost(row.metric))
    return work_family(run) == work_family(run_named(definition, row.candidate));
  if (are_repeats(definition, run, row.candidate)) return true;
  if (is_of_impacts(row.metric))
    return is_record(run) || refined_together(definition, row.candidate, name);
  if (row.reference.empty()) return false;
  const bool against_record = is_record(run_named(definition, row.reference));
  return refined_together(definition, against_record ? row.candidate : row.reference, name);
}

bool matches_any(const std::string& pattern, const std::set<std::string>& names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return matches(pattern, name); });
}

[[noreturn]] void refuse(const std::string& value, const std::string& expected,
                         const std::set<std::string>& known) {
  constexpr std::size_t suggestions = 3;
  throw CaseFileError(fmt::format(
      "{} matches nothing: expected {}; nearest: {}", value, expected,
      fmt::join(nearest_names(value, {known.begin(), known.end()}, suggestions), ", ")));
}

}  // namespace

bool names_run(const RunSelection& selection, const CaseDefinition& definition,
               const RunDefinition& run) {
  return has_any_tag(selection.tags, definition) &&
         (selection.only.empty() ||
          std::any_of(selection.only.begin(), selection.only.end(), [&](const auto& pattern) {
            return matches_run(pattern, definition.name, run.name) ||
                   matches_run(pattern, definition.name, ensemble_name(run));
          }));
}

bool names_problem(const RunSelection& selection, const std::string& problem) {
  if (!selection.tags.empty()) return false;
  return selection.only.empty() ||
         std::any_of(selection.only.begin(), selection.only.end(),
                     [&](const std::string& pattern) { return matches(pattern, problem); });
}

bool is_selected(const RunSelection& selection, const CaseDefinition& definition,
                 const RunDefinition& run) {
  if (selection.quick && !run.quick) return false;
  const bool is_asked_for = !run.at_input || !selection.only.empty();
  if (is_asked_for && names_run(selection, definition, run)) return true;
  return std::any_of(definition.gate.begin(), definition.gate.end(), [&](const GateRow& row) {
    const RunDefinition& candidate = run_named(definition, row.candidate);
    return (candidate.quick || !selection.quick) && names_run(selection, definition, candidate) &&
           rests_on(definition, row, run);
  });
}

void require_matches(const RunSelection& selection, const Selectable& among) {
  std::set<std::string> names(among.others.begin(), among.others.end()), runs, tags;
  for (const CaseDefinition& definition : among.cases) {
    names.insert(definition.name);
    tags.insert(definition.tags.begin(), definition.tags.end());
    for (const RunDefinition& run : definition.runs) runs.insert(definition.name + "/" + run.name);
  }
  for (const std::string& pattern : selection.only) {
    const bool of_runs = pattern.find('/') != std::string::npos;
    if (matches_any(pattern, of_runs ? runs : names)) continue;
    // The error names what is wrong first: the case, or the run in existing cases.
    const std::string case_part = pattern.substr(0, pattern.find('/'));
    std::erase_if(runs, [&](const std::string& run) { return !matches(case_part + "/*", run); });
    refuse(pattern, "a pattern that matches a name or a CASE/RUN", runs.empty() ? names : runs);
  }
  for (const std::string& tag : selection.tags)
    if (!tags.contains(tag)) refuse(tag, "a tag of a case", tags);
}

std::string selection_text(const RunSelection& selection) {
  std::string text;
  if (!selection.only.empty()) text = fmt::format("only {}", fmt::join(selection.only, ", "));
  if (!selection.tags.empty())
    text += fmt::format("{}tagged {}", text.empty() ? "" : "; ", fmt::join(selection.tags, ", "));
  return text;
}

std::string selection_options(const RunSelection& selection) {
  std::string options = selection.quick ? " --quick" : "";
  for (const std::string& pattern : selection.only) options += " --only " + shell_word(pattern);
  for (const std::string& tag : selection.tags) options += " --tag " + shell_word(tag);
  return options;
}

}  // namespace slosh
