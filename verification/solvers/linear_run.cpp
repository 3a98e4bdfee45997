#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "reference/linear_roll.hpp"
#include "reference/linear_surge.hpp"
#include "reference/standing_wave.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/shape/sensor_place.hpp"
#include "verification/solvers/reference_tank.hpp"
#include "verification/solvers/solver_runs.hpp"

namespace slosh {
namespace {

// Samples of a motion without a closed form in each sample interval. Duhamel's integral takes X''
// as linear between them; its relative error (omega step)^2 / 12 is below 1e-4 where a forcing
// period has 50 samples.
constexpr int motion_samples_per_sample = 4;
// [s] The error is the same up to 14 rad/s, and a case that is finely sampled for its impacts needs
// no more memory.
constexpr double shortest_motion_step = 2.5e-3;

// Returns the sines of the surge where it has a closed form, as sines without a ramp have, else
// none.
std::vector<SineMotion> closed_form_sines(const CaseDefinition& definition) {
  if (!definition.motion.surge) return {};
  std::vector<SineMotion> sines = sines_of(*definition.motion.surge);
  const bool ramped = std::any_of(sines.begin(), sines.end(),
                                  [](const SineMotion& sine) { return sine.ramp_periods > 0; });
  return ramped ? std::vector<SineMotion>{} : sines;
}

std::optional<reference::Gas> gas_of(const LinearRun& linear, const CaseDefinition& definition) {
  if (!linear.two_layer) return {};
  return reference::Gas{definition.gas.density,
                        definition.tank.height - definition.liquid.fill_depth};
}

// Returns the solution for the motion, with the gas where the run counts it.
template <class Solution, class Motion>
Solution solution(const LinearRun& linear, const CaseDefinition& definition, const Motion& motion) {
  const auto gas = gas_of(linear, definition);
  if (!gas) return {tank_of(definition), start_of(definition), motion, linear.modes};
  return {tank_of(definition), *gas, start_of(definition), motion, linear.modes};
}

double motion_step(const CaseDefinition& definition) {
  return std::max(shortest_motion_step, definition.sample_interval / motion_samples_per_sample);
}

// Returns the solutions whose sum is the surge: one for each sine, or one for the whole motion.
std::vector<reference::LinearSurge> surges_of(const LinearRun& linear,
                                              const CaseDefinition& definition) {
  std::vector<reference::LinearSurge> surges;
  if (!definition.motion.surge) return surges;
  for (const SineMotion& sine : closed_form_sines(definition))
    surges.push_back(solution<reference::LinearSurge>(
        linear, definition,
        reference::SineSurge{sine.amplitude, sine.angular_frequency, sine.phase}));
  if (!surges.empty()) return surges;
  const SurgeMotion motion = surge_motion(definition);
  surges.push_back(solution<reference::LinearSurge>(
      linear, definition,
      reference::AnySurge{motion.velocity(0), motion.acceleration, definition.duration,
                          motion_step(definition)}));
  return surges;
}

std::optional<reference::LinearRoll> roll_of(const LinearRun& linear,
                                             const CaseDefinition& definition) {
  const std::optional<RollMotion> roll = roll_motion(definition);
  if (!roll) return {};
  return solution<reference::LinearRoll>(
      linear, definition,
      reference::RollMotion{roll->angle, roll->rate, roll->acceleration,
                            roll->axis_x - definition.tank.length / 2,
                            roll->axis_z - definition.liquid.fill_depth, definition.duration,
                            motion_step(definition)});
}

std::optional<reference::StandingWave> wave_of(const LinearRun& linear,
                                               const CaseDefinition& definition) {
  if (!definition.initial_wave) return {};
  return reference::StandingWave(
      tank_of(definition), gas_of(linear, definition),
      {definition.initial_wave->mode, definition.initial_wave->amplitude});
}

// The surge's sines, the roll and the initial wave together: the sum of the solutions, as linear
// theory has it. The hydrostatic pressure, which each of them contains, counts once.
class LinearTank {
 public:
  LinearTank(const LinearRun& linear, const CaseDefinition& definition)
      : definition_(definition),
        times_(sample_times(definition)),
        surges_(surges_of(linear, definition)),
        roll_(roll_of(linear, definition)),
        wave_(wave_of(linear, definition)) {}

  const std::vector<double>& times() const { return times_; }

  // x is measured from the tank's centre [m].
  std::vector<double> elevation(double x) const {
    std::vector<double> sum(times_.size(), 0.0);
    for (const auto& surge : surges_) add(sum, surge.elevation(x, times_));
    if (roll_) add(sum, roll_->elevation(x, times_));
    if (wave_) add(sum, series([&](double t) { return wave_->elevation(x, t); }));
    return sum;
  }

  // Returns the mean over the sensor by the midpoint rule; all of it lies under the still surface.
  std::vector<double> wall_pressure(const PressureGaugeDefinition& gauge) const {
    const int places = gauge.width > 0 ? places_of_sensor : 1;
    std::vector<double> mean(times_.size(), 0.0);
    for (int k = 0; k < places; ++k) {
      const double along = gauge.position + gauge.width * ((k + 0.5) / places - 0.5);
      add(mean, pressure(place_on_wall(definition_, gauge.wall, along)), 1.0 / places);
    }
    return mean;
  }

