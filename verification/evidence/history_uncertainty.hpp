// The numerical uncertainty of a whole time history, from runs of its case that differ in one
// number alone, as Celik, Ghia, Roache & Freitas 2008 (J. Fluids Eng. 130, 078001, section 2.2)
// draw error bars on a profile: all instants have one order, and each instant has its own
// difference. With f1, f2, f3 at steps h1 < h2 < h3, where f1 is the run's own history, and rms
// over its samples,
//   p from rms(f2 - f1) and rms(f3 - f2) (three_grid_order.hpp), limited to 0.5 to 2
//   U(t) = F |f2(t) - f1(t)| / ((h2 / h1)^p - 1)
// F = 1.25 where p was 0.5 to 2.1 and 3 elsewhere, as in discretisation_uncertainty.hpp. For two
// runs alone U = 3 |f2 - f1| / min(1, h2 / h1 - 1) (refinement.hpp); for potential flow U is the
// difference from its own coarser run. Paths combine as the root of the sum of squares. Where two
// histories cross, U is small by accident.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {

// The half widths of the 95 % intervals at the samples of the run's series [the series' unit]; NaN
// at samples that the potential flow with fewer nodes does not reach. Empty where neither a
// refinement path nor a coarser run exists.
std::vector<double> numerical_half_widths(const CaseDefinition& definition, const CaseRuns& runs,
                                          const std::string& run, const std::string& quantity);

}  // namespace slosh
