#include "reference/section/section_wave.hpp"

#include <cmath>
#include <limits>

#include "reference/require.hpp"
#include "reference/section/section_flow.hpp"

namespace slosh::reference {
namespace {

constexpr auto in_section_wave = "SectionWave";

double checked_time(double t) {
  return time_within(in_section_wave, t, std::numeric_limits<double>::max());
}

}  // namespace

SectionWave::SectionWave(const SectionModes& modes, int mode, double amplitude)
    : modes_(modes), column_(mode - 1), angular_frequency_(modes.angular_frequency(mode)) {
  require(std::isfinite(amplitude), in_section_wave, "wave amplitude", amplitude,
          "a finite length, m");
  amplitude_ =
      amplitude / modes.flow()->on_surface(in_section_wave, modes.left()).potential[column_];
}

double SectionWave::elevation(double x, double t) const {
  return amplitude_ * modes_.flow()->on_surface(in_section_wave, x).potential[column_] *
         std::cos(angular_frequency_ * checked_time(t));
}

SectionWave::Velocity SectionWave::velocity(double x, double z, double t) const {
  const SectionFlow& flow = *modes_.flow();
  const auto values = flow.values(in_section_wave, x, z);
  const double potential = -amplitude_ * angular_frequency_ / flow.wave_numbers[column_] *
                           std::sin(angular_frequency_ * checked_time(t));
  return {potential * values.x_slope[column_], potential * values.z_slope[column_]};
}

double SectionWave::pressure(double x, double z, double t) const {
  const SectionFlow& flow = *modes_.flow();
  const double wave = amplitude_ * flow.values(in_section_wave, x, z).potential[column_] *
                      std::cos(angular_frequency_ * checked_time(t));
  return -flow.section().density * flow.section().gravity * (z - flow.middle().z - wave);
}

double SectionWave::horizontal_force(double t) const {
  const SectionFlow& flow = *modes_.flow();
  return flow.section().density * amplitude_ * angular_frequency_ * angular_frequency_ *
         std::cos(angular_frequency_ * checked_time(t)) * flow.lines[column_];
}

}  // namespace slosh::reference
