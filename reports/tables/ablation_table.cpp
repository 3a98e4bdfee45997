#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "reports/tables/case_tables.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

struct AblationRun {
  const RunDefinition* run;
  const SphRun* sph;
  const RunResult* result;       // null where the run left none
  const Comparison* comparison;  // against theory or a record; null where there is none
};

std::vector<AblationRun> ablation_runs(const CaseAssessment& assessment) {
  std::vector<AblationRun> runs;
  for (const RunDefinition& run : assessment.definition.runs) {
    const SphRun* sph = std::get_if<SphRun>(&run.solver);
    if (!sph || is_later_member(run)) continue;
    const auto found = assessment.runs.results.find(run.name);
    runs.push_back({&run, sph, found == assessment.runs.results.end() ? nullptr : &found->second,
                    comparison_with_truth(assessment, run.name)});
  }
  return runs;
}

// Returns the unchanged run of the same scheme and spacing, null where the case has none.
const AblationRun* unchanged(const std::vector<AblationRun>& runs, const SphRun& sph) {
  const auto found = std::find_if(runs.begin(), runs.end(), [&](const AblationRun& other) {
    return other.sph->scheme == sph.scheme && other.sph->particle_spacing == sph.particle_spacing &&
           other.sph->surface_particle_spacing == sph.surface_particle_spacing &&
           changes_of(*other.sph).empty();
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

std::vector<std::string> terms_besides(const RunResult& one, const RunResult& other) {
  std::vector<std::string> terms;
  for (const std::string& term : one.active_terms)
    if (std::find(other.active_terms.begin(), other.active_terms.end(), term) ==
        other.active_terms.end())
      terms.push_back(term);
  return terms;
}

// Returns the terms that a run has added, left out or replaced against the unchanged run, and the
// terms that its changed numbers belong to.
std::string changed_terms(const AblationRun& one, const AblationRun* plain) {
  std::vector<std::string> texts;
  if (plain && plain->result && one.result) {
    const auto brought = terms_besides(*one.result, *plain->result);
    const auto left_out = terms_besides(*plain->result, *one.result);
    const std::string with = fmt::format("{}", fmt::join(brought, " and "));
    const std::string without = fmt::format("{}", fmt::join(left_out, " and "));
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

// Returns a measure of a fitted mode; empty where the mode was not fitted.
std::string mode_cell(const Comparison& comparison, const std::string& name,
                      Estimate ModeComparison::*measure, double scale) {
  for (const ModeComparison& mode : comparison.modes) {
    if (mode.mode != name) continue;
    if (!mode.resolved()) return "not resolved";
    const Estimate& estimate = mode.*measure;
    return interval_text({scale * estimate.value, scale * estimate.half_width});
  }
  return "";
}

// The first of several modes of a kind.
std::string first_mode(const Comparison& comparison, const std::string& kind) {
  for (const ModeComparison& mode : comparison.modes)
    if (mode.mode.starts_with(kind)) return mode.mode;
  return kind;
}

std::vector<std::string> error_cells(const AblationRun& one, const AblationRun* plain) {
  if (!one.comparison) return {"", "", "", "", "", "", ""};
  const Comparison& comparison = *one.comparison;
  const std::string forced = first_mode(comparison, "forced"),
                    natural = first_mode(comparison, "natural");
  const bool same_reference =
      plain && plain->comparison && plain->comparison->reference == comparison.reference;
  return {comparison.reference,
          fmt::format("{:.2f}", 100 * comparison.normalised_rms.value),
          same_reference
              ? ratio(comparison.normalised_rms.value, plain->comparison->normalised_rms.value)
              : "",
          mode_cell(comparison, forced, &ModeComparison::amplitude_error, 100),
          mode_cell(comparison, forced, &ModeComparison::phase_lag_degrees, 1),
          mode_cell(comparison, natural, &ModeComparison::frequency_error, 100),
          mode_cell(comparison, natural, &ModeComparison::decay_rate, 1)};
}

std::vector<std::string> cost_cells(const AblationRun& one, const AblationRun* plain,
                                    double duration) {
  if (!one.result) return {"", "", "", "", ""};
  const RunCost& cost = one.result->cost;
  const double time = one.result->cost.core_seconds();
  return {fmt::format("{:.2f}", time),
          plain && plain->result ? ratio(time, plain->result->cost.core_seconds()) : "",
          fmt::format("{}", cost.steps),
          fmt::format("{:.4g}", 1e6 * time / (cost.elements * duration)),
          fmt::format("{:.0f}", cost.peak_memory / cost.elements)};
}

}  // namespace

std::optional<reports::Table> ablation_table(const CaseAssessment& assessment) {
  const std::vector<AblationRun> runs = ablation_runs(assessment);
  const bool any_changed = std::any_of(runs.begin(), runs.end(), [](const AblationRun& one) {
    return !changes_of(*one.sph).empty();
  });
  const bool any_compared =
      std::any_of(runs.begin(), runs.end(), [](const AblationRun& one) { return one.comparison; });
  if (!any_changed || !any_compared) return std::nullopt;
  reports::Table table{
      case_id(assessment.definition.name) + "-choices",
      "Ablation: effect and cost of each change to a scheme",
      "The error of each SPH run against theory or a published record, and its cost. \"over "
      "unchanged\": ratio to the unchanged run of the same scheme and spacing. CPU time is user "
      "plus system time; peak memory is that of the whole process.",
      {"run", "scheme", "spacing [mm]", "change", "affected terms", "reference",
       "normalised rms [%]", "rms over unchanged", "forced amplitude error [%]", "forced lag [deg]",
       "natural frequency error [%]", "decay rate [1/s]", "CPU time [s]", "CPU time over unchanged",
       "steps", "CPU time [us per particle and simulated s]", "peak memory [byte per particle]"},
      {}};
  for (const AblationRun& one : runs) {
    const std::string changes = changes_of(*one.sph);
    const AblationRun* plain = changes.empty() ? nullptr : unchanged(runs, *one.sph);
    std::vector<std::string> row{one.run->name, one.sph->scheme, spacing_text(*one.sph),
                                 changes.empty() ? "unchanged" : changes,
                                 changed_terms(one, plain)};
    for (const auto& cells :
         {error_cells(one, plain), cost_cells(one, plain, assessment.definition.duration)})
      row.insert(row.end(), cells.begin(), cells.end());
    if (!one.result) row[5] = state_name(assessment.runs.status.at(one.run->name).state);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace slosh
