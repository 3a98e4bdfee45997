// The values of all names in the case's templates, as text in the shortest form that reads back as
// the same double.
#pragma once

#include <kainjow/mustache.hpp>

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// Throws std::invalid_argument for a motion that is not finite.
kainjow::mustache::data template_values(const SloshingTank& tank);

}  // namespace slosh::openfoam
