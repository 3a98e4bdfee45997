#include "verification/assessment/doubts/model_limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "verification/case/motion.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/solvers/particles/artificial_viscosity.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

using std::numbers::pi;

// What repeats of an experiment differ by hides a loss of less.
constexpr double seen_loss = 0.02;
constexpr const char* of_amplitude = "of the wave's amplitude in each period";

// A friction layer of fewer particles is not resolved (docs/schemes.md).
constexpr double layer_in_particles = 3;
// With a layer 2.9 wall cells thick the wave of run_walls_test.cpp in openfoam_cases decays as
// theory says.
constexpr double layer_in_cells = 3;

constexpr double surface_tension = 0.073;        // [N/m], clean water in air
constexpr double atmospheric_pressure = 101325;  // [Pa]

// The frequency with which the liquid moves [rad/s], or none.
std::optional<double> frequency_of(const CaseDefinition& definition) {
  if (const double forced = forcing_frequency(definition); forced > 0) return forced;
  const std::vector<double> natural = natural_frequencies(definition, 1);
  if (natural.empty()) return {};
  return natural.front();
}

// The thickness of a Stokes layer [m].
double layer_of(const CaseDefinition& definition, double frequency) {
  return std::sqrt(2 * definition.liquid.kinematic_viscosity / frequency);
}

// The names of the runs that the test holds for.
template <class Test>
std::vector<std::string> runs_with(const CaseDefinition& definition, const Test& test) {
  std::vector<std::string> names;
  for (const RunDefinition& run : definition.runs)
    if (test(run)) names.push_back(run.name);
  return names;
}

// Returns the thickness of the cells beside the walls [m].
double wall_cell(const InterFoamRun& mesh, const TankDefinition& tank) {
  return mesh.wall_cell.value_or(std::max(tank.length / mesh.cells_x, tank.height / mesh.cells_z));
}

bool sticks(const RunDefinition& run) {
  if (const auto* mesh = std::get_if<InterFoamRun>(&run.solver)) return mesh->no_slip;
  const auto* sph = std::get_if<SphRun>(&run.solver);
  return sph && (sph->variant.starts_with("no_slip") || sph->scheme == "li2010" ||
                 sph->scheme.starts_with("zhao2021"));
}

std::string of_runs(const std::vector<std::string>& runs) {
  constexpr std::size_t told = 3;
  const std::vector<std::string> first(
      runs.begin(), runs.begin() + static_cast<std::ptrdiff_t>(std::min(told, runs.size())));
  return fmt::format("{}{}", fmt::join(first, ", "),
                     runs.size() > told ? fmt::format(" and {} more", runs.size() - told) : "");
}

// A Stokes layer on the bottom of a shallow liquid takes (pi / 2) delta / h of the amplitude in a
// period: half of sqrt(nu omega / 2) rho U^2 / 2 per area over rho h U^2 / 2.
void limit_friction(const CaseDefinition& definition, double layer,
                    std::vector<ModelLimit>& limits) {
  const double loss = pi / 2 * layer / definition.liquid.fill_depth;
  const char* source = "Keulegan 1959, J. Fluid Mech. 6:33";
  const auto slipping = runs_with(definition, [](const RunDefinition& run) {
    return solver_kind(run).solves_flow && !sticks(run);
  });
  if (!slipping.empty())
    limits.push_back({fmt::format("the friction at walls, with layers {:.2g} mm thick, along which "
                                  "the liquid slips in {}",
                                  1e3 * layer, of_runs(slipping)),
                      loss, seen_loss, of_amplitude, source});
  const auto coarse_meshes = runs_with(definition, [&](const RunDefinition& run) {
    const auto* mesh = std::get_if<InterFoamRun>(&run.solver);
    return mesh && mesh->no_slip && layer < layer_in_cells * wall_cell(*mesh, definition.tank);
  });
  const auto coarse = runs_with(definition, [&](const RunDefinition& run) {
    const auto* sph = std::get_if<SphRun>(&run.solver);
    return sph && sph->variant.starts_with("no_slip") &&
           layer < layer_in_particles * sph->particle_spacing;
  });
  const auto add_unresolved = [&](const char* than, const std::vector<std::string>& runs) {
    if (!runs.empty())
      limits.push_back({fmt::format("the friction at walls, in layers {:.2g} mm thick, which is "
                                    "less than three {} of {}",
                                    1e3 * layer, than, of_runs(runs)),
                        loss, seen_loss, of_amplitude, source});
  };
  add_unresolved("cells beside the walls", coarse_meshes);
  add_unresolved("particles", coarse);
}

