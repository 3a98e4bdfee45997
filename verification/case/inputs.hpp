// The inputs that a case may declare uncertain, by name and unit.
#pragma once

#include <string>

#include "verification/case/case_definition.hpp"

namespace slosh {

std::string input_name(Input input);  // as in the case file: "fill_depth"

// "m", "s", "m" of a surge's amplitude and "deg" of a roll's, "kg/m3", "m2/s", "m/s2"
std::string input_unit(Input input, const MotionDefinition& motion);

}  // namespace slosh
