// The parts of case_figures.hpp, one a kind of figure. Each leaves out a figure for which no run
// has the data.
#pragma once

#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// The roll and the surge of a tank that rolls.
std::vector<reports::Figure> motion_figures(const CaseAssessment& assessment);

// The history of every compared quantity: of the one that the case is about, and of the others.
std::vector<reports::Figure> main_history(const CaseAssessment& assessment);
std::vector<reports::Figure> other_histories(const CaseAssessment& assessment);

// Candidates less their references, with the tolerance band.
std::vector<reports::Figure> residual_figures(const CaseAssessment& assessment);

// Amplitude ratio and phase lag of the first mode over windows that slide along.
std::vector<reports::Figure> sliding_figures(const CaseAssessment& assessment);

// Complex amplitudes over their references', a figure a mode.
std::vector<reports::Figure> phasor_figures(const CaseAssessment& assessment);

// Of the elevation and of the highest surface at each gauge, else of what the case is about.
std::vector<reports::Figure> spectrum_figures(const CaseAssessment& assessment);

// SPH runs of one scheme that differ in their time step or in their spacing alone.
std::vector<reports::Figure> study_figures(const CaseAssessment& assessment);

// Error against spacing, with the order and its band.
std::vector<reports::Figure> convergence_figures(const CaseAssessment& assessment);

// Where an SPH run's energy comes from and goes to.
std::vector<reports::Figure> energy_figures(const CaseAssessment& assessment);

// Error against run time, and against memory.
std::vector<reports::Figure> cost_figures(const CaseAssessment& assessment);

}  // namespace slosh
