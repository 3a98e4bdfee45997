#include "reports/figures/paper_panels.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "reports/drawing/figure_layout.hpp"
#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/wording/case_text.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/papers/measured_values.hpp"

namespace slosh {
namespace {

using reports::Figure;

constexpr double round_off = 1e-9;  // [m]

// Returns the scheme's run at the paper's spacing, the same near the surface, or else `finest`.
std::string run_of_scheme(const CaseAssessment& assessment, const Paper& paper,
                          const std::string& finest, const std::string& quantity) {
  const CaseDefinition& definition = assessment.definition;
  const std::string scheme = family(run_named(definition, finest));
  for (const RunDefinition& run : definition.runs) {
    const auto* sph = std::get_if<SphRun>(&run.solver);
    if (sph && family(run) == scheme && !is_changed(run) &&
        std::abs(sph->particle_spacing - paper.particle_spacing_m) < round_off &&
        sph->surface_particle_spacing == sph->particle_spacing &&
        has_series(assessment.runs, run.name, quantity))
      return run.name;
  }
  return finest;
}

// The runs that a panel shows; none where no simulation has the quantity.
std::vector<std::string> shown_runs(const CaseAssessment& assessment, const Paper& paper,
                                    const std::string& quantity) {
  const CaseDefinition& definition = assessment.definition;
  std::vector<std::string> shown;
  bool has_theory = false, has_simulation = false;
  for (const std::string& name : finest_runs(assessment, quantity)) {
    const RunDefinition& run = run_named(definition, name);
    if (is_theory(run)) {
      if (!std::exchange(has_theory, true)) shown.push_back(name);
    } else if (const auto* record = std::get_if<RecordRun>(&run.solver)) {
      if (!record->earlier_run) shown.push_back(name);
    } else if (is_one_of(family(run), paper.schemes)) {
      shown.push_back(run_of_scheme(assessment, paper, name, quantity));
      has_simulation = true;
    } else if (family(run) == "recommended" || family(run) == "interFoam") {
      shown.push_back(name);
      has_simulation = true;
    }
  }
  return has_simulation ? shown : std::vector<std::string>{};
}

// One figure of a paper, as its panels are drawn from the cases of a campaign.
class Redrawing {
 public:
  Redrawing(const Paper& paper, const PaperFigure& figure) : paper_(paper), figure_(figure) {}

  // Adds the panels of one case. Fields are those of the sections that the report has.
  void add(const CaseAssessment& assessment, const std::vector<reports::Section>& written) {
    switch (figure_.redrawn) {
      case Redrawn::history:
      case Redrawn::spectrum:
        return add_drawn(assessment);
      case Redrawn::time_steps:
      case Redrawn::spacings:
        return add_studies(assessment);
      case Redrawn::fields:
        return add_fields(assessment, written);
      case Redrawn::not_at_all:
        return;
    }
  }

  // The panels, those of the same quantity with one vertical axis.
  std::vector<Figure> panels() {
    std::map<std::string, std::pair<double, double>> ranges;
    for (const auto& [quantity, figure] : panels_) {
      const reports::AxisRange range = reports::plot_ranges(figure).vertical;
      auto& [lower, upper] = ranges.try_emplace(quantity, range.lower, range.upper).first->second;
      lower = std::min(lower, range.lower);
      upper = std::max(upper, range.upper);
    }
    std::vector<Figure> all;
    for (auto& [quantity, figure] : panels_) {
      figure.y_range = ranges.at(quantity);
      std::ranges::move(in_panels(figure), std::back_inserter(all));
    }
    if (figure_.redrawn == Redrawn::history)
      for (Figure& panel : all) panel.caption += cut_off_text(panel);
    return all;
  }

  std::vector<std::string> anchors = {};  // of fields
  std::vector<std::string> missing = {};  // why panels are left out

 private:
  // "Li et al. 2010, figure 5. Highest surface", of which case where the figure has several.
  std::string title_of(const std::string& what, const CaseDefinition& definition) const {
    return fmt::format("{}, {}. {}{}", paper_.citation, figure_name(figure_.number), what,
                       figure_.cases.size() > 1 ? " (" + definition.title + ")" : "");
  }

  void add_panel(Figure panel, const std::string& id, const std::string& quantity,
                 const CaseDefinition& definition) {
    panel.id = fmt::format("{}-figure-{}-{}-{}", paper_.name, figure_.number, definition.name, id);
    std::ranges::replace(panel.id, ' ', '-');
    panel.title = title_of(panel.title, definition);
    if (!figure_.not_known.empty())
      panel.caption += fmt::format(" Of the paper's figure we do not know {}.", figure_.not_known);
    panels_.emplace_back(quantity, std::move(panel));
  }

