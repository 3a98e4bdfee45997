#include "verification/peers/tank_file.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "verification/case/motion.hpp"
#include "verification/case/shape/tank_shape.hpp"

namespace slosh {
namespace {

using nlohmann::ordered_json;

// Linear interpolation between ten points a sample errs by (omega dt)^2 / 8 of the acceleration:
// 3e-6 for 5 rad/s sampled at 100 Hz.
constexpr int points_per_sample = 10;

ordered_json motion_of(const CaseDefinition& definition) {
  const SurgeMotion motion = surge_motion(definition);
  const double step = definition.sample_interval / points_per_sample;
  const auto steps = static_cast<int>(std::ceil(definition.duration / step - 1e-9));
  ordered_json times = ordered_json::array(), accelerations = ordered_json::array();
  for (int i = 0; i <= steps; ++i) {
    const double time = std::min(i * step, definition.duration);
    times.push_back(time);
    accelerations.push_back(motion.acceleration(time));
  }
  const double velocity = definition.start == Start::earth ? -motion.velocity(0) : 0;
  return {{"initial_velocity_x_m_s", velocity},
          {"time_s", times},
          {"acceleration_x_m_s2", accelerations}};
}

}  // namespace

std::filesystem::path peers_directory() { return SLOSH_PEERS_DIRECTORY; }

bool fits_tank_file(const CaseDefinition& definition) {
  return is_rectangle(definition.tank) && !definition.motion.roll && definition.obstacles.empty() &&
         !definition.liquid.column_width;
}

std::string tank_file(const CaseDefinition& definition) {
  if (!fits_tank_file(definition))
    throw std::invalid_argument(
        "{tank_file}: expected a rectangular tank that does not roll, without obstacle and without "
        "column_width_m");
  const InitialWaveDefinition wave =
      definition.initial_wave.value_or(InitialWaveDefinition{.mode = 1, .amplitude = 0});
  ordered_json gauges = ordered_json::array();
  for (const GaugeDefinition& gauge : definition.gauges)
    gauges.push_back({{"name", gauge.name}, {"x_m", gauge.x}});
  const ordered_json document{
      {"schema_version", 1},
      {"length_m", definition.tank.length},
      {"height_m", definition.tank.height},
      {"fill_depth_m", definition.liquid.fill_depth},
      {"gravity_m_s2", definition.gravity},
      {"density_kg_m3", definition.liquid.density},
      {"kinematic_viscosity_m2_s", definition.liquid.kinematic_viscosity},
      {"initial_wave", {{"mode", wave.mode}, {"amplitude_m", wave.amplitude}}},
      {"motion", motion_of(definition)},
      {"gauges", gauges},
      {"duration_s", definition.duration},
      {"sample_interval_s", definition.sample_interval}};
  return document.dump(1) + "\n";
}

}  // namespace slosh
