// A case as the driver of another code reads it: a JSON file in SI units, whose names hold the
// units. The motion is a table, so that a driver needs none of the case file's forms of motion.
#pragma once

#include <filesystem>
#include <string>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the directory of the drivers that Slosh ships.
std::filesystem::path peers_directory();

// Whether the file has a place for all of the case: a rectangular tank without obstacles that does
// not roll, filled from wall to wall.
bool fits_tank_file(const CaseDefinition& definition);

// Returns the text of the file: the tank, the liquid, the initial wave (of the amplitude 0 where
// there is none), the surge, the gauges of the surface, and the times. The surge is the tank's
// acceleration X''(t) at the times of motion_table.hpp, and the liquid's first velocity in the
// tank's frame, -X'(0) of a start in the earth's frame. Throws std::invalid_argument for a case
// that does not fit it.
std::string tank_file(const CaseDefinition& definition);

}  // namespace slosh
