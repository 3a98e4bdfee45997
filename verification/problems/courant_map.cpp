// Stability map: the Courant number dt c0 / h over the speed of sound. The limit of a linear wave
// on the start's lattice does not know c0; the softer the liquid, the more the free surface and the
// moving particles change it.
#include "sph/schemes.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/problems/stability_map.hpp"

namespace slosh {
namespace {

ProblemOutcome run(bool quick) {
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
      .theory = [limit = stable_courant_number(lattice_of_recommended())](double) { return limit; },
      .log_up = true};
  return outcome_of(map, [](double) { return sph::Recommended::numbers.courant_number.value(); });
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
      &run,
      20};
}

}  // namespace slosh
