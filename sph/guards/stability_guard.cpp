#include "sph/guards/stability_guard.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "sph/run_output.hpp"

namespace slosh::sph {
namespace {

constexpr double highest_density = 2, lowest_density = 0.2;  // of the rest density
constexpr double shortest_step = 1e-4;                       // of the longest

bool finite(const Particles& p, std::size_t i) {
  return std::isfinite(p.x[i] + p.z[i] + p.velocity_x[i] + p.velocity_z[i] + p.density[i]);
}

}  // namespace

void throw_bad_particle(const Particles& p, std::size_t i, double time, const char* cause) {
  throw SimulationError(
      fmt::format("particle {} is {} at t = {:.6g} s: position ({:.6g}, {:.6g}) m, velocity "
                  "({:.6g}, {:.6g}) m/s, "
                  "density {:.6g} kg/m3",
                  i, cause, time, p.x[i], p.z[i], p.velocity_x[i], p.velocity_z[i], p.density[i]));
}

void check_state(const Particles& p, double rest_density, double time) {
  const double lowest = lowest_density * rest_density, highest = highest_density * rest_density;
  // The loop takes plain pointers because its loads from the arrays would not be vectorised.
  const double *x = p.x.data(), *z = p.z.data(), *u = p.velocity_x.data(), *w = p.velocity_z.data(),
               *density = p.density.data();
  const std::size_t n = p.size();
  double unsound = 0;
#pragma omp parallel for simd schedule(static) reduction(+ : unsound)
  for (std::size_t i = 0; i < n; ++i) {
    const double out_of_range = density[i] >= lowest && density[i] <= highest ? 0.0 : 1.0;
    // A finite number times zero is zero; infinity or NaN times zero is NaN.
    unsound += out_of_range + 0.0 * (x[i] + z[i] + u[i] + w[i]);
  }
  if (unsound == 0) return;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!finite(p, i)) throw_bad_particle(p, i, time, "not finite");
    if (!(p.density[i] >= lowest && p.density[i] <= highest))
      throw_bad_particle(p, i, time, "out of the density range");
  }
}

void check_step(double step, double longest_step, const Particles& p, const Rates& rates,
                double time) {
  if (step >= shortest_step * longest_step) return;
  const auto acceleration = [&](std::size_t i) {
    return std::hypot(rates.acceleration_x[i], rates.acceleration_z[i]);
  };
  std::size_t fastest = 0;
  for (std::size_t i = 1; i < p.size(); ++i)
    if (!(acceleration(i) <= acceleration(fastest))) fastest = i;
  const std::string cause = fmt::format(
      "accelerated by {:.3g} m/s2, which asks for a time step of {:.3g} s, below a ten-thousandth "
      "of the longest of {:.3g} s,",
      acceleration(fastest), step, longest_step);
  throw_bad_particle(p, fastest, time, cause.c_str());
}

}  // namespace slosh::sph
