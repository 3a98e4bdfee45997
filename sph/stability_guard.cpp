#include "sph/stability_guard.hpp"

#include <fmt/format.h>

#include <cmath>

#include "sph/simulation.hpp"

namespace slosh::sph {

void throw_bad_particle(const Particles& p, std::size_t i, double time, const char* cause) {
  throw SimulationError(
      fmt::format("particle {} is {} at t = {:.6g} s: position ({:.6g}, {:.6g}) m, velocity "
                  "({:.6g}, {:.6g}) m/s, "
                  "density {:.6g} kg/m3",
                  i, cause, time, p.x[i], p.z[i], p.velocity_x[i], p.velocity_z[i], p.density[i]));
}

void check_state(const Particles& p, double rest_density, double time) {
  constexpr double highest = 2, lowest = 0.2;  // of the rest density
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!std::isfinite(p.x[i] + p.z[i] + p.velocity_x[i] + p.velocity_z[i] + p.density[i]))
      throw_bad_particle(p, i, time, "not finite");
    if (!(p.density[i] <= highest * rest_density && p.density[i] >= lowest * rest_density))
      throw_bad_particle(p, i, time, "out of the density range");
  }
}

}  // namespace slosh::sph
