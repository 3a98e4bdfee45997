#include "reference/standing_wave.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "reference/require.hpp"
#include "reference/tank_mode.hpp"

namespace slosh::reference {
namespace {

constexpr auto in_standing_wave = "StandingWave";

}  // namespace

double mode_shape(const Tank& tank, int mode, double x) {
  require_within(tank, in_standing_wave, x);
  return std::cos(mode * std::numbers::pi * (x / tank.length + 0.5));
}

StandingWave::StandingWave(const Tank& tank, const std::optional<Gas>& gas, const InitialWave& wave)
    : tank_(tank),
      wave_(wave),
      wave_number_(wave.mode * std::numbers::pi / tank.length),
      angular_frequency_(gas ? natural_frequency(tank, *gas, wave.mode)
                             : natural_frequency(tank, wave.mode)),
      density_difference_(tank.density - (gas ? gas->density : 0)) {
  require(std::isfinite(wave.amplitude), in_standing_wave, "amplitude", wave.amplitude,
          "a finite length, m");
}

double StandingWave::acceleration(double t) const {
  const double time = time_within(in_standing_wave, t, std::numeric_limits<double>::max());
  return wave_.amplitude * angular_frequency_ * angular_frequency_ *
         std::cos(angular_frequency_ * time);
}

double StandingWave::elevation(double x, double t) const {
  return mode_shape(tank_, wave_.mode, x) * acceleration(t) /
         (angular_frequency_ * angular_frequency_);
}

StandingWave::Velocity StandingWave::velocity(double x, double z, double t) const {
  require_within(tank_, in_standing_wave, x, z);
  const double time = time_within(in_standing_wave, t, std::numeric_limits<double>::max());
  const double speed = wave_.amplitude * angular_frequency_ * std::sin(angular_frequency_ * time) /
                       std::tanh(wave_number_ * tank_.fill_depth);
  const double phase = wave_number_ * (x + tank_.length / 2);
  const DepthProfile profile = depth_profile(wave_number_, z, tank_.fill_depth);
  return {speed * std::sin(phase) * profile.cosh, -speed * std::cos(phase) * profile.sinh};
}

double StandingWave::pressure(double x, double z, double t) const {
  require_within(tank_, in_standing_wave, x, z);
  const double profile = depth_profile(wave_number_, z, tank_.fill_depth).cosh /
                         (wave_number_ * std::tanh(wave_number_ * tank_.fill_depth));
  return tank_.density *
         (acceleration(t) * mode_shape(tank_, wave_.mode, x) * profile - tank_.gravity * z);
}

double StandingWave::horizontal_force(double t) const {
  const double between_walls = wave_.mode % 2 == 0 ? 0 : -2;
  return density_difference_ * acceleration(t) * between_walls / (wave_number_ * wave_number_);
}

}  // namespace slosh::reference
