#include "openfoam_cases/geometry/start_disturbance.hpp"

#include <random>

namespace slosh::openfoam {

// The distributions of <random> differ from one standard library to another, its engines do not.
InitialWave start_disturbance(double largest, unsigned seed) {
  constexpr unsigned modes = 8;
  std::mt19937 generator(seed);
  const unsigned mode = 1 + static_cast<unsigned>(generator() % modes);
  const double size = 0.5 + 0.5 * static_cast<double>(generator()) / std::mt19937::max();
  const double sign = generator() % 2 == 0 ? 1 : -1;
  return {static_cast<int>(mode), sign * size * largest};
}

}  // namespace slosh::openfoam
