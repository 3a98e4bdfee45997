// One measurement of the surface for the particles of every program: the depth of liquid over a
// gauge and the highest particle near it, by the functions that measure our own runs
// (sph/recording/free_surface.hpp).
#pragma once

#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/import/particle_table.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

// Returns elevation@GAUGE and highest_surface@GAUGE for each gauge of the case, of particles in the
// tank's frame that started from a lattice of that spacing [m]. A particle without a volume has
// that of a cell of the lattice.
std::vector<TimeSeries> surface_series(const std::vector<ParticlesAt>& moments, double spacing,
                                       const CaseDefinition& definition);

}  // namespace slosh
