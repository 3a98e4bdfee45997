#include "verification/assessment/doubts/flow_scales.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "verification/case/motion.hpp"
#include "verification/case/shape/sensor_place.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/solvers/particles/expected_speed.hpp"
#include "verification/solvers/theory/natural_frequencies.hpp"

namespace slosh {
namespace {

double steepest_tilt(const CaseDefinition& definition) {
  const SurgeMotion surge = surge_motion(definition);
  const std::optional<RollMotion> roll = roll_motion(definition);
  double steepest = 0;
  for (double t = 0; t <= definition.duration; t += definition.sample_interval)
    steepest = std::max(steepest, std::abs(surge.acceleration(t)) / definition.gravity +
                                      (roll ? std::abs(roll->angle(t)) : 0));
  return steepest;
}

// Where the motion has no single frequency, one of its frequencies may be the natural one.
double amplification(const CaseDefinition& definition) {
  const double forced = forcing_frequency(definition);
  const std::vector<double> natural = natural_frequencies(definition, 1);
  if (forced == 0 || natural.empty()) return std::numeric_limits<double>::infinity();
  const double ratio = forced / natural.front();
  return 1 / std::abs(1 - ratio * ratio);
}

double forced_height(const CaseDefinition& definition) {
  if (definition.liquid.column_width) return std::numeric_limits<double>::infinity();
  const double tilt = steepest_tilt(definition);
  if (tilt == 0) return 0;
  return tilt * still_surface(definition).length() / 2 * amplification(definition);
}

double run_up(const CaseDefinition& definition) {
  const double speed = expected_speed(definition);
  return speed * speed / (2 * definition.gravity);
}

bool is_violent(const CaseDefinition& definition) {
  return forced_height(definition) >= run_up(definition) ||
         definition.liquid.fill_depth + wave_height(definition) >= definition.tank.height;
}

}  // namespace

std::optional<double> flow_frequency(const CaseDefinition& definition) {
  if (const double forced = forcing_frequency(definition); forced > 0) return forced;
  const std::vector<double> natural = natural_frequencies(definition, 1);
  if (natural.empty()) return {};
  return natural.front();
}

double stokes_layer(const CaseDefinition& definition, double angular_frequency) {
  return std::sqrt(2 * definition.liquid.kinematic_viscosity / angular_frequency);
}

double wave_height(const CaseDefinition& definition) {
  if (definition.gravity == 0) return 0;
  const double initial = definition.initial_wave ? std::abs(definition.initial_wave->amplitude) : 0;
  return std::max(initial, std::min(forced_height(definition), run_up(definition)));
}

bool may_strike_a_gauge(const CaseDefinition& definition) {
  if (definition.impacts) return true;
  const auto& gauges = definition.pressure_gauges;
  const bool has_dry_gauge = std::any_of(gauges.begin(), gauges.end(), [&](const auto& gauge) {
    return !is_under_still_water(definition, gauge);
  });
  return has_dry_gauge && definition.gravity > 0 && is_violent(definition);
}

}  // namespace slosh
