// Writes a tank as a case of the program that solves it.
#pragma once

#include <filesystem>

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// Fills in every file of the template directory that the tank's program reads, and writes it to the
// same place in the case directory, which must be absent or empty. In a tank with an outline it
// writes the mesh as well, as constant/polyMesh in place of blockMeshDict. Throws
// std::invalid_argument for an impossible tank and for a case directory that is not empty, and
// RunError for a template with an undefined name.
void write_case(const SloshingTank& tank, const std::filesystem::path& template_directory,
                const std::filesystem::path& case_directory);

}  // namespace slosh::openfoam
