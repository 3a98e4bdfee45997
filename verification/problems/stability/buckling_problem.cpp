// Problem: the buckling of a square lattice under pressure (lattice_buckling.hpp), with the terms
// and numbers of `recommended`, but with the quintic B-spline instead of its kernel, which hardly
// buckles, at several h / dp.
//   growth       A box without gravity, full of particles under one pressure. Its mirror walls let
//                only some waves of the endless lattice be. The particles start with random
//                velocities.
//   held         The same box at ratios at which no wave grows.
//   still_water  Water at rest in a tank. The pressure is the analysis's p0 at the bottom only, and
//                the measured growth comes up to that of the analysis as dp / depth falls.
//   held_water   The same tank at h = 1.42 dp, and at 1.5 dp by `recommended` as it is.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sph/schemes.hpp"
#include "sph/simulation.hpp"
#include "verification/problems/flow.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/problems/stability/lattice_buckling.hpp"
#include "verification/problems/stability/stability_map.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

using Choice = sph::WithQuinticSpline;
constexpr double rest_density = 1000, gravity = 9.81, depth = 0.36;  // [kg/m3], [m/s2], [m]

template <class Kernel = Choice::Kernel>
LatticeScheme scheme_at(double ratio) {
  return {&gradient_shape_of<Kernel>, ratio, Choice::numbers.artificial_viscosity.value() / 8,
          Choice::numbers.density_diffusion.value()};
}

// Returns the rate at which speeds grow [1/s], from the kinetic energy between a thousandth of
// `level` and `level`; NaN where it does not reach the level.
double growth_rate(const sph::History& kinetic_energy, double level) {
  const std::vector<double>& energy = kinetic_energy.value;
  const auto end = std::find_if(energy.begin(), energy.end(), [&](double e) { return e >= level; });
  if (end == energy.end()) return not_a_number;
  auto start = end;
  while (start != energy.begin() && *start > 1e-3 * level) --start;
  const auto time = [&](auto of) {
    return kinetic_energy.time[static_cast<std::size_t>(of - energy.begin())];
  };
  return 0.5 * std::log(*end / *start) / (time(end) - time(start));
}

// Returns the kinetic energy of a mass whose particles have left their places by 0.02 dp and move
// on at the given rate.
double buckled_energy(double mass, double spacing, double rate) {
  const double speed = 0.02 * spacing * rate;
  return 0.5 * mass * speed * speed;
}

constexpr int cells = 16;

struct PressedBox {
  Box box;
  double pressure, density;
  double rate_unit;  // sqrt(p0 / rho) / dp [1/s]
  double stiffness;  // rho c^2 / p0, with the speed of sound under the pressure
};

PressedBox pressed_box(double ratio) {
  constexpr double spacing = 0.02, sound = 10;
  PressedBox pressed{{.length = cells * spacing,
                      .height = cells * spacing,
                      .spacing = spacing,
                      .speed_of_sound = sound,
                      .smoothing_length_ratio = ratio,
                      .rest_density = rest_density},
                     rest_density * sound * sound / stiffness_of_tank,
                     0,
                     0,
                     0};
  const auto state = scheme_of<Choice>(pressed.box).state;
  // With Tait's equation rho c^2 = rho_0 c0^2 + gamma p.
  const double gamma = rest_density * sound * sound / state.stiffness();
  pressed.stiffness = stiffness_of_tank + gamma;
  pressed.density = state.density(pressed.pressure);
  pressed.rate_unit = std::sqrt(pressed.pressure / pressed.density) / spacing;
  return pressed;
}

// Returns the kinetic energy over 8 s, or until the lattice has buckled.
sph::History energy_of_box(const PressedBox& pressed, double level) {
  const sph::Scheme<Choice> scheme = scheme_of<Choice>(pressed.box);
  sph::Particles p = full_lattice(pressed.box);
  for (std::size_t i = 0; i < p.size(); ++i) set_pressure(scheme, p, i, pressed.pressure);
  set_random_velocities(p, 1e-8);
  Flow<Choice> flow(pressed.box, std::move(p));
  sph::History energy;
  const double step = scheme.time_step.longest_step;
  while (flow.liquid.time < 8 && (energy.value.empty() || energy.value.back() < level)) {
    energy.time.push_back(flow.liquid.time);
    energy.value.push_back(kinetic_energy(flow.liquid.particles));
    for (int i = 0; i < 4; ++i) flow.step(step);
  }
  return energy;
}

double predicted_growth(const PressedBox& pressed, double ratio) {
  return buckling_growth_in_box(scheme_at(ratio), cells, pressed.stiffness) * pressed.rate_unit;
}

double measured_growth(const PressedBox& pressed, double expected) {
  const double mass = pressed.density * pressed.box.length * pressed.box.height,
               level = buckled_energy(mass, pressed.box.spacing, expected);
  return growth_rate(energy_of_box(pressed, level), level);
}

double energy_kept(const PressedBox& pressed) {
  const sph::History energy = energy_of_box(pressed, 1);
  return energy.value.back() / energy.value.front();
}

sph::History energy_of_still_water(const std::string& variant, double ratio, double spacing,
                                   double duration) {
  sph::Scene scene = still_tank(depth, spacing);
  scene.duration = duration;
  scene.sample_interval = 0.01;
  scene.numbers.smoothing_length_ratio = ratio;
  scene.start_disorder = 1e-6;
  scene.threads = 1;
  scene.variant = variant;
  return sph::run("recommended", scene, {}).kinetic_energy;
}

double growth_at_bottom(double ratio, double spacing) {
  return buckling_growth(scheme_at(ratio), Lattice::square) * std::sqrt(gravity * depth) / spacing;
}

