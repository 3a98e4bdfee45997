#include "sph/start/initial_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "sph/scene.hpp"

namespace slosh::sph {
namespace {

void require_possible(const InitialWave& wave, const Scene& scene) {
  const double most = std::min(scene.fill_depth, scene.tank_height - scene.fill_depth);
  if (wave.mode < 1)
    throw std::invalid_argument(
        fmt::format("initial_wave.mode = {}: expected 1, 2, ...", wave.mode));
  if (!(std::abs(wave.amplitude) < most))
    throw std::invalid_argument(fmt::format(
        "initial_wave.amplitude = {} m: expected a magnitude below {} m, shallower than "
        "the liquid and below the roof",
        wave.amplitude, most));
  if (scene.column_width || !scene.obstacles.empty())
    throw std::invalid_argument(
        "initial_wave: expected neither a dam nor obstacles, because the modes with these are not "
        "cosines");
}

}  // namespace

InitialSurface::InitialSurface(const Scene& scene)
    : fill_depth_(scene.fill_depth),
      amplitude_(0),
      wave_number_(0),
      weight_(scene.rest_density * scene.gravity) {
  if (!scene.initial_wave) return;
  require_possible(*scene.initial_wave, scene);
  amplitude_ = scene.initial_wave->amplitude;
  wave_number_ = scene.initial_wave->mode * std::numbers::pi / scene.tank_length;
}

double InitialSurface::height(double x) const {
  return fill_depth_ + amplitude_ * std::cos(wave_number_ * x);
}

// The difference sin(k to) - sin(k from) is taken as a product, which avoids cancellation.
double InitialSurface::mean_height(double from, double to) const {
  const double half = wave_number_ * (to - from) / 2;
  const double share = half == 0 ? 1 : std::sin(half) / half;
  return fill_depth_ + amplitude_ * share * std::cos(wave_number_ * (from + to) / 2);
}

double InitialSurface::pressure(double x, double z) const { return weight_ * (height(x) - z); }

}  // namespace slosh::sph
