// How a scheme's result depends on its time step and on its particle spacing: runs that differ in
// one of them only, side by side.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/wording/case_text.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"

namespace slosh {
namespace {

using reports::Figure;

// Returns the filtered pressure where the case has one, else its first quantity.
std::string studied_quantity(const CaseDefinition& definition) {
  const std::vector<std::string> quantities = compared_quantities(definition);
  const auto filtered = std::find_if(quantities.begin(), quantities.end(), is_filtered);
  return filtered == quantities.end() ? quantities.front() : *filtered;
}

// What the runs of a study have in common.
struct Common {
  std::string scheme, changes;
  double spacing = 0;        // [m], 0 where it is what is studied
  double surface_ratio = 1;  // spacing near the surface over that inside, to six digits
  auto operator<=>(const Common&) const = default;
};

// An external program's method is a scheme here. Nothing is known of its time step.
Common common(const RunDefinition& run, Studied studied) {
  const double spacing = studied == Studied::spacing ? 0 : *particle_spacing(run);
  if (!std::holds_alternative<SphRun>(run.solver)) return {family(run), "", spacing};
  SphRun sph = std::get<SphRun>(run.solver);
  if (studied == Studied::time_step) sph.numbers.courant_number.reset();
  return {sph.scheme, changes_of(sph), spacing,
          std::round(1e6 * sph.surface_particle_spacing / sph.particle_spacing) / 1e6};
}

bool can_be_studied(const RunDefinition& run, Studied studied) {
  return studied == Studied::spacing ? particle_spacing(run).has_value()
                                     : std::holds_alternative<SphRun>(run.solver);
}

// Returns the studied value of a run; infinite for the scheme's own Courant number, so that it
// comes first.
double value_of(const RunDefinition& run, Studied studied) {
  return studied == Studied::spacing
             ? *particle_spacing(run)
             : std::get<SphRun>(run.solver)
                   .numbers.courant_number.value_or(std::numeric_limits<double>::infinity());
}

std::string value_text(const RunDefinition& run, Studied studied) {
  const double value = value_of(run, studied);
  if (studied == Studied::spacing) return fmt::format("{:.4g} mm", 1000 * value);
  return std::isfinite(value) ? fmt::format("Courant number {:g}", value)
                              : "the scheme's Courant number";
}

using Study = std::vector<const RunDefinition*>;

// Returns the studies of two or more values, in the order of their first runs; the finest run is
// last.
std::vector<Study> studies(const CaseAssessment& assessment, const std::string& quantity,
                           Studied studied) {
  std::vector<Study> found;
  std::map<Common, std::size_t> places;
  for (const RunDefinition& run : assessment.definition.runs) {
    if (!can_be_studied(run, studied) || is_later_member(run) ||
        !has_series(assessment.runs, run.name, quantity))
      continue;
    const auto [place, is_new] = places.try_emplace(common(run, studied), found.size());
    if (is_new) found.emplace_back();
    found[place->second].push_back(&run);
  }
  const auto value = [&](const RunDefinition* run) { return value_of(*run, studied); };
  std::erase_if(found, [&](const Study& runs) {
    std::set<double> values;
    for (const RunDefinition* run : runs) values.insert(value(run));
    return values.size() < 2;
  });
  for (Study& runs : found)
    std::stable_sort(runs.begin(), runs.end(),
                     [&](const auto* a, const auto* b) { return value(a) > value(b); });
  return found;
}

// Returns what all runs of the study share besides the scheme.
std::string shared_text(const Common& same) {
  std::vector<std::string> parts;
  if (same.spacing > 0) parts.push_back(fmt::format("{:.4g} mm", 1000 * same.spacing));
  if (same.surface_ratio != 1)
    parts.push_back(fmt::format("{:.4g} of the spacing at the surface", same.surface_ratio));
  if (!same.changes.empty()) parts.push_back(same.changes);
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<std::string> records(const CaseAssessment& assessment, const std::string& quantity) {
  std::vector<std::string> names = finest_runs(assessment, quantity);
  std::erase_if(names, [&](const std::string& name) {
    return !is_record(run_named(assessment.definition, name));
  });
  return names;
}

Figure study_figure(const CaseAssessment& assessment, const std::string& quantity, Studied studied,
                    const Study& runs) {
  const CaseDefinition& definition = assessment.definition;
  const ShownQuantity shown = shown_quantity(definition, quantity);
  std::vector<std::string> names = records(assessment, quantity);
  const std::size_t recorded = names.size();
  for (const RunDefinition* run : runs) names.push_back(run->name);
  Figure figure = histories(assessment, quantity, names, axes_with_units(definition, quantity));
  figure.x_range = {0, definition.duration};
  figure.caption = fmt::format(
      "{}. Runs of one scheme or method that differ only in their {}. {}{} {}.", shown.title,
      studied == Studied::time_step ? "time step" : "particle spacing",
      measured_how(shown, definition, names), who_is_who(definition, names), definition.source);
  for (std::size_t i = 0; i < runs.size(); ++i)
    figure.curves[recorded + i].label =
        fmt::format("{} ({})", value_text(*runs[i], studied), runs[i]->name);
  figure.caption += cut_off_text(figure);
  return figure;
}

}  // namespace

std::vector<Figure> studies_of(const CaseAssessment& assessment, Studied studied,
                               const std::string& quantity,
                               const std::vector<std::string>& schemes) {
  std::vector<Study> found = studies(assessment, quantity, studied);
  std::erase_if(found, [&](const Study& runs) {
    return !schemes.empty() && !is_one_of(family(*runs.front()), schemes);
  });
  const bool of_step = studied == Studied::time_step;
  std::map<std::string, int> of_scheme, numbers;
  for (const Study& runs : found) ++of_scheme[family(*runs.front())];
  std::vector<Figure> figures;
  for (const Study& runs : found) {
    const std::string scheme = family(*runs.front());
    Figure figure = study_figure(assessment, quantity, studied, runs);
    figure.id = case_id(assessment.definition.name) + (of_step ? "-time_step-" : "-spacing-") +
                name_id(scheme);
    figure.title = (of_step ? "Time step: " : "Particle spacing: ") + scheme;
    if (of_scheme[scheme] > 1) {
      figure.id += fmt::format("-{}", ++numbers[scheme]);
      if (const std::string shared = shared_text(common(*runs.front(), studied)); !shared.empty())
        figure.title += ", " + shared;
    }
    figures.push_back(std::move(figure));
  }
  return figures;
}

std::vector<Figure> study_figures(const CaseAssessment& assessment) {
  const std::string quantity = studied_quantity(assessment.definition);
  std::vector<Figure> figures;
  for (const Studied studied : {Studied::time_step, Studied::spacing})
    for (Figure& figure : studies_of(assessment, studied, quantity))
      figures.push_back(std::move(figure));
  return figures;
}

}  // namespace slosh
