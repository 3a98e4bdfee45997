#include "sph/scheme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sph/start/initial_lattice.hpp"

namespace slosh::sph {
namespace {

double chosen(const std::optional<double>& changed, const std::optional<double>& own,
              const char* name) {
  if (changed && !own)
    throw std::invalid_argument(
        fmt::format("{} = {}: expected none, the scheme has no such number", name, *changed));
  return changed.value_or(own.value_or(0));
}

}  // namespace

double tank_speed(const Scene& scene, double t, double frame) {
  const Roll& roll = roll_of(scene);
  const double reach =
      std::hypot(std::max(std::abs(roll.axis_x), std::abs(scene.tank_length - roll.axis_x)),
                 std::max(std::abs(roll.axis_z), std::abs(scene.fill_depth - roll.axis_z)));
  return std::abs(scene.velocity(t) - frame) + reach * std::abs(roll.rate(t));
}

double largest_tank_speed(const Scene& scene) {
  double in_earth = 0, in_start = 0;
  const double start = scene.start == Start::tank ? scene.velocity(0) : 0;
  for (double t = 0; t <= scene.duration; t += scene.sample_interval) {
    in_earth = std::max(in_earth, tank_speed(scene, t));
    in_start = std::max(in_start, tank_speed(scene, t, start));
  }
  constexpr double rounding = 1e-9;
  return in_start < in_earth * (1 - rounding) ? in_start : in_earth;
}

double expected_speed(const Scene& scene) {
  const double wave_speed = std::sqrt(scene.gravity * scene.fill_depth);
  return (scene.column_width ? 2 : 1) * wave_speed + largest_tank_speed(scene);
}

Setting setting_of(const Scene& scene, const SchemeNumbers& own) {
  const SchemeNumbers& run = scene.numbers;
  const double speed = scene.coarse_run ? scene.coarse_run->expected_speed : expected_speed(scene);
  const double sound =
      chosen(run.sound_speed_ratio, own.sound_speed_ratio, "sound_speed_ratio") * speed;
  const Particles volumes = lattice_of_volumes(scene);
  // Without gravity nothing is compressed, and the speed of sound may be 0.
  const double mean_compression =
      scene.gravity == 0 ? 0 : scene.gravity * mean_depth(volumes, scene) / (sound * sound);
  return {.gravity = scene.gravity,
          .fill_depth = scene.fill_depth,
          .rest_density = scene.rest_density / (1 + mean_compression),
          .kinematic_viscosity = scene.kinematic_viscosity,
          .breadth = scene.breadth,
          .particle_spacing = scene.particle_spacing,
          .flattest_cell = flattest_cell(volumes),
          .smoothing_length_ratio = chosen(run.smoothing_length_ratio, own.smoothing_length_ratio,
                                           "smoothing_length_ratio"),
          .expected_speed = speed,
          .speed_of_sound = sound,
          .courant_number = chosen(run.courant_number, own.courant_number, "courant_number"),
          .artificial_viscosity =
              chosen(run.artificial_viscosity, own.artificial_viscosity, "artificial_viscosity"),
          .density_diffusion =
              chosen(run.density_diffusion, own.density_diffusion, "density_diffusion")};
}

std::vector<std::string> named_terms(std::initializer_list<const char*> names) {
  std::vector<std::string> terms;
  for (const char* name : names)
    if (*name) terms.push_back(name);
  return terms;
}

}  // namespace slosh::sph
