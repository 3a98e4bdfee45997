// Stability maps of `recommended`. Three are of a free wave.
//   courant_map    The Courant number dt c0 / h over the speed of sound. The limit of a linear wave
//                  on the initial lattice is that of the sound at the bottom, which is the faster
//                  than c0 the softer the liquid is.
//   gamma_map      The Courant number over the exponent gamma of the equation of state,
//                  p = rho_0 c0^2 / gamma ((rho / rho_0)^gamma - 1), where gamma = 1 is the linear
//                  one. The limit hardly depends on gamma: at c0 = 20 V_max the sound at the
//                  bottom is at most 0.8 % faster than c0.
//   diffusion_map  The density diffusion delta over the Courant number. The diffusion is explicit,
//                  and on the lattice it shares the limit of the step with the sound.
//   viscosity_map  The liquid's viscosity over the particle spacing, with the step that the Courant
//                  number alone would give, for the explicit viscous limit. The particles of a full
//                  box without gravity start with random velocities; with a stable step they come
//                  to rest. The scheme's own step (sph/terms/time_step.hpp) has a viscous
//                  criterion, which `shipped` compares with the limit.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "sph/schemes.hpp"
#include "verification/problems/flow.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/problems/stability/stability_map.hpp"

namespace slosh {
namespace {

// Returns the speed of sound at the bottom of still water over c0, where c0^2 is `ratio`^2 g h:
// (rho / rho_0)^((gamma - 1) / 2) with (rho / rho_0)^gamma = 1 + gamma g h / c0^2.
double sound_at_bottom(double ratio, double gamma) {
  return std::pow(1 + gamma / (ratio * ratio), (gamma - 1) / (2 * gamma));
}

// Returns dt c0 / h of the calm liquid, whose step follows the sound at the bottom
// (sph/run.cpp).
double courant_number_of_recommended(double ratio, double gamma) {
  return sph::Recommended::numbers.courant_number.value() / sound_at_bottom(ratio, gamma);
}

double lattice_limit(double ratio, double gamma) {
  static const double limit = stable_courant_number(lattice_of_recommended());
  return limit / sound_at_bottom(ratio, gamma);
}

constexpr double exponent_of_recommended = 7, ratio_of_gamma_map = 20;

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
      .theory = [](double ratio) { return lattice_limit(ratio, exponent_of_recommended); },
      .log_up = true};
  return outcome_of(map, [](double ratio) {
    return courant_number_of_recommended(ratio, exponent_of_recommended);
  });
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
            numbers.sound_speed_ratio = ratio_of_gamma_map;
            sph::Scene scene = wave_scene(numbers, steps_of_probe);
            scene.variant = variant_of(gamma);
            return probe_of_wave(scene);
          },
      .theory = [](double gamma) { return lattice_limit(ratio_of_gamma_map, gamma); }};
  return outcome_of(
      map, [](double gamma) { return courant_number_of_recommended(ratio_of_gamma_map, gamma); });
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

using LaminarChoice = sph::WithLaminarViscosity;
constexpr double courant_number_in_box = 0.4, sound_in_box = 10;  // [m/s]

double smoothing_length(double spacing) {
  return LaminarChoice::numbers.smoothing_length_ratio.value() * spacing;
}

Probe probe_of_box(double viscosity, double spacing) try {
  const Box box{.length = 16 * spacing,
                .height = 16 * spacing,
                .spacing = spacing,
                .speed_of_sound = sound_in_box,
                .viscosity = viscosity};
  sph::Particles particles = full_lattice(box);
  set_random_velocities(particles, 1e-3 * sound_in_box);
  Flow<LaminarChoice> flow(box, std::move(particles));
  const double start = kinetic_energy(flow.liquid.particles),
               step = courant_number_in_box * smoothing_length(spacing) / sound_in_box;
  for (int i = 0; i < 1000; ++i) {
    flow.step(step);
    sph::check_state(flow.liquid.particles, box.rest_density, flow.liquid.time);
  }
  const double grown = kinetic_energy(flow.liquid.particles) / start;
  if (grown <= 1) return {Stability::stable, ""};
  return {Stability::unstable, fmt::format("kinetic energy {:.3g} times that of the start", grown)};
} catch (const sph::SimulationError& error) {
  return {Stability::unstable, error.what()};
}

ProblemOutcome run_viscosity_map(bool) {
  std::vector<double> viscosities;
  for (int i = 0; i <= 16; ++i) viscosities.push_back(0.003 * std::pow(2, 0.5 * i));
  const LatticeScheme lattice{&gradient_shape_of<LaminarChoice::Kernel>,
                              LaminarChoice::numbers.smoothing_length_ratio.value(), 0,
                              LaminarChoice::numbers.density_diffusion.value()};
  const double limit = stable_viscosity(lattice, courant_number_in_box);  // nu / (h c0)
  const StabilityMap map{
      .id = "viscosity_map",
      .title = "Stable viscosities over the particle spacing",
      .caption = "Laminar viscosity, dt c0 / h = 0.4, c0 = 10 m/s, 1000 steps each.",
      .across = {"nu (m2/s)", viscosities},
      .up = {"dp (m)", {0.01, 0.02, 0.04, 0.08}},
      .probe = &probe_of_box,
      .theory =
          [limit](double spacing) { return limit * smoothing_length(spacing) * sound_in_box; },
      .log_across = true,
      .log_up = true};
  return outcome_of(
      map,
      [](double spacing) {
        return sph::AdaptiveStep::viscous_number * smoothing_length(spacing) * sound_in_box /
               courant_number_in_box;
      },
      Guarded::no);
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
      "gradient, divergence, diffusion and viscosity, with the speed of sound at the bottom.",
      map_measures("c0 / V_max"),
      &run_courant_map,
      20};
}

Problem gamma_map_problem() {
  return {"gamma_map",
          "Stability: exponent of the equation of state",
          "The same wave with gamma = 1 (the linear equation of state), 3, 5 and 7.",
          lattice_source,
          "The linear limit with the speed of sound at the bottom.",
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

Problem viscosity_map_problem() {
  return {
      "viscosity_map",
      "Stability: viscosity and particle spacing",
      "A full box of 16 x 16 particles with random velocities of c0 / 1000, 1000 steps of dt c0 / "
      "h = 0.4, without the scheme's own viscous criterion.",
      "Morris, Fox & Zhu 1997, J. Comput. Phys. 136:214, eq. 21, for the criterion; the "
      "staggered leapfrog's amplification factor on the lattice for the limit",
      "The largest nu dt / h^2 at which no wave of the square lattice grows; the literature's "
      "criterion is 0.125, this solver's 0.0625.",
      map_measures("dp (m)", Guarded::no),
      &run_viscosity_map,
      5};
}

}  // namespace slosh
