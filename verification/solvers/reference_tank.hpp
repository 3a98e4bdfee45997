// What every theory is told of a case and when it is asked, and the size of what it answers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "reference/linear_surge.hpp"
#include "reference/nonlinear_potential_flow.hpp"
#include "verification/case/case_definition.hpp"

namespace slosh {

inline reference::Tank tank_of(const CaseDefinition& definition) {
  return {definition.tank.length, definition.liquid.fill_depth, definition.gravity,
          definition.liquid.density};
}

inline reference::Start start_of(const CaseDefinition& definition) {
  return definition.start == Start::earth ? reference::Start::earth : reference::Start::tank;
}

// `along` a side wall from the bottom, along the bottom from the left wall [m]; the place is from
// the centre of the still surface.
inline reference::Observation::Place place_on_wall(const CaseDefinition& definition, Wall wall,
                                                   double along) {
  const double half = definition.tank.length / 2, depth = definition.liquid.fill_depth;
  switch (wall) {
    case Wall::left:
      return {-half, along - depth};
    case Wall::right:
      return {half, along - depth};
    case Wall::bottom:
      break;
  }
  return {along - half, -depth};
}

// 0, interval, ..., up to and including the duration (but for a rounding error) [s].
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
