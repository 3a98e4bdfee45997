// The one place that knows the natural frequencies of a case's tank: the comparison fits these
// modes, and the page, the doubts and the theories' ranges name them.
#pragma once

#include <map>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// The share of the first natural frequency that a theory may leave out to the gas, and of the first
// wave to viscosity.
inline constexpr double most_left_out = 0.005;

// Returns the frequencies of the tank's first `count` modes [rad/s], lowest first, by linear theory
// of still water without gas. In a rectangle the mode n has n half waves between the walls. There
// are none without gravity, nor where no theory of the tank's shape is known.
std::vector<double> natural_frequencies(const CaseDefinition& definition, int count);

// Returns those of the liquid under the case's gas, by two-layer theory. Valid for a rectangle with
// gravity.
std::vector<double> two_layer_frequencies(const CaseDefinition& definition, int count);

// Returns the share by which the gas above the liquid lowers the first of these frequencies, by
// two-layer theory of a rectangle as long as the still surface. Valid with gravity.
double share_lost_to_gas(const CaseDefinition& definition);

// Returns those of the modes that natural_modes() of quantities.hpp names, by their numbers.
std::map<int, double> excited_frequencies(const CaseDefinition& definition, int count);

}  // namespace slosh