// The same of the front and the back wall: pi delta / b.
void limit_breadth(const CaseDefinition& definition, double layer,
                   std::vector<ModelLimit>& limits) {
  if (definition.tank.breadth) return;
  limits.push_back({fmt::format("the friction of the front and the back wall, of a tank as broad "
                                "as long; it is beyond its limit in one narrower than {:.2g} m",
                                pi * layer / seen_loss),
                    pi * layer / definition.tank.length, seen_loss, of_amplitude,
                    "Landau & Lifshitz 1987, section 24"});
}

// A viscosity nu takes 2 nu k^2 of the first mode's amplitude in a second; the artificial one is
// alpha h c0 / 8.
void limit_artificial_viscosity(const CaseDefinition& definition, double frequency,
                                std::vector<ModelLimit>& limits) {
  double worst = 0;
  std::string of;
  const double wave_number = pi / still_surface(definition).length();
  for (const RunDefinition& run : definition.runs) {
    const auto* sph = std::get_if<SphRun>(&run.solver);
    if (!sph) continue;
    const double viscosity = artificial_viscosity(definition, *sph);
    const double loss = 2 * viscosity * wave_number * wave_number * 2 * pi / frequency;
    if (loss <= worst) continue;
    worst = loss;
    of = fmt::format("the artificial viscosity that {} sets, about {:.2g} m2/s", run.name,
                     viscosity);
  }
  if (!of.empty())
    limits.push_back({of, worst, seen_loss, of_amplitude,
                      "Lamb, Hydrodynamics, article 348; Monaghan 2005, section 8.5"});
}

// Surface tension raises the square of a frequency by k^2 sigma / (rho g).
void limit_surface_tension(const CaseDefinition& definition, std::vector<ModelLimit>& limits) {
  if (definition.gravity == 0) return;
  const double k = pi / still_surface(definition).length();
  limits.push_back(
      {"surface tension, of 0.073 N/m",
       0.5 * k * k * surface_tension / (definition.liquid.density * definition.gravity), 0.001,
       "of the first natural frequency", "Lamb, Hydrodynamics, article 267"});
}

// A pocket of air is compressed by about the impact's pressure over its own.
void limit_air(const CaseDefinition& definition, std::vector<ModelLimit>& limits) {
  if (!definition.impacts || definition.impacts->peak_means.empty()) return;
  const double peak = *std::max_element(definition.impacts->peak_means.begin(),
                                        definition.impacts->peak_means.end());
  limits.push_back({"the compression of trapped air by the declared impacts",
                    peak / atmospheric_pressure, 0.1, "of the pressure of the atmosphere",
                    "Bagnold 1939; Dias & Ghidaglia 2018, Annu. Rev. Fluid Mech. 50:243"});
}

// The density differs by the square of the Mach number.
void limit_compressibility(const CaseDefinition& definition, std::vector<ModelLimit>& limits) {
  const auto soft = runs_with(definition, [](const RunDefinition& run) {
    const auto* sph = std::get_if<SphRun>(&run.solver);
    return sph && sph->numbers.sound_speed_ratio;
  });
  double lowest = 0;
  for (const std::string& name : soft) {
    const double ratio =
        *std::get<SphRun>(run_named(definition, name).solver).numbers.sound_speed_ratio;
    lowest = lowest == 0 ? ratio : std::min(lowest, ratio);
  }
  if (!soft.empty())
    limits.push_back({"the compressibility of the liquid in " + of_runs(soft),
                      1 / (lowest * lowest), 0.01 * (1 + 1e-9), "of the density",
                      "Monaghan 1994, J. Comput. Phys. 110:399"});
}

std::string percent(double share) { return fmt::format("{:.2g} %", 100 * share); }

}  // namespace

std::vector<ModelLimit> model_limits(const CaseDefinition& definition) {
  std::vector<ModelLimit> limits;
  if (const std::optional<double> frequency = frequency_of(definition)) {
    const double layer = layer_of(definition, *frequency);
    limit_friction(definition, layer, limits);
    limit_breadth(definition, layer, limits);
    limit_artificial_viscosity(definition, *frequency, limits);
  }
  limit_surface_tension(definition, limits);
  limit_air(definition, limits);
  limit_compressibility(definition, limits);
  return limits;
}

std::string limit_text(const ModelLimit& limit) {
  return fmt::format("{}: {} {}, limit {} ({})", limit.effect, percent(limit.value), limit.what,
                     percent(limit.limit), limit.source);
}

}  // namespace slosh
