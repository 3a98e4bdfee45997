// Which runs of a case a figure shows, how each is drawn, and what captions call it.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

template <class Name, class List>
bool is_one_of(const Name& name, const List& names) {
  return std::ranges::find(names, name) != names.end();
}

// Returns the finest run of each family whose result fulfils `has`, or has the series, in the order
// of the case file. A run that changes something of its scheme is taken only where the family has
// no other, then the one with the fewest changes.
std::vector<std::string> finest_runs(const CaseAssessment& assessment,
                                     const std::function<bool(const RunResult&)>& has);
std::vector<std::string> finest_runs(const CaseAssessment& assessment, const std::string& quantity);

// Whether the run is no reference outside its declared range.
bool is_in_range(const CaseAssessment& assessment, const std::string& run);

// Returns the run's name, with a remark where the run is out of its range.
std::string run_label(const CaseAssessment& assessment, const std::string& run);

// Factors from the units of a series to those of a figure.
struct AxisScales {
  double time = 1, value = 1;
};

// How the history of a quantity stands on its axes.
struct HistoryAxes {
  AxisScales scales;
  std::string x_label, y_label;
  std::string symbols = {};  // what those of the labels stand for: "h = 0.35 m, T = 1.3 s. "
};

// In seconds and in the unit in which figures show the quantity.
HistoryAxes axes_with_units(const CaseDefinition& definition, const std::string& quantity);

// Time over the forcing's period, and a height over the still depth. Returns nullopt where the
// motion has no period or the quantity is no such height.
std::optional<HistoryAxes> axes_over_depth(const CaseDefinition& definition,
                                           const std::string& quantity);

// Shows a record of few samples as points, a longer record and any other run as a line; a record
// has its uncertainty, and a reference out of its range sets no scale. The run must have the
// series.
reports::Curve history_curve(const CaseAssessment& assessment, const std::string& run,
                             const std::string& quantity, const AxisScales& scales);

// The histories of the runs on these axes, without id and words.
reports::Figure histories(const CaseAssessment& assessment, const std::string& quantity,
                          const std::vector<std::string>& runs, const HistoryAxes& axes);

// Adds bars to points and a ribbon to a line; half widths are in the curve's unit, and `what` is
// the legend's name of the ribbon. Throws std::invalid_argument unless there is one for each
// sample.
void set_uncertainty(reports::Curve& curve, const std::vector<double>& half_widths,
                     const std::string& what);

// Adds a band of tolerance; `band` has the name of its candidate. Candidates with the same
// tolerance share one, which has no look.
void add_tolerance_band(reports::Band band, reports::Figure& figure);

// Takes the scale from a run whose size is more than four times the median of the figure's runs,
// where there are three or more: one bad model shall not hide how the others differ.
void let_most_set_scale(reports::Figure& figure,
                        const std::function<double(const reports::Curve&)>& size);

// Returns the largest distance of the curve from a level.
double farthest_from(double level, const reports::Curve& curve);

// Names the curves that set no scale and leave the frame of the others, and what they reach: a
// sentence with a blank before it, or "".
std::string cut_off_text(const reports::Figure& figure);

// Returns the judging comparison of the finest run of each scheme and solver.
std::vector<const Comparison*> shown_comparisons(const CaseAssessment& assessment);

// Returns the times outside the comparison window that no row on the quantity looks at either, for
// a time axis.
std::vector<reports::Span> outside_window(const CaseDefinition& definition,
                                          const std::string& quantity, double time_scale = 1);

// Returns "recommended_10mm: SPH, scheme recommended, 10 mm; ..." and, where a record has an
// uncertainty, the meaning of its bars. The text ends with a full stop.
std::string who_is_who(const CaseDefinition& definition, const std::vector<std::string>& runs);

// The colour, the marker and the dash of each run: the one place that assigns them, for all figures
// of all pages. Theory and records are black and grey. Each SPH scheme, each of OpenFOAM's programs
// and each method of another code has a hue and a marker, and shares at most one of the two with
// another (up to 60 of them); the runs of one family differ in marker and dash, the finest
// unchanged run first.
reports::Look look_of(const CaseDefinition& definition, const std::string& run);

// The look of the family's finest unchanged run. A refinement path, whose name is no family's, is
// one of meshes: it looks as interFoam does.
reports::Look look_of_family(const CaseDefinition& definition, const std::string& family);

// The look of the models of several cases, each a family, or a family and what its runs change:
// "recommended", "recommended, h = 2 dp".
std::vector<reports::Look> looks_of_models(const std::vector<std::string>& models);

// Lines that help the eye and are no run's: tolerances, guides, the front of the best runs.
inline reports::Look guide_look(std::size_t number) { return {true, 1, number}; }

}  // namespace slosh
