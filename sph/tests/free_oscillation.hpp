// The free oscillation of a liquid in its first mode, and its decay rate and frequency.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "sph/simulation.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph {

// The first mode of the elevation, sampled along the tank.
struct FreeOscillation {
  std::vector<double> time, first_mode;
};

// Released by a tank that stops: the liquid moves on at 0.03 m/s.
inline Scene released_scene(double spacing, double duration) {
  Scene scene = still_scene(spacing, duration);
  scene.velocity = [](double t) { return t > 0 ? 0.0 : 0.03; };
  scene.start = Start::tank;
  return scene;
}

inline FreeOscillation free_oscillation(const std::string& scheme, Scene scene) {
  scene.gauges.clear();
  const int gauges = 20;
  for (int i = 0; i < gauges; ++i)
    scene.gauges.push_back({std::to_string(i), (i + 0.5) / gauges * scene.tank_length});
  const RunOutput output = run(scheme, scene, {});
  FreeOscillation oscillation{output.kinetic_energy.time, {}};
  oscillation.first_mode.resize(oscillation.time.size());
  for (const Gauge& gauge : scene.gauges)
    for (std::size_t k = 0; k < oscillation.time.size(); ++k)
      oscillation.first_mode[k] += output.elevation.at(gauge.name).value[k] *
                                   -std::cos(std::numbers::pi * gauge.x / scene.tank_length) * 2 /
                                   gauges;
  return oscillation;
}

inline std::vector<double> zero_crossings(const FreeOscillation& oscillation) {
  std::vector<double> crossings;
  const auto& [time, value] = oscillation;
  for (std::size_t k = 1; k + 1 < time.size(); ++k)
    if (value[k] * value[k + 1] < 0)
      crossings.push_back(time[k] - value[k] * (time[k + 1] - time[k]) / (value[k + 1] - value[k]));
  return crossings;
}

// [1/s], from the highest elevation between successive zero crossings, first to last.
inline double decay_rate(const FreeOscillation& oscillation) {
  const std::vector<double> crossings = zero_crossings(oscillation);
  std::vector<double> peaks(crossings.size() - 1);
  for (std::size_t k = 0; k < oscillation.time.size(); ++k) {
    const auto next = std::upper_bound(crossings.begin(), crossings.end(), oscillation.time[k]);
    if (next == crossings.begin() || next == crossings.end()) continue;
    double& peak = peaks[next - crossings.begin() - 1];
    peak = std::max(peak, std::abs(oscillation.first_mode[k]));
  }
  const double half_period =
      (crossings.back() - crossings.front()) / static_cast<double>(peaks.size());
  return std::log(peaks.front() / peaks.back()) /
         (half_period * static_cast<double>(peaks.size() - 1));
}

// [rad/s]
inline double natural_frequency(const FreeOscillation& oscillation) {
  const std::vector<double> crossings = zero_crossings(oscillation);
  return std::numbers::pi * static_cast<double>(crossings.size() - 1) /
         (crossings.back() - crossings.front());
}

}  // namespace slosh::sph
