// Where a pressure gauge sits, be it on a wall of a rectangle or on an outline.
#pragma once

#include <utility>

#include "verification/case/case_definition.hpp"

namespace slosh {

// The middle of the sensor.
Corner sensor_middle(const TankDefinition& tank, const PressureGaugeDefinition& gauge);

// Its two ends, which are one place for a sensor without width.
std::pair<Corner, Corner> sensor_ends(const TankDefinition& tank,
                                      const PressureGaugeDefinition& gauge);

// Whether all of it lies under the still surface.
bool is_under_still_water(const CaseDefinition& definition, const PressureGaugeDefinition& gauge);

}  // namespace slosh
