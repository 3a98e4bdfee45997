// Particles of another program in the tank of a case: their places in the tank's frame, and whether
// they can be its liquid.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/import/particle_table.hpp"

namespace slosh {

// The frame of the positions. The origin of both is the tank's bottom left corner, in the earth's
// frame before the tank has moved.
enum class PositionsIn { tank, earth };

inline constexpr EnumName<PositionsIn> position_frame_names[] = {{PositionsIn::tank, "tank"},
                                                                 {PositionsIn::earth, "earth"}};

// Returns the particles with their places in the tank's frame, which the others below take.
std::vector<ParticlesAt> in_tank(std::vector<ParticlesAt> moments, PositionsIn frame,
                                 const CaseDefinition& definition);

// Throws CaseFileError, "file:line: ...", at the first particle that is more than a spacing outside
// of the rectangle of the tank.
void require_in_tank(const std::vector<ParticlesAt>& moments, double spacing,
                     const CaseDefinition& definition, const std::filesystem::path& file);

// Returns why the particles may not be all of the case's liquid and nothing else, a sentence each:
// at the first time their volume or their mean height is another, or the volume changes later. A
// particle without a volume has that of a cell of the lattice.
std::vector<std::string> doubts_of_liquid(const std::vector<ParticlesAt>& moments, double spacing,
                                          const CaseDefinition& definition);

}  // namespace slosh
