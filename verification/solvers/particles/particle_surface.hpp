// One measurement of the surface for the particles of every program: the depth of liquid over a
// gauge and the highest particle near it, by the functions that measure our own runs
// (sph/recording/free_surface.hpp).
#pragma once

#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/import/particle_table.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

// The frame of the positions. The origin of both is the tank's bottom left corner, in the earth's
// frame before the tank has moved.
enum class PositionsIn { tank, earth };

inline constexpr EnumName<PositionsIn> position_frame_names[] = {{PositionsIn::tank, "tank"},
                                                                 {PositionsIn::earth, "earth"}};

struct ParticleMeaning {
  PositionsIn frame = PositionsIn::tank;
  double spacing;  // [m], of the lattice from which the particles started
};

// Returns elevation@GAUGE and highest_surface@GAUGE for each gauge of the case. A particle without
// a volume has that of a cell of the lattice.
std::vector<TimeSeries> surface_series(const std::vector<ParticlesAt>& moments,
                                       const ParticleMeaning& of, const CaseDefinition& definition);

}  // namespace slosh
