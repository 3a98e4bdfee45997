// What surface tension would change, which no solver here has. It is judged with 0.073 N/m, that of
// clean water in air; other liquids have less.
// - Wave: it raises the square of a frequency by k^2 sigma / (rho g) (Lamb, article 267).
// - Gap: the capillary pressure of the meniscus between the gap walls differs by at
//   most 2 sigma / b between a rising and a falling surface, whose contact angles differ. That is a
//   solid friction of sigma / b per area of the surface (Viola, Brun & Gallaire 2018). In a period
//   it takes (8 / pi) (sigma / b) A of a standing wave's energy rho g A^2 / 4, and so
//   (8 / pi) (2 sigma / b) / (rho g A) of its amplitude A.
// - Impact: it acts on a drop or sheet of the size L with the pressure sigma / L, which is the
//   inverse of the Weber number rho V^2 L / sigma of the impact's rho V^2. L is the particle
//   spacing or the cell: no run has anything smaller, and on all that is larger, the gap included,
//   surface tension has less effect.
#pragma once

#include <vector>

#include "verification/assessment/doubts/model_limit.hpp"
#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns, of those that apply:
// - the change of the first natural frequency, where there is gravity
// - the capillary pressure across the gap, where the case gives its breadth and the liquid moves
// - the capillary pressure in an impact, of the finest run, where liquid may strike a sensor
std::vector<ModelLimit> surface_tension_limits(const CaseDefinition& definition);

}  // namespace slosh
