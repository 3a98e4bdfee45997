#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/shape/sensor_place.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/solvers/reference_tank.hpp"
#include "verification/solvers/solver_runs.hpp"
#include "verification/solvers/theory/linear_flow.hpp"
#include "verification/solvers/theory/motion_samples.hpp"

namespace slosh {
namespace {

std::unique_ptr<LinearFlow> linear_flow(const LinearRun& linear, const CaseDefinition& definition) {
  return is_rectangle(definition.tank) ? linear_flow_in_rectangle(linear, definition)
                                       : linear_flow_in_outline(linear, definition);
}

// Returns the mean over the sensor by the midpoint rule; all of it lies under the still surface.
std::vector<double> pressure_on_sensor(const LinearFlow& flow, const TankDefinition& tank,
                                       const PressureGaugeDefinition& gauge) {
  constexpr int places_of_sensor = 8;
  const int places = gauge.width > 0 ? places_of_sensor : 1;
  const auto [first, last] = sensor_ends(tank, gauge);
  std::vector<double> mean;
  for (int k = 0; k < places; ++k) {
    const double share = (k + 0.5) / places;
    const std::vector<double> here =
        flow.pressure({first.x + share * (last.x - first.x), first.z + share * (last.z - first.z)});
    mean.resize(here.size(), 0.0);
    for (std::size_t i = 0; i < here.size(); ++i) mean[i] += here[i] / places;
  }
  return mean;
}

}  // namespace

void require_scene(const LinearRun&, const CaseDefinition& definition, const RunDefinition& run) {
  if (definition.liquid.column_width)
    throw refused(run,
                  "linear theory takes no liquid.column_width_m: a breaking dam is no small "
                  "motion about a level surface");
  if (!definition.obstacles.empty())
    throw refused(run,
                  "linear theory takes no [[obstacle]]: its modes are those of a tank "
                  "without one");
  if (definition.motion.still() && !definition.initial_wave)
    throw refused(run,
                  "linear theory of motion.still = true is a level surface, against "
                  "which nothing can be compared; expected a tank that moves or an [initial_wave]");
}

RunResult run_solver(const LinearRun& linear, const RunRequest& request) {
  require_scene(linear, request.definition, request.run);
  const CaseDefinition& definition = request.definition;
  const std::unique_ptr<LinearFlow> flow = linear_flow(linear, definition);
  const std::vector<double> times = sample_times(definition);
  const Extent surface = still_surface(definition);

  RunResult result;
  const auto add = [&](const std::string& name, const char* unit, std::vector<double> values) {
    result.series.push_back({name, unit, times, std::move(values)});
  };
  for (const GaugeDefinition& gauge : definition.gauges)
    add("elevation@" + gauge.name, "m", flow->elevation(gauge.x));
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    if (is_under_still_water(definition, gauge))
      add(wall_pressure(gauge.name), "Pa", pressure_on_sensor(*flow, definition.tank, gauge));
  for (const ProbeDefinition& probe : definition.probes) {
    if (!(probe.z < definition.liquid.fill_depth)) continue;
    const Corner place{probe.x, probe.z};
    add("velocity_x@" + probe.name, "m/s", flow->velocity_x(place));
    add("velocity_z@" + probe.name, "m/s", flow->velocity_z(place));
    add("pressure@" + probe.name, "Pa", flow->pressure(place));
  }
  add("force_x", "N/m", flow->force_x());
  if (flow->has_moment()) add("moment", "N", flow->moment());
  request.progress(definition.duration, 0);

  // Every mode is highest at the walls.
  const double highest = std::max(largest_magnitude(flow->elevation(surface.left)),
                                  largest_magnitude(flow->elevation(surface.right)));
  result.diagnostics = {{"modes", linear.modes},
                        {"highest_elevation_m", highest},
                        {"highest_elevation_over_depth", highest / definition.liquid.fill_depth}};
  result.active_terms = {"linear potential flow"};
  if (!definition.motion.still()) {
    result.active_terms.push_back(flow->modes_text());
    const std::size_t closed = definition.motion.roll ? 0 : closed_form_sines(definition).size();
    result.active_terms.push_back(closed == 0 ? "Duhamel's integral of the motion"
                                  : closed == 1
                                      ? "closed form of a sine surge"
                                      : fmt::format("closed form of {} sine surges", closed));
  }
  if (definition.initial_wave) result.active_terms.push_back("closed form of the standing wave");
  if (linear.two_layer) result.active_terms.push_back("two layers, liquid and gas");
  return result;
}

}  // namespace slosh
