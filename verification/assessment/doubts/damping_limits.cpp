#include "verification/assessment/doubts/damping_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "verification/assessment/doubts/flow_scales.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/solvers/particles/artificial_viscosity.hpp"

namespace slosh {
namespace {

using std::numbers::pi;

// A friction layer of fewer particles is not resolved (docs/schemes.md).
constexpr double layer_in_particles = 3;
// With a layer 2.9 wall cells thick the wave of run_walls_test.cpp in openfoam_cases decays as
// theory says.
constexpr double layer_in_cells = 3;

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
                                  1e3 * layer, few_of(slipping)),
                      loss, seen_share, of_amplitude, source});
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
                                    1e3 * layer, than, few_of(runs)),
                        loss, seen_share, of_amplitude, source});
  };
  add_unresolved("cells beside the walls", coarse_meshes);
  add_unresolved("particles", coarse);
}

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
    limits.push_back({of, worst, seen_share, of_amplitude,
                      "Lamb, Hydrodynamics, article 348; Monaghan 2005, section 8.5"});
}

}  // namespace

std::vector<ModelLimit> damping_limits(const CaseDefinition& definition) {
  std::vector<ModelLimit> limits;
  const std::optional<double> frequency = flow_frequency(definition);
  if (!frequency) return limits;
  limit_friction(definition, stokes_layer(definition, *frequency), limits);
  limit_artificial_viscosity(definition, *frequency, limits);
  return limits;
}

}  // namespace slosh
