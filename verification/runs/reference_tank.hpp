// What every theory is told of a case, and when it is asked.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/linear_surge.hpp"
#include "verification/case_file/case_definition.hpp"

namespace slosh {

inline reference::Tank tank_of(const CaseDefinition& definition) {
  return {definition.tank.length, definition.liquid.fill_depth, definition.gravity,
          definition.liquid.density};
}

// 0, interval, ..., up to and including the duration (but for a rounding error) [s].
inline std::vector<double> sample_times(const CaseDefinition& definition) {
  const double intervals = definition.duration / definition.sample_interval;
  std::vector<double> times(static_cast<std::size_t>(intervals * (1 + 1e-12)) + 1);
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = i * definition.sample_interval;
  return times;
}

}  // namespace slosh
