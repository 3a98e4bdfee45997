// The numerical uncertainty of a whole time history, from runs of its case that are alike but for
// one number, as Celik, Ghia, Roache & Freitas 2008 (J. Fluids Eng. 130, 078001, section 2.2) draw
// error bars on a profile: one order for all instants, the difference of each instant its own. With
// f1, f2, f3 at steps h1 < h2 < h3, the run's own first, and rms over its samples,
//   p from rms(f2 - f1) and rms(f3 - f2) (three_grid_order.hpp), brought into 0.5 to 2
//   U(t) = F |f2(t) - f1(t)| / ((h2 / h1)^p - 1)
// F = 1.25 where p was 0.5 to 2.1 and 3 elsewhere, as discretisation_uncertainty.hpp. Of two runs
// alone U = 3 |f2 - f1| / min(1, h2 / h1 - 1) (refinement.hpp), and of potential flow what its own
// coarser run differs by. Paths add as the root of the sum of squares. Where two histories cross, U
// is small by accident.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {

// Half widths of 95 % intervals [the series' unit] at the samples of the run's series, NaN at those
// that potential flow of fewer nodes does not reach; empty where nothing tells them.
std::vector<double> numerical_half_widths(const CaseDefinition& definition, const CaseRuns& runs,
                                          const std::string& run, const std::string& quantity);

}  // namespace slosh
