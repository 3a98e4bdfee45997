#include "reports/figures/paper_panels.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "reports/drawing/axes.hpp"
#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_panels.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/model/is_one_of.hpp"
#include "reports/wording/report_places.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/papers/measured_values.hpp"

namespace slosh {
namespace {

using reports::Figure;

constexpr double round_off = 1e-9;  // [m]

struct Panel {
  Figure figure;
  std::string quantity;
};

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

// "Li et al. 2010, figure 5. Highest surface", of which case where the figure has several.
std::string title_of(const Paper& paper, const PaperFigure& figure, const std::string& what,
                     const CaseDefinition& definition) {
  return fmt::format("{}, {}. {}{}", paper.citation, figure_name(figure.number), what,
                     figure.cases.size() > 1 ? " (" + definition.title + ")" : "");
}

std::string id_stem(const Paper& paper, const PaperFigure& figure, const std::string& case_name) {
  std::string number = figure.number;
  std::replace(number.begin(), number.end(), ' ', '-');
  return fmt::format("{}-figure-{}-{}", paper.name, number, case_name);
}

std::string not_known_text(const PaperFigure& figure) {
  return figure.not_known.empty()
             ? ""
             : fmt::format(" Of the paper's figure we do not know {}.", figure.not_known);
}

// Draws the time series, or the spectrum, of one quantity; without a curve where none can be.
Figure drawn(const CaseAssessment& assessment, const Paper& paper, const PaperFigure& figure,
             const std::string& quantity) {
  const CaseDefinition& definition = assessment.definition;
  const std::vector<std::string> runs = shown_runs(assessment, paper, quantity);
  if (runs.empty()) return {};
  Figure panel;
  if (figure.redrawn == Redrawn::spectrum) {
    panel = spectrum_figure(assessment, quantity, runs);
    panel.title = title_of(paper, figure, panel.title, definition);
  } else {
    const ShownQuantity shown = shown_quantity(definition, quantity);
    const auto over_depth = figure.without_dimensions ? axes_over_depth(definition, quantity)
                                                      : std::optional<HistoryAxes>{};
    const HistoryAxes axes = over_depth.value_or(axes_with_units(definition, quantity));
    const auto [begin, end] = figure.time_span_s.first < figure.time_span_s.second
                                  ? figure.time_span_s
                                  : std::pair{0.0, definition.duration};
    panel.title = title_of(paper, figure, shown.title, definition);
    panel.x_label = axes.x_label;
    panel.y_label = axes.y_label;
    panel.x_range = {axes.scales.time * begin, axes.scales.time * end};
    for (const std::string& run : runs)
      panel.curves.push_back(history_curve(assessment, run, quantity, axes.scales));
    panel.caption =
        axes.symbols + measured_how(shown, definition, runs) + who_is_who(definition, runs);
  }
  panel.id = id_stem(paper, figure, definition.name) + "-" + id_of(quantity);
  panel.caption += not_known_text(figure);
  return panel;
}

// Gives the panels of the same quantity one vertical axis.
void share_axes(std::vector<Panel>& panels) {
  std::map<std::string, std::pair<double, double>> ranges;
  for (const Panel& panel : panels) {
    const reports::AxisRange range = reports::plot_ranges(panel.figure).vertical;
    const auto [place, is_new] = ranges.try_emplace(panel.quantity, range.lower, range.upper);
    if (is_new) continue;
    place->second.first = std::min(place->second.first, range.lower);
    place->second.second = std::max(place->second.second, range.upper);
  }
  for (Panel& panel : panels) panel.figure.y_range = ranges.at(panel.quantity);
}

void add_studies(const CaseAssessment& assessment, const Paper& paper, const PaperFigure& figure,
                 std::vector<Panel>& panels, RedrawnFigure& redrawn) {
  const std::string quantity = figure.quantities.front(),
                    stem = id_stem(paper, figure, assessment.definition.name);
  const bool of_step = figure.redrawn == Redrawn::time_steps;
  for (const std::string& scheme : paper.schemes) {
    std::vector<Figure> found =
        studies_of(assessment, of_step ? Studied::time_step : Studied::spacing, quantity, {scheme});
    for (std::size_t i = 0; i < found.size(); ++i) {
      Figure& panel = found[i];
      panel.id = stem + "-" + scheme + (i > 0 ? fmt::format("-{}", i + 1) : "");
      panel.title = title_of(paper, figure, panel.title, assessment.definition);
      panel.caption += not_known_text(figure);
      panels.push_back({std::move(panel), quantity});
    }
    if (found.empty())
      redrawn.missing.push_back(fmt::format("{} has no results of {} that differ in their {} alone",
                                            assessment.definition.name, scheme,
                                            of_step ? "time step" : "particle spacing"));
  }
}

void add_drawn(const CaseAssessment& assessment, const Paper& paper, const PaperFigure& figure,
               std::vector<Panel>& panels, RedrawnFigure& redrawn) {
  for (const std::string& quantity : figure.quantities) {
    Figure panel = drawn(assessment, paper, figure, quantity);
    if (panel.curves.empty())
      redrawn.missing.push_back(fmt::format("no simulation of {} has a result with {}",
                                            assessment.definition.name, quantity));
    else
      panels.push_back({std::move(panel), quantity});
  }
}

void add_fields(const CaseAssessment& assessment, const std::vector<reports::Section>& written,
                RedrawnFigure& redrawn) {
  const std::string stem = case_id(assessment.definition.name) + "-fields-";
  const std::size_t before = redrawn.anchors.size();
  for (const reports::Section& section : written)
    for (const reports::FieldFigure& field : section.fields)
      if (field.id.starts_with(stem)) redrawn.anchors.push_back("figure-" + field.id);
  if (redrawn.anchors.size() == before)
    redrawn.missing.push_back("the report has no fields of " + assessment.definition.name);
}

// Adds the panels of one case to those of the figure.
void add_case(const CaseAssessment& assessment, const Paper& paper, const PaperFigure& figure,
              const std::vector<reports::Section>& written, std::vector<Panel>& panels,
              RedrawnFigure& redrawn) {
  switch (figure.redrawn) {
    case Redrawn::history:
    case Redrawn::spectrum:
      return add_drawn(assessment, paper, figure, panels, redrawn);
    case Redrawn::time_steps:
    case Redrawn::spacings:
      return add_studies(assessment, paper, figure, panels, redrawn);
    case Redrawn::fields:
      return add_fields(assessment, written, redrawn);
    case Redrawn::not_at_all:
      return;
  }
}

}  // namespace

PaperPanels paper_panels(const Paper& paper, const std::vector<CaseAssessment>& cases,
                         const std::vector<reports::Section>& written) {
  PaperPanels all;
  for (const PaperFigure& figure : paper.figures) {
    RedrawnFigure redrawn{.number = figure.number};
    if (figure.redrawn == Redrawn::not_at_all)
      redrawn.missing.emplace_back(fmt::format("not known here: {}", figure.not_known));
    std::vector<Panel> panels;
    std::vector<std::string> absent;
    for (const std::string& name : figure.cases) {
      if (const CaseAssessment* assessment = find_case(cases, name))
        add_case(*assessment, paper, figure, written, panels, redrawn);
      else
        absent.push_back(name);
    }
    if (!absent.empty())
      redrawn.missing.push_back(
          fmt::format("not part of this campaign: {}", fmt::join(absent, ", ")));
    share_axes(panels);
    for (const Panel& whole : panels)
      for (Figure& part : in_panels(whole.figure)) {
        if (figure.redrawn == Redrawn::history) part.caption += cut_off_text(part);
        redrawn.anchors.push_back("figure-" + part.id);
        all.figures.push_back(std::move(part));
      }
    all.redrawn.push_back(std::move(redrawn));
  }
  return all;
}

}  // namespace slosh
