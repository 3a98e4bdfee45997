#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/shape/sensor_place.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/solvers/reference_tank.hpp"
#include "verification/solvers/solver_runs.hpp"
#include "verification/solvers/theory/beyond_linear.hpp"
#include "verification/solvers/theory/linear_flow.hpp"
#include "verification/solvers/theory/motion_samples.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

// At one place the next modes may cancel one another, but not all of so many.
constexpr int times_the_modes = 16, most_modes_more = 1000, many_of_a_section = 20,
              most_samples = 4000;

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

std::vector<TimeSeries> series_of(const LinearFlow& flow, const CaseDefinition& definition) {
  const std::vector<double> times = sample_times(definition);
  std::vector<TimeSeries> series;
  const auto add = [&](const std::string& name, const char* unit, std::vector<double> values) {
    series.push_back({name, unit, times, std::move(values)});
  };
  for (const GaugeDefinition& gauge : definition.gauges)
    add("elevation@" + gauge.name, "m", flow.elevation(gauge.x));
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    if (is_under_still_water(definition, gauge))
      add(wall_pressure(gauge.name), "Pa", pressure_on_sensor(flow, definition.tank, gauge));
  for (const ProbeDefinition& probe : definition.probes) {
    if (!(probe.z < definition.liquid.fill_depth)) continue;
    const Corner place{probe.x, probe.z};
    add("velocity_x@" + probe.name, "m/s", flow.velocity_x(place));
    add("velocity_z@" + probe.name, "m/s", flow.velocity_z(place));
    add("pressure@" + probe.name, "Pa", flow.pressure(place));
  }
  add("force_x", "N/m", flow.force_x());
  if (flow.has_moment()) add("moment", "N", flow.moment());
  return series;
}

std::vector<double> minus(std::vector<double> values, const std::vector<double>& others) {
  std::transform(values.begin(), values.end(), others.begin(), values.begin(), std::minus<>());
  return values;
}

// Each series with what more modes add, for a rest that falls with the first power of their number.
// Many modes of a section are dear: there a quarter of them tells it. So are many samples: at most
// `most_samples` of them tell the size of the rest.
std::vector<TimeSeries> with_more_modes(const LinearRun& linear, const CaseDefinition& definition,
                                        std::vector<TimeSeries> own) {
  const bool is_few = is_rectangle(definition.tank) || linear.modes < many_of_a_section;
  LinearRun other = linear;
  other.modes =
      !is_few ? linear.modes / 4
      : is_rectangle(definition.tank)
          ? std::max(1, std::min(times_the_modes * linear.modes, linear.modes + most_modes_more))
          : 2 * many_of_a_section;
  const double rest =  // 1 / m over 1 / m - 1 / M
      1.0 * other.modes / (other.modes - linear.modes);
  CaseDefinition few = definition;
  few.sample_interval = std::max(definition.sample_interval, definition.duration / most_samples);
  const auto summed = [&](const LinearRun& modes) {
    return series_of(*linear_flow(modes, few), few);
  };
  const std::vector<TimeSeries> less = few.sample_interval == definition.sample_interval
                                           ? own
                                           : summed(linear),
                                more = summed(other);
  for (std::size_t i = 0; i < own.size(); ++i) {
    own[i].name += finer;
    const std::vector<double> added =
        at_times(minus(more[i].value, less[i].value), few.sample_interval, own[i].time);
    for (std::size_t n = 0; n < added.size(); ++n) own[i].value[n] += rest * added[n];
  }
  return own;
}

// Adds each series with more modes, and with what linear theory leaves out where that is finite. Of
// two layers that is not known unless the gas is as light as none.
void add_left_out(const LinearRun& linear, const CaseDefinition& definition, const LinearFlow& flow,
                  RunResult& result) {
  const std::vector<TimeSeries> own = result.series;
  for (TimeSeries& one : with_more_modes(linear, definition, own))
    result.series.push_back(std::move(one));
  if (linear.two_layer && share_lost_to_gas(definition) > most_left_out) return;
  const std::vector<TimeSeries> beyond = series_of(
      BeyondLinear(definition, flow.elevation(still_surface(definition).right)), definition);
  for (std::size_t i = 0; i < own.size(); ++i) add_moved(own[i], beyond[i].value, result);
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
  const Extent surface = still_surface(definition);

  RunResult result;
  result.series = series_of(*flow, definition);
  if (request.settings.with_left_out) add_left_out(linear, definition, *flow, result);
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