  // Draws the time series of one quantity, the paper's span of it where that is known.
  Figure history(const CaseAssessment& assessment, const std::string& quantity,
                 const std::vector<std::string>& runs) const {
    const CaseDefinition& definition = assessment.definition;
    const ShownQuantity shown = shown_quantity(definition, quantity);
    const auto over_depth = figure_.without_dimensions ? axes_over_depth(definition, quantity)
                                                       : std::optional<HistoryAxes>{};
    const HistoryAxes axes = over_depth.value_or(axes_with_units(definition, quantity));
    const auto [begin, end] = figure_.time_span_s.first < figure_.time_span_s.second
                                  ? figure_.time_span_s
                                  : std::pair{0.0, definition.duration};
    Figure panel = histories(assessment, quantity, runs, axes);
    panel.title = shown.title;
    panel.x_range = {axes.scales.time * begin, axes.scales.time * end};
    panel.caption =
        axes.symbols + measured_how(shown, definition, runs) + who_is_who(definition, runs);
    return panel;
  }

  void add_drawn(const CaseAssessment& assessment) {
    const CaseDefinition& definition = assessment.definition;
    for (const std::string& quantity : figure_.quantities) {
      const std::vector<std::string> runs = shown_runs(assessment, paper_, quantity);
      Figure panel;
      if (!runs.empty())
        panel = figure_.redrawn == Redrawn::spectrum ? spectrum_figure(assessment, quantity, runs)
                                                     : history(assessment, quantity, runs);
      if (panel.curves.empty())
        missing.push_back(
            fmt::format("no simulation of {} has a result with {}", definition.name, quantity));
      else
        add_panel(std::move(panel), id_of(quantity), quantity, definition);
    }
  }

  void add_studies(const CaseAssessment& assessment) {
    const CaseDefinition& definition = assessment.definition;
    const std::string& quantity = figure_.quantities.front();
    const bool of_step = figure_.redrawn == Redrawn::time_steps;
    for (const std::string& scheme : paper_.schemes) {
      const std::vector<Figure> found = studies_of(
          assessment, of_step ? Studied::time_step : Studied::spacing, quantity, {scheme});
      for (std::size_t i = 0; i < found.size(); ++i)
        add_panel(found[i], scheme + (i > 0 ? fmt::format("-{}", i + 1) : ""), quantity,
                  definition);
      if (found.empty())
        missing.push_back(fmt::format("{} has no results of {} that differ in their {} alone",
                                      definition.name, scheme,
                                      of_step ? "time step" : "particle spacing"));
    }
  }

  void add_fields(const CaseAssessment& assessment, const std::vector<reports::Section>& written) {
    const std::string stem = case_id(assessment.definition.name) + "-fields-";
    const std::size_t before = anchors.size();
    for (const reports::Section& section : written)
      for (const reports::FieldFigure& field : section.fields)
        if (field.id.starts_with(stem)) anchors.push_back("figure-" + field.id);
    if (anchors.size() == before)
      missing.push_back("the report has no fields of " + assessment.definition.name);
  }

  const Paper& paper_;
  const PaperFigure& figure_;
  std::vector<std::pair<std::string, Figure>> panels_;  // by quantity
};

}  // namespace

PaperPanels paper_panels(const Paper& paper, const std::vector<CaseAssessment>& cases,
                         const std::vector<reports::Section>& written) {
  PaperPanels all;
  for (const PaperFigure& figure : paper.figures) {
    Redrawing redrawing(paper, figure);
    if (figure.redrawn == Redrawn::not_at_all)
      redrawing.missing.push_back("not known here: " + figure.not_known);
    std::vector<std::string> absent;
    for (const std::string& name : figure.cases) {
      if (const CaseAssessment* assessment = find_case(cases, name))
        redrawing.add(*assessment, written);
      else
        absent.push_back(name);
    }
    if (!absent.empty())
      redrawing.missing.push_back(
          fmt::format("not part of this campaign: {}", fmt::join(absent, ", ")));
    for (Figure& panel : redrawing.panels()) {
      redrawing.anchors.push_back("figure-" + panel.id);
      all.figures.push_back(std::move(panel));
    }
    all.redrawn.push_back({figure.number, redrawing.anchors, redrawing.missing});
  }
  return all;
}

}  // namespace slosh
