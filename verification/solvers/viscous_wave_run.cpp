#include <cmath>

#include "reference/viscous_standing_wave.hpp"
#include "verification/case/quantities.hpp"
#include "verification/solvers/reference_tank.hpp"
#include "verification/solvers/solver_runs.hpp"
#include "verification/solvers/theory/beyond_linear.hpp"

namespace slosh {
namespace {

reference::ViscousStandingWave wave_of(const CaseDefinition& definition) {
  const InitialWaveDefinition& wave = definition.initial_wave.value();
  return {tank_of(definition), definition.liquid.kinematic_viscosity, {wave.mode, wave.amplitude}};
}

void add_beyond_linear(const CaseDefinition& definition, const std::vector<double>& at_right,
                       RunResult& result) {
  const BeyondLinear beyond(definition, at_right, definition.liquid.kinematic_viscosity);
  for (std::size_t i = 0; i < definition.gauges.size(); ++i)
    add_moved(TimeSeries(result.series[i]), beyond.elevation(definition.gauges[i].x), result);
}

}  // namespace

void require_scene(const ViscousWaveRun&, const CaseDefinition& definition,
                   const RunDefinition& run) try {
  if (!definition.initial_wave || !definition.motion.still())
    throw refused(run,
                  "the viscous wave is a free one, let go from rest: expected an [initial_wave] in "
                  "a still tank");
  wave_of(definition);
} catch (const std::invalid_argument& error) {
  throw refused(run, error.what());
}

RunResult run_solver(const ViscousWaveRun&, const RunRequest& request) {
  const CaseDefinition& definition = request.definition;
  require_scene(ViscousWaveRun{}, definition, request.run);
  const reference::ViscousStandingWave wave = wave_of(definition);
  const std::vector<double> times = sample_times(definition);
  RunResult result;
  for (const GaugeDefinition& gauge : definition.gauges)
    result.series.push_back({"elevation@" + gauge.name, "m", times,
                             wave.elevation(gauge.x - definition.tank.length / 2, times)});
  if (request.settings.with_left_out)
    add_beyond_linear(definition, wave.elevation(definition.tank.length / 2, times), result);
  request.progress(definition.duration, 0);
  // It is nowhere and never higher than where and when it is let go.
  const double highest = std::abs(definition.initial_wave->amplitude);
  result.diagnostics = {{"highest_elevation_m", highest},
                        {"highest_elevation_over_depth", highest / definition.liquid.fill_depth},
                        {"damping_1_s", wave.damping()},
                        {"angular_frequency_rad_s", wave.angular_frequency()}};
  result.active_terms = {"linear Navier-Stokes equations", "free slip on walls and bottom",
                         "all roots of the dispersion relation"};
  return result;
}

}  // namespace slosh