double measured_growth_of_still_water(double ratio, double spacing) {
  const double expected = growth_at_bottom(ratio, spacing);
  return growth_rate(energy_of_still_water(Choice::variant, ratio, spacing, 25 / expected),
                     buckled_energy(rest_density * depth, spacing, expected));
}

// The kinetic energy at the end of two seconds over the largest of the first tenth of a second.
double energy_kept_in_still_water(const std::string& variant, double ratio) {
  const sph::History energy = energy_of_still_water(variant, ratio, 0.02, 2);
  return energy.value.back() / *std::max_element(energy.value.begin(), energy.value.begin() + 11);
}

reports::Table table_of_windows() {
  reports::Table table{
      "lattice_buckling-windows",
      "h / dp at which a lattice holds",
      fmt::format("By the analysis, from {} to {}.", searched_ratios.low, searched_ratios.high),
      {"kernel", "square lattice", "hexagonal lattice", "both"},
      {}};
  const auto words = [](const std::vector<Window>& windows) {
    std::string text;
    for (const Window& one : windows)
      text += fmt::format("{}{:.2f} to {:.2f}", text.empty() ? "" : ", ", one.low, one.high);
    return text.empty() ? std::string("none") : text;
  };
  for (const NamedKernel& kernel : kernels_of_schemes()) {
    const LatticeScheme scheme{kernel.gradient_shape, 0};
    const auto square = windows_that_hold(scheme, Lattice::square),
               hexagonal = windows_that_hold(scheme, Lattice::hexagonal);
    table.rows.push_back(
        {kernel.name, words(square), words(hexagonal), words(common_windows(square, hexagonal))});
  }
  return table;
}

reports::Figure figure_of_growth() {
  reports::Figure figure;
  figure.id = "lattice_buckling-growth";
  figure.title = "Growth of the fastest wave of the square lattice";
  figure.caption =
      "The terms of `recommended` under one pressure p0 = rho c0^2 / 100. Its own kernel is the "
      "Kaiser-Bessel kernel at h / dp = 1.5.";
  figure.x_label = "h / dp";
  figure.y_label = "growth dp / sqrt(p0 / rho)";
  reports::Curve quintic{"quintic B-spline", {}, {}, {}, reports::Curve::Style::line},
      recommended{"Kaiser-Bessel", {}, {}, {}, reports::Curve::Style::line};
  for (int i = 0; i <= 70; ++i) {
    const double ratio = 1.2 + 0.02 * i;
    quintic.x.push_back(ratio);
    quintic.y.push_back(buckling_growth(scheme_at(ratio), Lattice::square));
    recommended.x.push_back(ratio);
    recommended.y.push_back(
        buckling_growth(scheme_at<sph::Recommended::Kernel>(ratio), Lattice::square));
  }
  figure.curves = {std::move(quintic), std::move(recommended)};
  return figure;
}

ProblemOutcome run(bool quick) {
  ProblemOutcome outcome{{{"growth", {}}, {"held", {}}, {"still_water", {}}, {"held_water", {}}},
                         {figure_of_growth()},
                         {table_of_windows()}};
  reports::Curve measured{"quintic B-spline, solver", {}, {}, {}, reports::Curve::Style::points};
  for (const double ratio : {2.2, 1.7, 1.6, 1.5}) {
    const PressedBox pressed = pressed_box(ratio);
    const double expected = predicted_growth(pressed, ratio),
                 found = measured_growth(pressed, expected);
    outcome.measures[0].errors.push_back({ratio, found / expected - 1});
    measured.x.push_back(ratio);
    measured.y.push_back(found / pressed.rate_unit);
  }
  outcome.figures[0].curves.push_back(std::move(measured));
  for (const double ratio : {1.96, 1.88, 1.8, 1.42, 1.36, 1.28})
    outcome.measures[1].errors.push_back({ratio, energy_kept(pressed_box(ratio))});
  for (const double spacing : quick ? std::vector{0.04, 0.02} : std::vector{0.04, 0.02, 0.01})
    outcome.measures[2].errors.push_back(
        {spacing / depth,
         measured_growth_of_still_water(1.5, spacing) / growth_at_bottom(1.5, spacing) - 1});
  outcome.measures[3].errors = {{1.5, energy_kept_in_still_water("", 1.5)},
                                {1.42, energy_kept_in_still_water(Choice::variant, 1.42)}};
  return outcome;
}

}  // namespace

Problem lattice_buckling_problem() {
  return {
      "lattice_buckling",
      "Stability: smoothing lengths that hold a square lattice",
      "A full box of 16 x 16 particles under one pressure, with random velocities of 1e-8 m/s, "
      "and water at rest in a tank 1 m wide and 0.36 m deep, whose particles start up to 1e-6 dp "
      "off their lattice.",
      "von Neumann's analysis of the momentum sum under a background pressure (Press et al. "
      "2007, section 20.1, for the method)",
      "The growth of the fastest wave, which comes from the second derivatives of the kernel; "
      "at the bottom of the tank for water at rest.",
      {{"growth", "1", "h / dp", "growth rate in the box over that of the analysis, less 1", false},
       {"held", "1", "h / dp",
        "kinetic energy after 8 s over that of the start, where the lattice holds", false},
       {"still_water", "1", "dp / depth",
        "growth rate in still water at h = 1.5 dp over that of the analysis at the bottom, "
        "less 1",
        false},
       {"held_water", "1", "h / dp",
        "kinetic energy of still water after 2 s over the largest in the first 0.1 s: of the "
        "quintic at 1.42, of `recommended` at 1.5",
        false}},
      &run,
      10};
}

}  // namespace slosh
