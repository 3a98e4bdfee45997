#include "sph/coarse_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sph/scheme.hpp"
#include "sph/walls/frames.hpp"

namespace slosh::sph {
namespace {

// In estimated largest speeds.
constexpr double class_width = 1e-3;

void require_flow(const Scene& scene) {
  if (scene.column_width || scene.initial_wave || largest_tank_speed(scene) > 0) return;
  throw std::invalid_argument(
      "expected_speed = coarse_run: expected a motion of the tank, an initial wave or a dam; "
      "without them there is no flow whose speed could be measured");
}

// Returns the scene at another spacing, with the records of the speeds alone.
Scene coarse_scene(const Scene& scene, double spacing) {
  Scene coarse = scene;
  coarse.speed_from_coarse_run = false;
  coarse.particle_spacing = coarse.surface_particle_spacing = spacing;
  coarse.start_disorder = 0;
  coarse.gauges.clear();
  coarse.pressure_gauges.clear();
  coarse.probes.clear();
  coarse.loaded_walls.clear();
  coarse.record_still_water = coarse.record_energy_budget = false;
  coarse.snapshot_interval = coarse.state_interval = 0;
  coarse.record_snapshot = {};
  coarse.save_state = coarse.save_last_good_state = {};
  coarse.resume = nullptr;
  return coarse;
}

bool is_taken(Scene scene, const RunScene& run) try {
  scene.takes_steps = false;
  run(scene);
  return true;
} catch (const std::invalid_argument&) {  // the spacing does not fit the tank
  return false;
}

double coarse_spacing(const Scene& scene, const RunScene& run) {
  const double across = std::min(scene.fill_depth, scene.column_width.value_or(scene.fill_depth));
  const double own = scene.particle_spacing;
  for (int count =
           std::max(fewest_across, static_cast<int>(std::ceil(across / (coarsening * own) - 1e-9)));
       across / count > own * (1 + 1e-9); ++count)
    if (is_taken(coarse_scene(scene, across / count), run)) return across / count;
  return own;
}

void count_speeds(const Snapshot& at, const Scene& scene, SpeedCounts& speeds) {
  const TankMotion tank(scene, at.time);
  for (std::size_t i = 0; i < at.x.size(); ++i) {
    const Vector2 wall = tank.velocity(at.x[i], at.z[i]);
    speeds.add(std::hypot(at.velocity_x[i] - wall.x, at.velocity_z[i] - wall.z));
  }
}

}  // namespace

void SpeedCounts::add(double speed) {
  const auto its_class = static_cast<std::size_t>(speed / width_);
  if (its_class >= counts_.size()) counts_.resize(its_class + 1);
  ++counts_[its_class];
  ++total_;
}

double SpeedCounts::exceeded_by(double share) const {
  if (total_ == 0) throw std::logic_error("SpeedCounts::exceeded_by: no speed was added");
  const double allowed = share * static_cast<double>(total_);
  std::size_t faster = 0, its_class = counts_.size();
  while (its_class > 0 && static_cast<double>(faster + counts_[its_class - 1]) <= allowed)
    faster += counts_[--its_class];
  return static_cast<double>(its_class) * width_;
}

CoarseRun coarse_run(const Scene& scene, const RunScene& run) {
  require_flow(scene);
  const double spacing = coarse_spacing(scene, run);
  SpeedCounts speeds(class_width * expected_speed(scene));
  Scene coarse = coarse_scene(scene, spacing);
  coarse.snapshot_interval = scene.sample_interval;
  coarse.record_snapshot = [&](const Snapshot& at) { count_speeds(at, scene, speeds); };
  try {
    run(coarse);
  } catch (const SimulationError& error) {
    throw SimulationError(
        fmt::format("the coarse run at a spacing of {:.4g} m, which measures the "
                    "expected speed, failed: {}",
                    spacing, error.what()));
  }
  const double wave_speed = std::sqrt(scene.gravity * scene.fill_depth);
  return {spacing, std::max(wave_speed, speeds.exceeded_by(faster_share))};
}

}  // namespace slosh::sph
