// What follows from the shape of a case's tank, be it a rectangle or an outline: its corners, where
// its still surface reaches, and how much liquid it holds.
#pragma once

#include "verification/case/shape/outline.hpp"

namespace slosh {

inline bool is_rectangle(const TankDefinition& tank) { return tank.outline.empty(); }

// The corners of either shape, counter-clockwise.
Outline corners_of(const TankDefinition& tank);

// Where the still surface of the filled tank reaches; a dam about to break counts as spread over
// the tank's length.
Extent still_surface(const CaseDefinition& definition);

// [m2], of the liquid's section at the start.
double liquid_area(const CaseDefinition& definition);

// The tank's motion excites every mode of a section, but of a symmetric one only every second mode,
// which is antisymmetric: the first, the third, ... Returns 1 or 2.
int excited_mode_step(const TankDefinition& tank);

}  // namespace slosh
