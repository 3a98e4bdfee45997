// GenCase's definition of a case (NAME_Def.xml) for DualSPHysics 5.4.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

struct DualSphysicsSettings {
  double spacing;                 // [m], of which the tank's length, the liquid and the obstacles
                                  // are whole multiples
  std::string acceleration_file;  // beside the case that GenCase makes; empty: none
};

// Returns the text: modified dynamic walls of three layers with their normals, and the gauges of
// the case, fixed in the tank.
std::string dualsphysics_definition(const CaseDefinition& definition,
                                    const DualSphysicsSettings& settings);

// Returns the height [m] of the roof: the place between rows of the lattice nearest to the case's.
double dualsphysics_roof(const CaseDefinition& definition, double spacing);

// Returns what the gauges measure, in the files that DualSPHysics leaves.
std::vector<SeriesSource> dualsphysics_series(const CaseDefinition& definition);

// DualSPHysics's coefh and the smoothing length in two dimensions, coefh sqrt(2) spacings.
inline constexpr double dualsphysics_coefh = 1.2;

}  // namespace slosh
