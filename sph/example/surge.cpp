// A small surge by the scheme `recommended`, compared with linear theory.
#include <cmath>
#include <cstdio>

#include "reference/linear_surge.hpp"
#include "sph/simulation.hpp"
#include "verification/metrics/comparison.hpp"

int main() {
  const double b = 0.02, omega = 3, dp = 0.025;  // [m], [rad/s], [m]
  const slosh::sph::Scene scene{
      .tank_length = 1,
      .tank_height = 1,
      .fill_depth = 0.35,
      .gravity = 9.81,
      .rest_density = 1000,
      .displacement = [=](double t) { return b * std::sin(omega * t); },
      .velocity = [=](double t) { return b * omega * std::cos(omega * t); },
      .acceleration = [=](double t) { return -b * omega * omega * std::sin(omega * t); },
      .duration = 8,
      .sample_interval = 0.01,
      .particle_spacing = dp,
      .surface_particle_spacing = dp,
      .gauges = {{"right", 0.95}}};
  const auto sph = slosh::sph::run("recommended", scene, {}).elevation.at("right");
  const slosh::reference::LinearSurge theory({1, 0.35, 9.81, 1000}, slosh::reference::Start::earth,
                                             slosh::reference::SineSurge{b, omega}, 500);
  const slosh::Comparison found =
      slosh::compare({"elevation", "m", sph.time, sph.value},
                     {"elevation", "m", sph.time, theory.elevation(0.45, sph.time)}, {1, 8},
                     {{"forced", omega, false}, {"natural_1", 4.966, true}});
  const slosh::Estimate error = found.modes[0].amplitude_error;
  std::printf("error of the forced amplitude: %.1f +- %.1f %%\n", 100 * error.value,
              100 * error.half_width);
}
