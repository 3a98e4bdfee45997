// What the runs of a case are compared on: the series that any of them may have.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// The first is the one that the case is about.
//   front_position                          [m] of a breaking dam
//   elevation@<gauge>                       [m] above the still level
//   wall_pressure@<gauge>                   [Pa]
//   wall_pressure@<gauge>/filtered          [Pa] of a gauge with a cutoff
//   force_x, force_z                        [N/m] of the liquid on the tank, per metre of width
//   moment                                  [N] of the liquid about the axis of a tank that rolls
//   momentum_x, momentum_z                  [kg/s] of the liquid
//   highest_surface@<gauge>                 [m] above the still level, of whatever is wet there
std::vector<std::string> compared_quantities(const CaseDefinition& definition);

// Of a compared quantity; throws std::invalid_argument for another.
std::string unit_of(const std::string& quantity);

// All names that a compared quantity may have, "GAUGE" for a gauge's.
std::vector<std::string> quantity_names();

// Whether linear theory's modes make up the quantity, so that they can be fitted to it: a front
// advances, and vertical force and momentum are of second order.
bool has_modes(const std::string& quantity);

// Whether a gauge of the case asks for it, so that a run without it is told of; the others are
// compared where both runs left them.
bool is_gauged(const std::string& quantity);

// The suffix of the series of potential flow that come from a run of fewer nodes.
inline constexpr const char* coarser = "/coarser";

}  // namespace slosh
