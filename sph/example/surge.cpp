// A small surge by the scheme `recommended`, compared with linear theory.
#include <cmath>
#include <cstdio>

#include "reference/linear_surge.hpp"
#include "sph/simulation.hpp"
#include "verification/metrics/comparison.hpp"

int main() {
  const double b = 0.02, omega = 1.5, dp = 0.025;          // [m], [rad/s], [m]
  const double gauge = 0.95;                               // [m] from the left wall
  const slosh::reference::Tank tank{1, 0.35, 9.81, 1000};  // length, depth [m], g, density
  const slosh::sph::Scene scene{
      .tank_length = tank.length,
      .tank_height = 1,
      .fill_depth = tank.fill_depth,
      .gravity = tank.gravity,
      .rest_density = tank.density,
      .displacement = [=](double t) { return b * std::sin(omega * t); },
      .velocity = [=](double t) { return b * omega * std::cos(omega * t); },
      .acceleration = [=](double t) { return -b * omega * omega * std::sin(omega * t); },
      .duration = 20,
      .sample_interval = 0.01,
      .particle_spacing = dp,
      .surface_particle_spacing = dp,
      .gauges = {{"right", gauge}}};
  const auto sph = slosh::sph::run("recommended", scene, {}).elevation.at("right");
  const slosh::reference::LinearSurge theory(tank, slosh::reference::Start::earth,
                                             slosh::reference::SineSurge{b, omega}, 500);
  const slosh::Comparison found =
      slosh::compare({"elevation", "m", sph.time, sph.value},
                     {"elevation", "m", sph.time,
                      theory.elevation(gauge - tank.length / 2, sph.time)},  // from the centre
                     {1, 20},
                     {{"forced", omega, false},
                      {"natural_1", slosh::reference::natural_frequency(tank, 1), true},
                      {"natural_3", slosh::reference::natural_frequency(tank, 3), true}});
  const slosh::Estimate error = found.modes[0].amplitude_error;
  std::printf("error of the forced amplitude: %.1f +- %.1f %%\n", 100 * error.value,
              100 * error.half_width);
}
