#include <numbers>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/surge_table.hpp"

namespace slosh {
namespace {

SineSurge read_sine_surge(const TomlTable& motion) {
  motion.allow_only({"type", "amplitude_m", "angular_frequency_rad_s", "ramp_periods"});
  return {.amplitude = motion.get("amplitude_m", positive("m")),
          .angular_frequency = motion.get("angular_frequency_rad_s", positive("rad/s")),
          .ramp_periods = motion.find("ramp_periods", not_negative("periods")).value_or(0)};
}

TableSurge read_table_surge(const TomlTable& motion, const std::filesystem::path& case_file,
                            double duration) {
  motion.allow_only({"type", "file"});
  const std::filesystem::path file = case_file.parent_path() / motion.get("file", any_text());
  if (!std::filesystem::is_regular_file(file)) {
    motion.refuse("file",
                  "a CSV file's path relative to the case file; there is no " + file.string());
  }
  return read_surge_table(file, duration);
}

SineRoll read_sine_roll(const TomlTable& motion) {
  motion.allow_only({"type", "amplitude_deg", "angular_frequency_rad_s", "axis_x_m", "axis_z_m"});
  return {.amplitude = motion.get("amplitude_deg", positive("deg")) * std::numbers::pi / 180,
          .angular_frequency = motion.get("angular_frequency_rad_s", positive("rad/s")),
          .axis_x = motion.get("axis_x_m", any_number("m from the left wall")),
          .axis_z = motion.get("axis_z_m", any_number("m from the bottom")),
          .where = motion.where()};
}

}  // namespace

MotionDefinition read_motion(const TomlTable& motion, const std::filesystem::path& case_file,
                             double duration) {
  motion.allow_only({"type", "amplitude_m", "amplitude_deg", "angular_frequency_rad_s",
                     "ramp_periods", "file", "axis_x_m", "axis_z_m"});
  const std::string type =
      motion.choice("type", "a motion", {"still", "sine_surge", "table_surge", "sine_roll"});
  if (type == "still") {
    motion.allow_only({"type"});
    return Still{};
  }
  if (type == "sine_surge") return read_sine_surge(motion);
  if (type == "table_surge") return read_table_surge(motion, case_file, duration);
  return read_sine_roll(motion);
}

}  // namespace slosh
