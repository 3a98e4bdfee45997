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
  const double lever = roll ? definition.liquid.fill_depth - roll->axis_z : 0;
  if (surge || roll)
    waves.acceleration = [=, g = definition.gravity](double t) {
      return scale * ((surge ? surge->acceleration(t) : 0) +
                      (roll ? g * roll->angle(t) - lever * roll->acceleration(t) : 0));
    };
  if (definition.start == Start::earth)
    waves.initial_velocity =
        scale * ((surge ? surge->velocity(0) : 0) - (roll ? lever * roll->rate(0) : 0));
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

std::vector<std::vector<double>> beyond_linear(const CaseDefinition& definition,
                                               const std::vector<double>& at_right,
                                               const std::vector<double>& x,
                                               double kinematic_viscosity) {
  const Extent surface = still_surface(definition);
  const double half = surface.length() / 2, middle = surface.left + half;
  const std::vector<double> samples = sample_times(definition);
  const std::vector<double> natural = natural_frequencies(definition, 1);
  const double period = natural.empty() ? definition.duration : 2 * pi / natural.front();
  const double interval = std::min(std::max(definition.sample_interval, coarsest_interval * period),
                                   definition.duration);
  std::vector<double> times;
  for (int i = 0; (i - 1) * interval < definition.duration; ++i) times.push_back(i * interval);
  const auto solved = [&](double scale, const std::vector<double>& from_middle, bool linear_alone) {
    reference::ThirdOrderWaves waves = waves_of(definition, scale);
    waves.kinematic_viscosity = kinematic_viscosity;
    waves.linear_alone = linear_alone;
    return third_order_waves(waves, from_middle, times);
  };
  const double scale =
      share_of(at_right, at_times(solved(1, {half}, true).linear[0], interval, samples));
  std::vector<double> places;
  for (const double one : x) places.push_back(std::clamp(one - middle, -half, half));
  std::vector<std::vector<double>> found;
  for (const std::vector<double>& one : solved(scale, places, false).beyond)
    found.push_back(at_times(one, interval, samples));
  return found;
}

void add_moved(TimeSeries series, const std::vector<double>& rise, double scale,
               RunResult& result) {
  series.name += nonlinear;
  for (std::size_t i = 0; i < series.value.size(); ++i) series.value[i] += scale * rise[i];
  if (std::all_of(series.value.begin(), series.value.end(),
                  [](double value) { return std::isfinite(value); }))
    result.series.push_back(std::move(series));
}

}  // namespace slosh
