#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "reports/tables/case_tables.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

struct AblationRun {
  std::string name;
  const SphRun* sph;
  const RunResult* result;       // null where the run left none
  const Comparison* comparison;  // against theory or a record; null where there is none
  std::string changes;
};

std::vector<AblationRun> ablation_runs(const CaseAssessment& assessment) {
  std::vector<AblationRun> runs;
  for (const RunDefinition& run : assessment.definition.runs)
    if (const SphRun* sph = std::get_if<SphRun>(&run.solver); sph && !is_later_member(run))
      runs.push_back({run.name, sph, find_result(assessment.runs, run.name),
                      comparison_with_truth(assessment, run.name), changes_of(*sph)});
  return runs;
}

// Returns the unchanged run of the same scheme and spacing; null for an unchanged run, and where
// the case has none.
const AblationRun* unchanged(const std::vector<AblationRun>& runs, const AblationRun& one) {
  if (one.changes.empty()) return nullptr;
  const auto found = std::ranges::find_if(runs, [&](const AblationRun& other) {
    return other.sph->scheme == one.sph->scheme &&
           other.sph->particle_spacing == one.sph->particle_spacing &&
           other.sph->surface_particle_spacing == one.sph->surface_particle_spacing &&
           other.changes.empty();
  });
  return found == runs.end() ? nullptr : &*found;
}

std::string spacing_text(const SphRun& sph) {
  const double inside = 1000 * sph.particle_spacing, surface = 1000 * sph.surface_particle_spacing;
  return inside == surface ? fmt::format("{:.4g}", inside)
                           : fmt::format("{:.4g} / {:.4g}", inside, surface);
}

std::string ratio(double value, double unchanged_value) {
  return fmt::format("{:.3g}", value / unchanged_value);
}

// The term that each number belongs to, in the sequence of sph_number_names.
constexpr const char* terms_of_numbers[] = {"kernel: h / spacing", "state: c0 / largest speed",
                                            "time step: dt c0 / h", "viscosity: alpha",
                                            "density diffusion: delta"};
static_assert(std::size(terms_of_numbers) == std::size(sph_number_names));

// "quintic kernel and viscosity": the terms that only the one result has.
std::string terms_besides(const RunResult& one, const RunResult& other) {
  TableRow terms = one.active_terms;
  std::erase_if(terms, [&](const std::string& term) {
    return std::ranges::find(other.active_terms, term) != other.active_terms.end();
  });
  return fmt::format("{}", fmt::join(terms, " and "));
}

// Returns the terms that a run has added, left out or replaced against the unchanged run, and the
// terms that its changed numbers belong to.
std::string changed_terms(const AblationRun& one, const AblationRun* plain) {
  TableRow texts;
  if (plain && plain->result && one.result) {
    const std::string with = terms_besides(*one.result, *plain->result),
                      without = terms_besides(*plain->result, *one.result);
    if (!with.empty() && !without.empty())
      texts.push_back(with + " instead of " + without);
    else if (!with.empty() || !without.empty())
      texts.push_back(with.empty() ? "without " + without : "with " + with);
  }
  if (!one.sph->initial_state.empty() || one.sph->start_disorder > unseen_disorder ||
      one.sph->start_rotation_deg != 0)
    texts.push_back("initial state");
  for (std::size_t i = 0; i < std::size(sph_number_names); ++i)
    if (one.sph->numbers.*sph_number_names[i].second) texts.push_back(terms_of_numbers[i]);
  return fmt::format("{}", fmt::join(texts, "; "));
}

// Returns a measure of the first fitted mode of a kind; empty where none was fitted.
std::string mode_cell(const Comparison& comparison, const std::string& kind,
                      Estimate ModeComparison::*measure, double scale) {
  for (const ModeComparison& mode : comparison.modes) {
    if (!mode.mode.starts_with(kind)) continue;
    if (!mode.resolved()) return "not resolved";
    const Estimate& estimate = mode.*measure;
    return interval_text({scale * estimate.value, scale * estimate.half_width});
  }
  return "";
}

TableRow error_cells(const AblationRun& one, const AblationRun* plain) {
  if (!one.comparison) return TableRow(7);
  const Comparison& comparison = *one.comparison;
  const bool same_reference =
      plain && plain->comparison && plain->comparison->reference == comparison.reference;
  return {comparison.reference,
          fmt::format("{:.2f}", 100 * comparison.normalised_rms.value),
          same_reference
              ? ratio(comparison.normalised_rms.value, plain->comparison->normalised_rms.value)
              : "",
          mode_cell(comparison, "forced", &ModeComparison::amplitude_error, 100),
          mode_cell(comparison, "forced", &ModeComparison::phase_lag_degrees, 1),
          mode_cell(comparison, "natural", &ModeComparison::frequency_error, 100),
          mode_cell(comparison, "natural", &ModeComparison::decay_rate, 1)};
}

TableRow cost_cells(const AblationRun& one, const AblationRun* plain, double duration) {
  if (!one.result) return TableRow(5);
  const RunCost& cost = one.result->cost;
  const double time = cost.core_seconds();
  return {fmt::format("{:.2f}", time),
          plain && plain->result ? ratio(time, plain->result->cost.core_seconds()) : "",
          fmt::format("{}", cost.steps),
          fmt::format("{:.4g}", 1e6 * time / (cost.elements * duration)),
          fmt::format("{:.0f}", cost.peak_memory / cost.elements)};
}

}  // namespace

reports::Table ablation_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  reports::Table table = case_table(
      definition, "choices", "Ablation: effect and cost of each change to a scheme",
      "The error of each SPH run against theory or a published record, and its cost. \"over "
      "unchanged\": ratio to the unchanged run of the same scheme and spacing. CPU time is user "
      "plus system time; peak memory is that of the whole process.",
      {"run", "scheme", "spacing [mm]", "change", "affected terms", "reference",
       "normalised rms [%]", "rms over unchanged", "forced amplitude error [%]", "forced lag [deg]",
       "natural frequency error [%]", "decay rate [1/s]", "CPU time [s]", "CPU time over unchanged",
       "steps", "CPU time [us per particle and simulated s]", "peak memory [byte per particle]"});
  const std::vector<AblationRun> runs = ablation_runs(assessment);
  const auto is_changed = [](const AblationRun& one) { return !one.changes.empty(); };
  const auto is_compared = [](const AblationRun& one) { return one.comparison != nullptr; };
  if (std::ranges::none_of(runs, is_changed) || std::ranges::none_of(runs, is_compared))
    return table;
  for (const AblationRun& one : runs) {
    const AblationRun* plain = unchanged(runs, one);
    TableRow row{one.name, one.sph->scheme, spacing_text(*one.sph),
                 one.changes.empty() ? "unchanged" : one.changes, changed_terms(one, plain)};
    append(row, error_cells(one, plain));
    append(row, cost_cells(one, plain, definition.duration));
    if (!one.result) row[5] = state_name(assessment.runs.status.at(one.name).state);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace slosh
