#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "reference/potential_flow/nonlinear_potential_flow.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/motion/motion_times.hpp"
#include "verification/case/quantities.hpp"
#include "verification/solvers/reference_tank.hpp"
#include "verification/solvers/solver_runs.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

using reference::NonlinearRecord;
using reference::NonlinearSloshing;

// The part of the first natural period at which a motion by a table is read. The walls' velocity
// moves the surface at once: that of a recorded motion's noise, s / dt, would raise waves that no
// grid resolves, and no wave of the grid needs shorter steps.
constexpr double table_step = 0.025;

reference::TankMotion motion_of(const CaseDefinition& whole) {
  const std::vector<double> natural = natural_frequencies(whole, 1);
  const CaseDefinition definition =
      natural.empty() ? whole
                      : with_tables_at(whole, table_step * 2 * std::numbers::pi / natural.front());
  reference::TankMotion motion;
  if (definition.motion.surge) {
    const SurgeMotion surge = surge_motion(definition);
    motion.surge_velocity = surge.velocity;
    motion.surge_acceleration = surge.acceleration;
  }
  if (const std::optional<RollMotion> roll = roll_motion(definition)) {
    motion.angle = roll->angle;
    motion.rate = roll->rate;
    motion.roll_acceleration = roll->acceleration;
    motion.axis_x = roll->axis_x - definition.tank.length / 2;
    motion.axis_z = roll->axis_z - definition.liquid.fill_depth;
  }
  return motion;
}

// Returns the initial elevation over x from the tank's centre; empty for a level surface.
std::function<double(double)> initial_elevation(const CaseDefinition& definition) {
  if (!definition.initial_wave) return {};
  const double wave_number =
      definition.initial_wave->mode * std::numbers::pi / definition.tank.length;
  return [wave_number, amplitude = definition.initial_wave->amplitude,
          half = definition.tank.length / 2](double x) {
    return amplitude * std::cos(wave_number * (x + half));
  };
}

NonlinearSloshing sloshing_of(const PotentialRun& potential, const CaseDefinition& definition) {
  return {.tank = tank_of(definition),
          .roof = definition.tank.height - definition.liquid.fill_depth,
          .motion = motion_of(definition),
          .start = start_of(definition),
          .initial_elevation = initial_elevation(definition),
          .nodes_x = potential.nodes_x,
          .nodes_z = potential.nodes_z};
}

reference::Observation observation_of(const CaseDefinition& definition) {
  reference::Observation observation{.times = sample_times(definition)};
  for (const GaugeDefinition& gauge : definition.gauges)
    observation.gauges.push_back(gauge.x - definition.tank.length / 2);
  // The pressure is linear over the few millimetres of a sensor, so its middle is enough.
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    observation.places.push_back(place_on_wall(definition, gauge.wall, gauge.position));
  for (const ProbeDefinition& probe : definition.probes)
    observation.places.push_back(place_of(definition, probe));
  return observation;
}

// Adds the force normal to a wall. The roof stays dry: the run ends where the liquid reaches it.
template <class Add>
void add_wall_force(const NonlinearRecord& record, Wall wall, const Add& add) {
  const bool is_side = wall == Wall::left || wall == Wall::right;
  std::vector<double> force;
  for (const reference::WallLoad& load : record.load)
    force.push_back(wall == Wall::left     ? load.left
                    : wall == Wall::right  ? load.right
                    : wall == Wall::bottom ? load.force_z
                                           : 0);
  add((is_side ? "force_x@" : "force_z@") + name_of(wall, wall_names), "N/m", std::move(force));
}

