#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/linear_surge.hpp"
#include "verification/case_file/motion.hpp"
#include "verification/runs/solver_runs.hpp"

namespace slosh {
namespace {

// Samples per sample interval of a motion that has no closed form. Duhamel's integral takes X'' as
// linear between them: relative error (omega step)^2 / 12, below 1e-4 where a forcing period has 50
// samples.
constexpr int motion_samples_per_sample = 4;

// 0, interval, ..., up to and including the duration (but for a rounding error).
std::vector<double> sample_times(const CaseDefinition& definition) {
  const double intervals = definition.duration / definition.sample_interval;
  std::vector<double> times(static_cast<std::size_t>(intervals * (1 + 1e-12)) + 1);
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = i * definition.sample_interval;
  return times;
}

// The surge where it has a closed form: a sine without a ramp.
const SineMotion* sine_surge(const CaseDefinition& definition) {
  if (!definition.motion.surge) return nullptr;
  const auto* sine = std::get_if<SineMotion>(&*definition.motion.surge);
  return sine && sine->ramp_periods == 0 ? sine : nullptr;
}

template <class Motion>
reference::LinearSurge solution(const LinearRun& linear, const CaseDefinition& definition,
                                const Motion& motion) {
  const reference::Tank tank{definition.tank.length, definition.liquid.fill_depth,
                             definition.gravity, definition.liquid.density};
  const auto start =
      definition.start == Start::earth ? reference::Start::earth : reference::Start::tank;
  if (!linear.two_layer) return {tank, start, motion, linear.modes};
  const reference::Gas gas{definition.gas.density,
                           definition.tank.height - definition.liquid.fill_depth};
  return {tank, gas, start, motion, linear.modes};
}

reference::LinearSurge solution(const LinearRun& linear, const CaseDefinition& definition) {
  if (const SineMotion* sine = sine_surge(definition))
    return solution(linear, definition,
                    reference::SineSurge{sine->amplitude, sine->angular_frequency});
  const SurgeMotion motion = surge_motion(definition);
  return solution(linear, definition,
                  reference::AnySurge{motion.velocity(0), motion.acceleration, definition.duration,
                                      definition.sample_interval / motion_samples_per_sample});
}

double largest_magnitude(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
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
  if (definition.motion.still())
    throw refused(run,
                  "linear theory of motion.still = true is a level surface, against "
                  "which nothing can be compared; expected a tank that moves");
}

RunResult run_linear(const LinearRun& linear, const RunRequest& request) {
  require_scene(linear, request.definition, request.run);
  const CaseDefinition& definition = request.definition;
  const reference::LinearSurge tank = solution(linear, definition);
  const std::vector<double> times = sample_times(definition);
  const double centre = definition.tank.length / 2;

  RunResult result;
  for (const GaugeDefinition& gauge : definition.gauges) {
    result.series.push_back(
        {"elevation@" + gauge.name, "m", times, tank.elevation(gauge.x - centre, times)});
  }
  TimeSeries force{"horizontal_force", "N/m", times, {}};
  for (const double t : times) force.value.push_back(tank.horizontal_force(t));
  result.series.push_back(std::move(force));
  request.progress(definition.duration, 0);

  // Every antisymmetric mode is highest at the walls, and what one wall has the other has with the
  // other sign.
  const double highest = largest_magnitude(tank.elevation(centre, times));
  result.diagnostics = {{"modes", linear.modes},
                        {"highest_elevation_m", highest},
                        {"highest_elevation_over_depth", highest / definition.liquid.fill_depth}};
  result.active_terms = {
      "linear potential flow", fmt::format("{} antisymmetric modes", linear.modes),
      sine_surge(definition) ? "closed form of a sine surge" : "Duhamel's integral of the motion"};
  if (linear.two_layer) result.active_terms.push_back("gas in the dispersion relation");
  return result;
}

}  // namespace slosh
