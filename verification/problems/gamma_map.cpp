// Stability map: the Courant number over the exponent gamma of the equation of state,
// p = rho_0 c0^2 / gamma ((rho / rho_0)^gamma - 1), gamma = 1 being the linear one. The linear
// limit does not know gamma: a compressed liquid's sound is faster by ((rho / rho_0)^((gamma - 1) /
// 2)), a per cent where the Mach number is 0.1.
#include <cmath>
#include <string>

#include "sph/schemes.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/problems/stability_map.hpp"

namespace slosh {
namespace {

std::string variant_of(double gamma) {
  const auto whole = std::lround(gamma);
  return whole == 7 ? "" : whole == 1 ? "linear_state" : "gamma_" + std::to_string(whole);
}

ProblemOutcome run(bool) {
  const StabilityMap map{
      .id = "gamma_map",
      .title = "Stable Courant numbers over the exponent of the equation of state",
      .caption = "`recommended` at c0 / V_max = 20, a free wave, 4000 steps each.",
      .across = {"dt c0 / h", {0.8, 1.0, 1.2, 1.3, 1.4, 1.5, 1.6, 1.8, 2.0}},
      .up = {"gamma", {1, 3, 5, 7}},
      .probe =
          [](double courant_number, double gamma) {
            sph::SchemeNumbers numbers = sph::recommended_at(courant_number);
            numbers.sound_speed_ratio = 20;
            sph::Scene scene = wave_scene(numbers, steps_of_probe);
            scene.variant = variant_of(gamma);
            return probe_of_wave(scene);
          },
      .theory = [limit =
                     stable_courant_number(lattice_of_recommended())](double) { return limit; }};
  return outcome_of(map, [](double) { return sph::Recommended::numbers.courant_number.value(); });
}

}  // namespace

Problem gamma_map_problem() {
  return {"gamma_map",
          "Stability: exponent of the equation of state",
          "The same wave with gamma = 1 (the linear equation of state), 3, 5 and 7.",
          lattice_source,
          "The linear limit, which does not depend on gamma.",
          map_measures("gamma"),
          &run,
          10};
}

}  // namespace slosh