void add_series(const NonlinearRecord& record, const CaseDefinition& definition,
                const std::string& suffix, RunResult& result) {
  const auto add = [&](const std::string& name, const char* unit, std::vector<double> values) {
    result.series.push_back({name + suffix, unit, record.times, std::move(values)});
  };
  for (std::size_t k = 0; k < definition.gauges.size(); ++k)
    add("elevation@" + definition.gauges[k].name, "m", record.elevation[k]);
  for (std::size_t k = 0; k < definition.pressure_gauges.size(); ++k)
    add(wall_pressure(definition.pressure_gauges[k].name), "Pa", record.pressure[k]);
  for (std::size_t k = 0; k < definition.probes.size(); ++k) {
    const std::string& name = definition.probes[k].name;
    const std::size_t place = definition.pressure_gauges.size() + k;
    add("velocity_x@" + name, "m/s", record.velocity_x[place]);
    add("velocity_z@" + name, "m/s", record.velocity_z[place]);
    add("pressure@" + name, "Pa", record.pressure[place]);
  }
  std::vector<double> force_x, force_z, moment;
  for (const reference::WallLoad& load : record.load) {
    force_x.push_back(load.force_x);
    force_z.push_back(load.force_z);
    moment.push_back(load.moment);
  }
  for (const Wall wall : definition.wall_forces) add_wall_force(record, wall, add);
  add("force_x", "N/m", std::move(force_x));
  add("force_z", "N/m", std::move(force_z));
  if (definition.motion.roll) add("moment", "N", std::move(moment));
}

// Cuts a record to the samples that both runs have: both end where the first leaves its range.
void cut_to(std::size_t samples, NonlinearRecord& record) {
  record.times.resize(samples);
  for (std::vector<double>& series : record.elevation) series.resize(samples);
  for (auto* places : {&record.pressure, &record.velocity_x, &record.velocity_z})
    for (std::vector<double>& series : *places) series.resize(samples);
  record.load.resize(samples);
}

}  // namespace

void require_scene(const PotentialRun&, const CaseDefinition& definition,
                   const RunDefinition& run) {
  if (definition.liquid.column_width)
    throw refused(run,
                  "potential flow takes no liquid.column_width_m: a dam's surface is no "
                  "function of x");
  if (!definition.obstacles.empty())
    throw refused(run, "potential flow takes no [[obstacle]]: its tank has four plane walls");
}

// The flow is also solved with three quarters of the nodes: the difference of the two solutions
// estimates the numerical uncertainty.
RunResult run_solver(const PotentialRun& potential, const RunRequest& request) {
  require_scene(potential, request.definition, request.run);
  const CaseDefinition& definition = request.definition;
  const reference::Observation observation = observation_of(definition);
  NonlinearRecord record =
      run_nonlinear_potential_flow(sloshing_of(potential, definition), observation);
  const PotentialRun coarse{potential.nodes_x * 3 / 4, potential.nodes_z * 3 / 4};
  NonlinearRecord coarse_record =
      run_nonlinear_potential_flow(sloshing_of(coarse, definition), observation);
  request.progress(definition.duration, 0);
  const std::string& because = record.valid_until <= coarse_record.valid_until
                                   ? record.left_range_because
                                   : coarse_record.left_range_because;
  const std::size_t common = std::min(record.times.size(), coarse_record.times.size());
  if (common == 0) throw SolverError("potential flow leaves its range at once: " + because);
  for (NonlinearRecord* one : {&record, &coarse_record}) cut_to(common, *one);

  RunResult result;
  add_series(record, definition, "", result);
  add_series(coarse_record, definition, coarser, result);
  result.diagnostics = {{"valid_until_s", std::min(record.valid_until, coarse_record.valid_until)},
                        {"largest_volume_error_m", largest_magnitude(record.volume_error)},
                        {"largest_energy_error", largest_magnitude(record.energy_error)},
                        {"largest_unresolved_share", largest_magnitude(record.unresolved)}};
  if (!because.empty()) result.provenance["left_range_because"] = because;
  result.active_terms = {"fully nonlinear potential flow"};
  result.cost.elements = 1.0 * potential.nodes_x * potential.nodes_z;
  return result;
}

}  // namespace slosh
