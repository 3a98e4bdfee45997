// Problem: a lattice that holds resists a shear as a solid does, which raises the first natural
// frequency of a tank (lattice_buckling.hpp). A small free wave is compared with the frequency
// sqrt(g k tanh k d) of linear theory, changed by the lattice's resistance and by the
// compressibility of the liquid. What the analysis leaves out is the smoothing at the free surface,
// which falls with dp.
#include <cmath>
#include <numbers>
#include <string>

#include "sph/schemes.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/problems/stability/lattice_buckling.hpp"
#include "verification/problems/stability/stability_map.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

constexpr double gravity = 9.81, depth = 0.36, length = 1;  // [m/s2], [m], [m]
constexpr double wave_number = std::numbers::pi / length;

sph::Scene wave(const std::string& variant, double ratio, double spacing) {
  sph::Scene scene = still_tank(depth, spacing);
  scene.duration = 7;
  scene.sample_interval = 0.01;
  scene.gauges = {{"wall", 0}};
  scene.initial_wave = sph::InitialWave{1, 1e-3};
  scene.variant = variant;
  scene.numbers.smoothing_length_ratio = ratio;
  scene.threads = 1;
  return scene;
}

// Returns the angular frequency of the upward crossings of zero, by the least-squares line through
// their times; NaN for fewer than three.
double frequency(const sph::History& elevation) {
  double count = 0, times = 0, numbers = 0, product = 0, squares = 0;
  for (std::size_t i = 1; i < elevation.value.size(); ++i) {
    const double before = elevation.value[i - 1], now = elevation.value[i];
    if (!(before < 0 && now >= 0)) continue;
    const double time =
        elevation.time[i] - now / (now - before) * (elevation.time[i] - elevation.time[i - 1]);
    times += time;
    numbers += count;
    product += count * time;
    squares += count * count;
    count += 1;
  }
  if (count < 3) return not_a_number;
  const double period = (product - numbers * times / count) / (squares - numbers * numbers / count);
  return 2 * std::numbers::pi / period;
}

// Returns the measured frequency less the predicted one, over that of linear theory.
double error(const std::string& variant, double (*gradient_shape)(double), double ratio) {
  const double linear = std::sqrt(gravity * wave_number * std::tanh(wave_number * depth)),
               sound_speed_ratio = sph::Recommended::numbers.sound_speed_ratio.value(),
               predicted =
                   frequency_shift_of_lattice({gradient_shape, ratio}, wave_number * depth) +
                   frequency_shift_of_sound(sound_speed_ratio, wave_number * depth);
  const sph::RunOutput output = sph::run("recommended", wave(variant, ratio, 0.02), {});
  return frequency(output.elevation.at("wall")) / linear - 1 - predicted;
}

reports::Figure figure_of_shifts() {
  reports::Figure figure;
  figure.id = "lattice_resistance-shift";
  figure.title = "Change of the first natural frequency by the resistance of the square lattice";
  figure.caption = "By the analysis; a tank 1 m long with water 0.36 m deep.";
  figure.x_label = "h / dp";
  figure.y_label = "change of the frequency (%)";
  for (const NamedKernel& kernel : kernels_of_schemes()) {
    reports::Curve curve{kernel.name, {}, {}, {}};
    for (int i = 0; i <= 110; ++i) {
      const double ratio = 1.5 + 0.01 * i;
      curve.x.push_back(ratio);
      curve.y.push_back(
          100 * frequency_shift_of_lattice({kernel.gradient_shape, ratio}, wave_number * depth));
    }
    figure.curves.push_back(std::move(curve));
  }
  return figure;
}

ProblemOutcome run(bool) {
  ProblemOutcome outcome{{{"quintic_spline", {}}, {"wendland_c2", {}}, {"kaiser_bessel", {}}},
                         {figure_of_shifts()},
                         {}};
  for (const double ratio : {1.8, 1.42, 1.36, 1.3})
    outcome.measures[0].errors.push_back(
        {ratio, error("quintic_spline", &gradient_shape_of<sph::QuinticSpline>, ratio)});
  for (const double ratio : {2.0, 1.38})
    outcome.measures[1].errors.push_back(
        {ratio, error("wendland_c2", &gradient_shape_of<sph::WendlandC2>, ratio)});
  for (const double ratio : {1.6, 1.5})
    outcome.measures[2].errors.push_back(
        {ratio, error("", &gradient_shape_of<sph::KaiserBessel>, ratio)});
  return outcome;
}

}  // namespace

Problem lattice_resistance_problem() {
  const std::string meaning =
      "frequency of a free wave of 1 mm at 20 mm less the predicted one, over that of linear "
      "theory, where the lattice holds";
  return {"lattice_resistance",
          "Stability: the lattice's resistance in the first natural frequency",
          "A free wave of 1 mm in 1 m of water 0.36 m deep, at 20 mm, with smoothing lengths that "
          "hold the square lattice.",
          "Rayleigh's quotient with the second moments of the kernel's second derivatives over the "
          "lattice, and for the compressibility",
          "sqrt(g k tanh k d) with both changes. The smoothing at the free surface is left out.",
          {{"quintic_spline", "1", "h / dp", meaning, false},
           {"wendland_c2", "1", "h / dp", meaning, false},
           {"kaiser_bessel", "1", "h / dp", meaning, false}},
          &run,
          10};
}

}  // namespace slosh
