// Stability map: density diffusion delta over the Courant number. The diffusion is explicit, and on
// the lattice shares the step's limit with the sound.
#include "sph/schemes.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/problems/stability_map.hpp"

namespace slosh {
namespace {

ProblemOutcome run(bool quick) {
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

Problem diffusion_map_problem() {
  return {"diffusion_map",
          "Stability: density diffusion and Courant number",
          "The same wave with delta from none to beyond its limit, at several Courant numbers.",
          lattice_source,
          "The largest delta at which no wave of the square lattice grows.",
          map_measures("dt c0 / h"),
          &run,
          15};
}

}  // namespace slosh
