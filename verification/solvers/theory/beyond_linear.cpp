#include "verification/solvers/theory/beyond_linear.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "reference/third_order_waves.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/solvers/reference_tank.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

using std::numbers::pi;

// In first natural periods: between these times the estimate is a straight line.
constexpr double coarsest_interval = 1.0 / 100;
constexpr double deepest = 3;  // in lengths; no wave feels a bottom below it

reference::Tank tank_like(const CaseDefinition& definition) {
  reference::Tank tank = tank_of(definition);
  if (is_rectangle(definition.tank)) return tank;
  tank.length = still_surface(definition).length();
  const std::vector<double> natural = natural_frequencies(definition, 1);
  if (natural.empty()) return tank;
  const double k = pi / tank.length;
  const double slope = natural.front() * natural.front() / (tank.gravity * k);  // tanh k h
  tank.fill_depth =
      slope < 1 ? std::min(std::atanh(slope) / k, deepest * tank.length) : deepest * tank.length;
  return tank;
}

reference::ThirdOrderWaves waves_of(const CaseDefinition& definition, double scale) {
  reference::ThirdOrderWaves waves{.tank = tank_like(definition)};
  std::optional<SurgeMotion> surge;
  if (definition.motion.surge) surge = surge_motion(definition);
  const std::optional<RollMotion> roll = roll_motion(definition);
  const Extent surface = still_surface(definition);
  const double lever = roll ? definition.liquid.fill_depth - roll->axis_z : 0;
  if (surge || roll)
    waves.acceleration = [=, g = definition.gravity](double t) {
      return scale * ((surge ? surge->acceleration(t) : 0) +
                      (roll ? g * roll->angle(t) - lever * roll->acceleration(t) : 0));
    };
  if (roll)
    waves.turn = [=, middle = (surface.left + surface.right) / 2,
                  g = definition.gravity](double t) {
      return reference::ThirdOrderWaves::Turn{scale * roll->rate(t), scale * roll->acceleration(t),
                                              roll->axis_x - middle, -lever,
                                              g * (1 - std::cos(roll->angle(t)))};
    };
  if (definition.start == Start::earth) {
    waves.initial_spin = scale * (roll ? roll->rate(0) : 0);
    waves.initial_velocity = scale * (surge ? surge->velocity(0) : 0) - lever * waves.initial_spin;
  }
  if (definition.initial_wave)
    waves.initial_wave = {definition.initial_wave->mode,
                          scale * definition.initial_wave->amplitude};
  return waves;
}

double share_of(const std::vector<double>& whole, const std::vector<double>& model) {
  const double product = std::inner_product(whole.begin(), whole.end(), model.begin(), 0.0);
  const double square = std::inner_product(model.begin(), model.end(), model.begin(), 0.0);
  return square > 0 ? product / square : 1;
}

// The times at which the estimate is made, and from which it is read at the case's sample times.
double interval_of(const CaseDefinition& definition) {
  const std::vector<double> natural = natural_frequencies(definition, 1);
  const double period = natural.empty() ? definition.duration : 2 * pi / natural.front();
  return std::min(std::max(definition.sample_interval, coarsest_interval * period),
                  definition.duration);
}

reference::ThirdOrderRecord solved(const CaseDefinition& definition,
                                   const std::vector<double>& at_right, double viscosity) {
  const double interval = interval_of(definition);
  std::vector<double> times;
  for (int i = 0; (i - 1) * interval < definition.duration; ++i) times.push_back(i * interval);
  const auto scaled = [&](double scale, bool linear_alone) {
    reference::ThirdOrderWaves waves = waves_of(definition, scale);
    waves.kinematic_viscosity = viscosity;
    waves.linear_alone = linear_alone;
    return third_order_waves(waves, times);
  };
  const double half = still_surface(definition).length() / 2;
  return scaled(share_of(at_right, at_times(scaled(1, true).linear_elevation(half), interval,
                                            sample_times(definition))),
                false);
}

}  // namespace

std::vector<double> at_times(const std::vector<double>& value, double interval,
                             const std::vector<double>& times) {
  std::vector<double> found;
  for (const double t : times) {
    const double place = std::min(t / interval, static_cast<double>(value.size() - 1));
    const auto i = std::min(static_cast<std::size_t>(place), value.size() - 2);
    found.push_back(std::lerp(value[i], value[i + 1], place - static_cast<double>(i)));
  }
  return found;
}

BeyondLinear::BeyondLinear(const CaseDefinition& definition, const std::vector<double>& at_right,
                           double kinematic_viscosity)
    : SampledFlow(definition),
      record_(solved(definition, at_right, kinematic_viscosity)),
      interval_(interval_of(definition)) {}

// The rectangle of another section is as long as the still surface.
Corner BeyondLinear::from_middle(Corner place) const {
  const Extent surface = still_surface(definition_);
  const double half = surface.length() / 2;
  return {std::clamp(place.x - surface.left - half, -half, half),
          place.z - definition_.liquid.fill_depth};
}

std::vector<double> BeyondLinear::sampled(const std::vector<double>& values) const {
  return at_times(values, interval_, times_);
}

std::vector<double> BeyondLinear::elevation(double x) const {
  return sampled(record_.elevation(from_middle({x, 0}).x));
}
std::vector<double> BeyondLinear::pressure(Corner place) const {
  const auto [x, z] = from_middle(place);
  return sampled(record_.pressure(x, z));
}
std::vector<double> BeyondLinear::velocity_x(Corner place) const {
  const auto [x, z] = from_middle(place);
  return sampled(record_.velocity_x(x, z));
}
std::vector<double> BeyondLinear::velocity_z(Corner place) const {
  const auto [x, z] = from_middle(place);
  return sampled(record_.velocity_z(x, z));
}
std::vector<double> BeyondLinear::force_x() const { return sampled(record_.force_x()); }
bool BeyondLinear::has_moment() const {
  return definition_.motion.roll && !definition_.motion.surge && !definition_.initial_wave;
}
std::vector<double> BeyondLinear::moment() const {
  const RollDefinition& roll = *definition_.motion.roll;
  const Extent surface = still_surface(definition_);
  return sampled(record_.moment(roll.axis_x - (surface.left + surface.right) / 2,
                                roll.axis_z - definition_.liquid.fill_depth));
}
std::string BeyondLinear::modes_text() const { return "third order"; }

void add_moved(TimeSeries series, const std::vector<double>& beyond, RunResult& result) {
  series.name += nonlinear;
  for (std::size_t i = 0; i < series.value.size(); ++i) series.value[i] += beyond[i];
  if (std::all_of(series.value.begin(), series.value.end(),
                  [](double value) { return std::isfinite(value); }))
    result.series.push_back(std::move(series));
}

}  // namespace slosh
