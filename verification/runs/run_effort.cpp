#include "verification/runs/run_effort.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "openfoam_cases/time_step.hpp"
#include "sph/start/initial_lattice.hpp"
#include "verification/case/changed_input.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/runs/sph_step.hpp"

namespace slosh {
namespace {

double samples(const CaseDefinition& definition) {
  return definition.duration / definition.sample_interval;
}

// The number of equal steps from one sample to the next, none longer than `longest` [s].
double steps_to_samples(const CaseDefinition& definition, double longest) {
  return samples(definition) *
         std::max(std::ceil(definition.sample_interval / longest - 1e-9), 1.0);
}

RunEffort effort_of(const SphRun& sph, const CaseDefinition& definition, const RunDefinition& run) {
  const double depth = definition.liquid.fill_depth, fine = sph.surface_particle_spacing,
               coarse = sph.particle_spacing;
  const double fine_depth = fine < coarse ? std::min(depth, sph::fine_layers * fine) : 0;
  const double below = liquid_area_below(definition, depth - fine_depth),
               above = liquid_area(definition) - below;
  const std::optional<SphStep> step = sph_step(definition, run);
  return {.steps = step ? definition.duration / step->between_samples : 0,
          .elements = below / (coarse * coarse) + above / (fine * fine)};
}

RunEffort effort_of(const InterFoamRun& mesh, const CaseDefinition& definition,
                    const RunDefinition&) {
  openfoam::SloshingTank tank{
      .length = definition.tank.length,
      .height = definition.tank.height,
      .fill_depth = definition.liquid.fill_depth,
      .gravity = definition.gravity,
      .liquid = {definition.liquid.density, definition.liquid.kinematic_viscosity},
      .gas = {definition.gas.density, definition.gas.kinematic_viscosity},
      .velocity = {},
      .acceleration = {},
      .initial_relative_velocity = 0,
      .duration = definition.duration,
      .sample_interval = definition.sample_interval,
      .gauges = {},
      .cells_x = mesh.cells_x,
      .cells_z = mesh.cells_z,
      .wall_cell = mesh.wall_cell};
  if (mesh.cells_y) tank.gap = openfoam::Gap{definition.tank.breadth.value(), *mesh.cells_y};
  if (const auto& wave = definition.initial_wave)
    tank.initial_wave = openfoam::InitialWave{wave->mode, wave->amplitude};
  // The cells divide the rectangle around an outline, and those outside it are left out.
  const double share = tank_area(definition.tank) / (tank.length * tank.height);
  return {.steps = steps_to_samples(definition, openfoam::max_time_step(tank)),
          .elements = share * number_of_cells(mesh),
          .outer_corrections = mesh.outer_corrections,
          .pressure_corrections = openfoam::pressure_corrections(tank)};
}

RunEffort effort_of(const PotentialRun& potential, const CaseDefinition& definition,
                    const RunDefinition&) {
  return {.steps = samples(definition),
          .elements = static_cast<double>(potential.nodes_x) * potential.nodes_z};
}

RunEffort effort_of(const LinearRun& linear, const CaseDefinition& definition,
                    const RunDefinition&) {
  return {.steps = samples(definition), .elements = static_cast<double>(linear.modes)};
}

RunEffort effort_of(const ViscousWaveRun&, const CaseDefinition& definition, const RunDefinition&) {
  return {.steps = samples(definition), .elements = 1};
}

// A record and a stored result are only read.
RunEffort effort_of(const RecordRun&, const CaseDefinition&, const RunDefinition&) { return {}; }
RunEffort effort_of(const StoredRun&, const CaseDefinition&, const RunDefinition&) { return {}; }

// Nothing is known of an external program.
RunEffort effort_of(const ExternalRun&, const CaseDefinition&, const RunDefinition&) { return {}; }

}  // namespace

RunEffort run_effort(const CaseDefinition& definition, const RunDefinition& run) {
  const CaseDefinition solved = definition_solved_by(run, definition);
  return std::visit([&](const auto& solver) { return effort_of(solver, solved, run); }, run.solver);
}

}  // namespace slosh
