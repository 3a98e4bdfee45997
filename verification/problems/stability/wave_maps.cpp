// Stability maps of a free wave with `recommended`.
//   courant_map    The Courant number dt c0 / h over the speed of sound. The limit of a linear wave
//                  on the initial lattice does not depend on c0; the softer the liquid, the more
//                  the free surface and the moving particles change it.
//   gamma_map      The Courant number over the exponent gamma of the equation of state,
//                  p = rho_0 c0^2 / gamma ((rho / rho_0)^gamma - 1), where gamma = 1 is the linear
//                  one. The linear limit does not depend on gamma: sound in a compressed liquid is
//                  faster by (rho / rho_0)^((gamma - 1) / 2), one per cent at a Mach number of 0.1.
//   diffusion_map  The density diffusion delta over the Courant number. The diffusion is explicit,
//                  and on the lattice it shares the limit of the step with the sound.
#include <cmath>
#include <string>

#include "sph/schemes.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/problems/stability/stability_map.hpp"

namespace slosh {
namespace {

double courant_number_of_recommended(double) {
  return sph::Recommended::numbers.courant_number.value();
}

std::function<double(double)> lattice_limit() {
  return [limit = stable_courant_number(lattice_of_recommended())](double) { return limit; };
}

ProblemOutcome run_courant_map(bool quick) {
  const StabilityMap map{
      .id = "courant_map",
      .title = "Stable Courant numbers over the speed of sound",
      .caption = "`recommended`, a free wave, 4000 steps each.",
      .across = {"dt c0 / h", {0.4, 0.8, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.8, 2.0}},
      .up = {"c0 / V_max", quick ? std::vector<double>{5, 10, 20, 50, 200}
                                 : std::vector<double>{5, 7, 10, 14, 20, 30, 50, 100, 200}},
      .probe =
          [](double courant_number, double sound_speed_ratio) {
            sph::SchemeNumbers numbers = sph::recommended_at(courant_number);
            numbers.sound_speed_ratio = sound_speed_ratio;
            return probe_of_wave(wave_scene(numbers, steps_of_probe));
          },
      .theory = lattice_limit(),
      .log_up = true};
  return outcome_of(map, courant_number_of_recommended);
}

std::string variant_of(double gamma) {
  const auto whole = std::lround(gamma);
  return whole == 7 ? "" : whole == 1 ? "linear_state" : "gamma_" + std::to_string(whole);
}

ProblemOutcome run_gamma_map(bool) {
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
      .theory = lattice_limit()};
  return outcome_of(map, courant_number_of_recommended);
}

ProblemOutcome run_diffusion_map(bool quick) {
  const StabilityMap map{
      .id = "diffusion_map",
      .title = "Stable density diffusion over the Courant number",
      .caption = "`recommended` at c0 / V_max = 20, a free wave, 4000 steps each.",
      .across = {"delta", {0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.6, 0.8}},
      .up = {"dt c0 / h", quick ? std::vector<double>{0.4, 0.8, 1.2}
                                : std::vector<double>{0.4, 0.6, 0.8, 1.0, 1.2}},
      .probe =
          [](double delta, double courant_number) {
            sph::SchemeNumbers numbers = sph::recommended_at(courant_number);
            numbers.sound_speed_ratio = 20;
            numbers.density_diffusion = delta;
            return probe_of_wave(wave_scene(numbers, steps_of_probe));
          },
      .theory =
          [](double courant_number) {
            return stable_diffusion(lattice_of_recommended(), courant_number);
          }};
  return outcome_of(map,
                    [](double) { return sph::Recommended::numbers.density_diffusion.value(); });
}

}  // namespace

Problem courant_map_problem() {
  return {
      "courant_map",
      "Stability: Courant number and speed of sound",
      "A free wave of 0.04 m in 1 m of water 0.4 m deep, at 40 mm, 4000 steps of every Courant "
      "number at every speed of sound from 5 to 200 times the fastest wave's.",
      lattice_source,
      "The largest dt c0 / h at which no wave of the square lattice grows under the scheme's own "
      "gradient, divergence, diffusion and viscosity.",
      map_measures("c0 / V_max"),
      &run_courant_map,
      20};
}

Problem gamma_map_problem() {
  return {"gamma_map",
          "Stability: exponent of the equation of state",
          "The same wave with gamma = 1 (the linear equation of state), 3, 5 and 7.",
          lattice_source,
          "The linear limit, which does not depend on gamma.",
          map_measures("gamma"),
          &run_gamma_map,
          10};
}

Problem diffusion_map_problem() {
  return {"diffusion_map",
          "Stability: density diffusion and Courant number",
          "The same wave with delta from none to beyond its limit, at several Courant numbers.",
          lattice_source,
          "The largest delta at which no wave of the square lattice grows.",
          map_measures("dt c0 / h"),
          &run_diffusion_map,
          15};
}

}  // namespace slosh
