// The figures of one case's section of a report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// Returns the figures of the case's own page, and those of its appendix. A figure without a run to
// show is left out.
std::vector<reports::Figure> case_figures(const CaseAssessment& assessment);
std::vector<reports::Figure> appendix_figures(const CaseAssessment& assessment);

// Returns the time series alone, of runs that were not judged. References beyond their range are
// marked and pressures are filtered as in a report.
std::vector<reports::Figure> case_histories(const CaseDefinition& definition, CaseRuns runs);

// Returns pressure and velocity at the case's snapshot times, one row for each time and one column
// for each solver or scheme, and last the case's animation, if two or more of its
// moments were recorded.
std::vector<reports::FieldFigure> case_fields(const CaseAssessment& assessment);

// Returns the time series of the first quantity, or of the impacts' pressure, as one of a
// campaign's small multiples: the first reference inside its range, or else any reference; the
// finest SPH run or external program; and the finest interFoam run. Of several schemes it is that
// of `candidate`, the run that decides the case, or else the first. A series of many periods is
// shown over the last ones of the comparison window. Returns nullopt where no run has the quantity.
std::optional<reports::Figure> glance_figure(const CaseAssessment& assessment,
                                             const std::string& candidate = "");

inline constexpr std::size_t most_curves = 6;  // as many as there are hues

// Returns the figure itself if it has at most six curves; otherwise figures of at most six with the
// same axes, each with all references and guides, as far as there is room for a run beside them.
// The first one keeps the id.
std::vector<reports::Figure> in_panels(const reports::Figure& figure);

// The kinds of figures that these combine. Each omits figures for which no run has data.

// The tank to scale: outline, liquid at the start, gauges, sensors, probes, the axis of a roll, and
// the tank where it is farthest from its start.
reports::Figure tank_figure(const CaseDefinition& definition);

// Position, speed and acceleration of the tank over time, each with its largest magnitude.
std::vector<reports::Figure> motion_figures(const CaseDefinition& definition);

// The time series of the quantities that the case's gate rows judge (figures 1 to 3 of Li et al.
// 2010), its first one where there are no rows, and those of its other compared quantities (figures
// 5 and 6 there).
std::vector<reports::Figure> main_histories(const CaseAssessment& assessment);
std::vector<reports::Figure> other_histories(const CaseAssessment& assessment);

// The distributions of the peaks of impacts, of repeated runs beside the experiment's repeats.
std::vector<reports::Figure> impact_figures(const CaseAssessment& assessment);

// Candidate minus reference, with the tolerance band.
std::vector<reports::Figure> residual_figures(const CaseAssessment& assessment);

// Amplitude ratio and phase lag of the first fitted mode over sliding windows.
std::vector<reports::Figure> sliding_figures(const CaseAssessment& assessment);

// Ratio of complex amplitudes, candidate over reference: one figure for each mode.
std::vector<reports::Figure> phasor_figures(const CaseAssessment& assessment);

// Spectra of the elevation and of the highest surface at each gauge, and of the first quantity
// (figure 7 there).
std::vector<reports::Figure> spectrum_figures(const CaseAssessment& assessment);

// The spectra of the runs in one quantity; without a curve where none has one.
reports::Figure spectrum_figure(const CaseAssessment& assessment, const std::string& quantity,
                                const std::vector<std::string>& candidates);

// SPH runs of one scheme that differ only in their time step or only in their spacing (figures 10
// and 11 of Zhao et al. 2021): on the filtered pressure where the case has one, else on its first
// quantity.
std::vector<reports::Figure> study_figures(const CaseAssessment& assessment);

// The same of one kind and on one quantity: of these schemes, or of all where none is named.
enum class Studied { time_step, spacing };
std::vector<reports::Figure> studies_of(const CaseAssessment& assessment, Studied studied,
                                        const std::string& quantity,
                                        const std::vector<std::string>& schemes = {});

// Error against spacing, with the fitted order and its 95 % band.
std::vector<reports::Figure> convergence_figures(const CaseAssessment& assessment);

// The energy budget of an SPH run.
std::vector<reports::Figure> energy_figures(const CaseAssessment& assessment);

// Error against run time, where speed_figure() does not show it, and against memory.
std::vector<reports::Figure> cost_figures(const CaseAssessment& assessment);

// Error against run time of a case with a speed at equal error (speed_ups.hpp), for the campaign's
// first page; nullopt of any other.
std::optional<reports::Figure> speed_figure(const CaseAssessment& assessment);

}  // namespace slosh
