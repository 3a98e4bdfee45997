// Stability map: the liquid's viscosity over the particle spacing, with the step that the Courant
// number alone would give, for the explicit viscous limit. The particles of a full box without
// gravity start with random velocities; with a stable step they come to rest. The scheme's own step
// (sph/terms/time_step.hpp) has a viscous criterion, which `shipped` compares with the limit.
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "sph/schemes.hpp"
#include "verification/problems/flow.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/problems/stability/lattice_buckling.hpp"
#include "verification/problems/stability/stability_map.hpp"

namespace slosh {
namespace {

using Choice = sph::WithLaminarViscosity;
constexpr double courant_number = 0.4, sound = 10;  // [m/s]

double smoothing_length(double spacing) {
  return Choice::numbers.smoothing_length_ratio.value() * spacing;
}

sph::Particles disturbed(const Box& box) {
  sph::Particles p = full_lattice(box);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> speed(-1e-3 * sound, 1e-3 * sound);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.velocity_x[i] = speed(random);
    p.velocity_z[i] = speed(random);
  }
  return p;
}

Probe probe(double viscosity, double spacing) try {
  const Box box{.length = 16 * spacing,
                .height = 16 * spacing,
                .spacing = spacing,
                .speed_of_sound = sound,
                .viscosity = viscosity};
  Flow<Choice> flow(box, disturbed(box));
  const double start = kinetic_energy(flow.liquid.particles),
               step = courant_number * smoothing_length(spacing) / sound;
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

ProblemOutcome run(bool) {
  std::vector<double> viscosities;
  for (int i = 0; i <= 16; ++i) viscosities.push_back(0.003 * std::pow(2, 0.5 * i));
  const LatticeScheme lattice{&gradient_shape_of<Choice::Kernel>,
                              Choice::numbers.smoothing_length_ratio.value(), 0,
                              Choice::numbers.density_diffusion.value()};
  const double limit = stable_viscosity(lattice, courant_number);  // nu / (h c0)
  const StabilityMap map{
      .id = "viscosity_map",
      .title = "Stable viscosities over the particle spacing",
      .caption = "Laminar viscosity, dt c0 / h = 0.4, c0 = 10 m/s, 1000 steps each.",
      .across = {"nu (m2/s)", viscosities},
      .up = {"dp (m)", {0.01, 0.02, 0.04, 0.08}},
      .probe = &probe,
      .theory = [limit](double spacing) { return limit * smoothing_length(spacing) * sound; },
      .log_across = true,
      .log_up = true};
  return outcome_of(
      map,
      [](double spacing) {
        return sph::AdaptiveStep::viscous_number * smoothing_length(spacing) * sound /
               courant_number;
      },
      Guarded::no);
}

}  // namespace

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
      &run,
      5};
}

}  // namespace slosh
