#include "verification/problems/stability/stability_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "sph/schemes.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

constexpr double depth = 0.4, amplitude = 0.04, gravity = 9.81;  // [m], [m], [m/s2]
constexpr double spacing = 0.04, smoothing_length = 1.5 * spacing;

constexpr const char* theory_label = "limit of the lattice (von Neumann)";
const char* const labels[] = {"stable", "unstable", "gains energy unnoticed"};

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "none in the map";
}

// Returns the limit between the last stable point and the first that is not, by bisection to 2 %.
double limit_of(const StabilityMap& map, double up, const std::vector<Probe>& row, int& unnoticed) {
  const auto first = std::find_if(row.begin(), row.end(), [](const Probe& probe) {
    return probe.stability != Stability::stable;
  });
  if (first == row.begin() || first == row.end()) return not_a_number;
  const auto k = static_cast<std::size_t>(first - row.begin());
  double low = map.across.values[k - 1], high = map.across.values[k];
  while (high - low > 0.02 * high) {
    const double middle = 0.5 * (low + high);
    const Stability found = map.probe(middle, up).stability;
    unnoticed += found == Stability::unnoticed;
    (found == Stability::stable ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

sph::Scene still_tank(double water_depth, double particle_spacing) {
  const auto zero = [](double) { return 0.0; };
  return {.tank_length = 1,
          .tank_height = 2 * water_depth,
          .fill_depth = water_depth,
          .gravity = gravity,
          .rest_density = 1000,
          .displacement = zero,
          .velocity = zero,
          .acceleration = zero,
          .duration = 0,
          .sample_interval = 0,
          .particle_spacing = particle_spacing,
          .surface_particle_spacing = particle_spacing,
          .gauges = {},
          .record_snapshot = {}};
}

sph::Scene wave_scene(const sph::SchemeNumbers& numbers, int steps) {
  const double sound = numbers.sound_speed_ratio.value() * std::sqrt(gravity * depth),
               step = numbers.courant_number.value() * smoothing_length / sound;
  sph::Scene scene = still_tank(depth, spacing);
  scene.duration = steps * step;
  scene.sample_interval = step;
  scene.initial_wave = sph::InitialWave{1, amplitude};
  scene.numbers = numbers;
  scene.numbers.courant_number = 1e3;  // the samples alone set the step
  return scene;
}

LatticeScheme lattice_of_recommended() {
  const sph::SchemeNumbers& own = sph::Recommended::numbers;
  return {&gradient_shape_of<sph::Recommended::Kernel>, own.smoothing_length_ratio.value(),
          own.artificial_viscosity.value() / 8, own.density_diffusion.value()};
}

Probe probe_of_wave(const sph::Scene& scene) try {
  const sph::RunOutput output = sph::run("recommended", scene, {});
  const double own = scene.rest_density * gravity * amplitude * amplitude * scene.tank_length / 4,
               gained = output.kinetic_energy.value.back() + output.potential_energy.value.back();
  return {gained <= 0.05 * own ? Stability::stable : Stability::unnoticed, ""};
} catch (const sph::SimulationError& error) {
  return {Stability::unstable, error.what()};
}

MapOutcome explore(const StabilityMap& map) {
  MapOutcome outcome;
  reports::Figure& figure = outcome.figure;
  figure.id = map.id;
  figure.title = map.title;
  figure.caption = map.caption;
  figure.x_label = map.across.label;
  figure.y_label = map.up.label;
  figure.log_x = map.log_across;
  figure.log_y = map.log_up;
  for (const char* label : labels)
    figure.curves.push_back({label, {}, {}, {}, reports::Curve::Style::points});
  reports::Curve theory{theory_label, {}, {}, {}, reports::Curve::Style::line};
  outcome.table = {map.id + "-measured",
                   map.title + ": limits",
                   "The first point that is unstable, and how that was found.",
                   {map.up.label, "measured limit", theory_label, "first unstable at", "how"},
                   {}};

  for (const double up : map.up.values) {
    std::vector<Probe> row;
    for (const double across : map.across.values) {
      row.push_back(map.probe(across, up));
      const auto kind = static_cast<std::size_t>(row.back().stability);
      figure.curves[kind].x.push_back(across);
      figure.curves[kind].y.push_back(up);
      outcome.unnoticed += row.back().stability == Stability::unnoticed;
    }
    const double measured = limit_of(map, up, row, outcome.unnoticed), expected = map.theory(up);
    outcome.measured.push_back(measured);
    outcome.expected.push_back(expected);
    theory.x.push_back(expected);
    theory.y.push_back(up);
    const auto unstable = std::find_if(row.begin(), row.end(), [](const Probe& probe) {
      return probe.stability == Stability::unstable;
    });
    const bool none = unstable == row.end();
    outcome.table.rows.push_back(
        {number(up), number(measured), number(expected),
         none ? "" : number(map.across.values[static_cast<std::size_t>(unstable - row.begin())]),
         none ? "" : unstable->message});
  }
  std::erase_if(figure.curves, [](const reports::Curve& curve) { return curve.x.empty(); });
  figure.curves.push_back(std::move(theory));
  return outcome;
}

std::vector<MeasureKind> map_measures(const std::string& step, Guarded guarded) {
  std::vector<MeasureKind> kinds{
      {"limit", "1", step, "measured limit over the theoretical one, less 1", false},
      {"shipped", "1", step, "the schemes' number over the measured limit", false}};
  if (guarded == Guarded::yes)
    kinds.push_back(
        {"unnoticed", "1", "runs", "runs that gained energy and were not stopped", false});
  return kinds;
}

std::vector<MeasuredErrors> measures_of(const StabilityMap& map, const MapOutcome& outcome,
                                        const std::function<double(double up)>& shipped,
                                        Guarded guarded) {
  std::vector<MeasuredErrors> measures{{"limit", {}}, {"shipped", {}}};
  for (std::size_t i = 0; i < map.up.values.size(); ++i) {
    const double up = map.up.values[i], measured = outcome.measured[i];
    measures[0].errors.push_back({up, measured / outcome.expected[i] - 1});
    measures[1].errors.push_back({up, shipped(up) / measured});
  }
  if (guarded == Guarded::yes)
    measures.push_back({"unnoticed", {{1, static_cast<double>(outcome.unnoticed)}}});
  return measures;
}

ProblemOutcome outcome_of(const StabilityMap& map, const std::function<double(double up)>& shipped,
                          Guarded guarded) {
  const MapOutcome found = explore(map);
  return {measures_of(map, found, shipped, guarded), {found.figure}, {found.table}};
}

}  // namespace slosh