  using Place = reference::Observation::Place;

  // Returns the pressure at a place under the still surface.
  std::vector<double> pressure(Place place) const {
    std::vector<double> sum(times_.size(), 0.0);
    if (roll_) add(sum, roll_->pressure(place.x, place.z, times_));
    for (const auto& surge : surges_)
      add(sum, series([&](double t) { return surge.pressure(place.x, place.z, t); }));
    if (wave_) add(sum, series([&](double t) { return wave_->pressure(place.x, place.z, t); }));
    const double still = -definition_.liquid.density * definition_.gravity * place.z;
    const int counted = static_cast<int>(surges_.size()) + roll_.has_value() + wave_.has_value();
    for (double& value : sum) value -= (counted - 1) * still;
    return sum;
  }

  // Return the components of the velocity relative to the tank there.
  std::vector<double> velocity_x(Place place) const {
    return velocity(place, [](const auto& one) { return one.x; });
  }
  std::vector<double> velocity_z(Place place) const {
    return velocity(place, [](const auto& one) { return one.z; });
  }

  std::vector<double> force_x() const {
    return series([&](double t) {
      double sum = (roll_ ? roll_->force(t).x : 0) + (wave_ ? wave_->horizontal_force(t) : 0);
      for (const auto& surge : surges_) sum += surge.horizontal_force(t);
      return sum;
    });
  }
  // The moment is known where nothing but roll excites the liquid.
  bool has_moment() const { return roll_ && surges_.empty() && !wave_; }
  std::vector<double> moment() const {
    return series([&](double t) { return roll_->moment(t); });
  }

 private:
  static constexpr int places_of_sensor = 8;

  static void add(std::vector<double>& sum, const std::vector<double>& values, double scale = 1) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += scale * values[i];
  }

  template <class Component>
  std::vector<double> velocity(Place place, const Component& of) const {
    return series([&](double t) {
      double sum = (roll_ ? of(roll_->velocity(place.x, place.z, t)) : 0) +
                   (wave_ ? of(wave_->velocity(place.x, place.z, t)) : 0);
      for (const auto& surge : surges_) sum += of(surge.velocity(place.x, place.z, t));
      return sum;
    });
  }

  template <class Value>
  std::vector<double> series(const Value& value) const {
    std::vector<double> values;
    for (const double t : times_) values.push_back(value(t));
    return values;
  }

  const CaseDefinition& definition_;
  std::vector<double> times_;
  std::vector<reference::LinearSurge> surges_;
  std::optional<reference::LinearRoll> roll_;
  std::optional<reference::StandingWave> wave_;
};

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
  const LinearTank tank(linear, definition);
  const double centre = definition.tank.length / 2;

  RunResult result;
  const auto add = [&](const std::string& name, const char* unit, std::vector<double> values) {
    result.series.push_back({name, unit, tank.times(), std::move(values)});
  };
  for (const GaugeDefinition& gauge : definition.gauges)
    add("elevation@" + gauge.name, "m", tank.elevation(gauge.x - centre));
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    if (is_under_still_water(definition, gauge))
      add("wall_pressure@" + gauge.name, "Pa", tank.wall_pressure(gauge));
  for (const ProbeDefinition& probe : definition.probes) {
    if (!(probe.z < definition.liquid.fill_depth)) continue;
    const reference::Observation::Place place = place_of(definition, probe);
    add("velocity_x@" + probe.name, "m/s", tank.velocity_x(place));
    add("velocity_z@" + probe.name, "m/s", tank.velocity_z(place));
    add("pressure@" + probe.name, "Pa", tank.pressure(place));
  }
  add("force_x", "N/m", tank.force_x());
  if (tank.has_moment()) add("moment", "N", tank.moment());
  request.progress(definition.duration, 0);

  // Every mode is highest at the walls.
  const double highest = std::max(largest_magnitude(tank.elevation(-centre)),
                                  largest_magnitude(tank.elevation(centre)));
  result.diagnostics = {{"modes", linear.modes},
                        {"highest_elevation_m", highest},
                        {"highest_elevation_over_depth", highest / definition.liquid.fill_depth}};
  result.active_terms = {"linear potential flow"};
  if (!definition.motion.still()) {
    result.active_terms.push_back(fmt::format("{} antisymmetric modes", linear.modes));
    const std::size_t closed = definition.motion.roll ? 0 : closed_form_sines(definition).size();
    result.active_terms.push_back(closed == 0 ? "Duhamel's integral of the motion"
                                  : closed == 1
                                      ? "closed form of a sine surge"
                                      : fmt::format("closed form of {} sine surges", closed));
  }
  if (definition.initial_wave) result.active_terms.push_back("closed form of the standing wave");
  if (linear.two_layer) result.active_terms.push_back("gas in the dispersion relation");
  return result;
}

}  // namespace slosh
