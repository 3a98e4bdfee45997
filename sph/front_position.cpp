#include "sph/front_position.hpp"

#include <algorithm>
#include <vector>

namespace slosh::sph {

double front_position(const Particles& p, double particle_spacing) {
  std::vector<double> lowest;  // from the left wall
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.z[i] < 2 * particle_spacing) lowest.push_back(p.x[i]);
  std::sort(lowest.begin(), lowest.end());
  // The wall counts as a particle's edge, half a spacing from where the particle would be.
  double last = -0.5 * particle_spacing;
  for (const double x : lowest) {
    if (x - last > 2 * particle_spacing) break;
    last = x;
  }
  return last + 0.5 * particle_spacing;
}

}  // namespace slosh::sph
