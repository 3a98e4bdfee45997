// A case as the theories of reference/ see it: the tank, the start, wall positions and sample
// times.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "reference/linear_surge.hpp"
#include "reference/potential_flow/nonlinear_potential_flow.hpp"
#include "reference/section/section.hpp"
#include "verification/case/case_definition.hpp"

namespace slosh {

inline reference::Tank tank_of(const CaseDefinition& definition) {
  return {definition.tank.length, definition.liquid.fill_depth, definition.gravity,
          definition.liquid.density};
}

// The gas up to the roof.
inline reference::Gas gas_of(const CaseDefinition& definition) {
  return {definition.gas.density, definition.tank.height - definition.liquid.fill_depth};
}

// The tank of any section, in its own coordinates.
inline reference::Section section_of(const CaseDefinition& definition) {
  reference::Section section{
      {}, definition.liquid.fill_depth, definition.gravity, definition.liquid.density};
  for (const Corner& corner : definition.tank.outline)
    section.outline.push_back({corner.x, corner.z});
  return section;
}

inline reference::Start start_of(const CaseDefinition& definition) {
  return definition.start == Start::earth ? reference::Start::earth : reference::Start::tank;
}

// Returns a position relative to the centre of the still surface. `along` is the distance from the
// bottom on a side wall, and from the left wall on the bottom and the roof [m].
inline reference::Observation::Place place_on_wall(const CaseDefinition& definition, Wall wall,
                                                   double along) {
  const double half = definition.tank.length / 2, depth = definition.liquid.fill_depth;
  switch (wall) {
    case Wall::left:
      return {-half, along - depth};
    case Wall::right:
      return {half, along - depth};
    case Wall::roof:
      return {along - half, definition.tank.height - depth};
    case Wall::bottom:
      break;
  }
  return {along - half, -depth};
}

// The same of a probe.
inline reference::Observation::Place place_of(const CaseDefinition& definition,
                                              const ProbeDefinition& probe) {
  return {probe.x - definition.tank.length / 2, probe.z - definition.liquid.fill_depth};
}

// Returns the times 0, interval, ... up to and including the duration, within round-off [s].
inline std::vector<double> sample_times(const CaseDefinition& definition) {
  const double intervals = definition.duration / definition.sample_interval;
  std::vector<double> times(static_cast<std::size_t>(intervals * (1 + 1e-12)) + 1);
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = i * definition.sample_interval;
  return times;
}

inline double largest_magnitude(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace slosh
