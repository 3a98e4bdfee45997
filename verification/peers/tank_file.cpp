#include "verification/peers/tank_file.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "verification/case/shape/tank_shape.hpp"
#include "verification/peers/motion_table.hpp"

namespace slosh {
namespace {

using nlohmann::ordered_json;

ordered_json motion_of(const CaseDefinition& definition) {
  ordered_json times = ordered_json::array(), accelerations = ordered_json::array();
  for (const MotionPoint& at : motion_table(definition)) {
    times.push_back(at.time);
    accelerations.push_back(at.surge_acceleration);
  }
  return {{"initial_velocity_x_m_s", initial_velocity_x(definition)},
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
