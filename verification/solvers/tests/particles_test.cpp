#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "sph/recording/free_surface.hpp"
#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/walls/frames.hpp"
#include "verification/solvers/particles/artificial_viscosity.hpp"
#include "verification/solvers/particles/particle_surface.hpp"
#include "verification/solvers/particles/particles_in_tank.hpp"
#include "verification/solvers/sph_scene.hpp"
#include "verification/tests/sample_case.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::particles_test {
namespace {

const SphRun run{"recommended", 0.025, 0.025};

CaseDefinition waved_case() {
  CaseDefinition definition = sample_case();
  definition.motion.roll = RollDefinition{
      SineMotion{.amplitude = 0.1, .angular_frequency = 2, .ramp_periods = 0}, 0.4, 0.1};
  definition.initial_wave = InitialWaveDefinition{1, 0.03};
  return definition;
}

// Particles under a wave, each with a volume of its own.
sph::Particles liquid(const CaseDefinition& definition) {
  sph::Particles p =
      sph::initial_lattice(sph_scene(definition, run), [](double) { return 1000.0; });
  for (std::size_t i = 0; i < p.size(); ++i) p.density[i] *= 1 + 0.05 * std::sin(40 * p.x[i]);
  return p;
}

struct Place {
  double x, z;
};

template <class PlaceOf>
std::string table_of(const sph::Particles& p, double time, const PlaceOf& place_of) {
  std::string text = "time,x,z,volume\n";
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Place place = place_of(p.x[i], p.z[i]);
    text += fmt::format("{},{},{},{}\n", time, place.x, place.z, p.mass[i] / p.density[i]);
  }
  return text;
}

std::vector<TimeSeries> measured(const std::string& table, const CaseDefinition& definition,
                                 PositionsIn frame, const std::string& volume = "volume") {
  const Workspace workspace;
  ParticleColumns columns;
  columns.volume = volume;
  const auto moments =
      in_tank(read_particle_table(workspace.write("p.csv", table), columns), frame, definition);
  return surface_series(moments, run.particle_spacing, definition);
}

// The gauges of our own runs read the same numbers from the same particles.
TEST(ParticleSurface, IsThatOfOurOwnGauges) {
  const CaseDefinition definition = waved_case();
  const sph::Particles p = liquid(definition);
  const auto series = measured(table_of(p, 0.3,
                                        [](double x, double z) {
                                          return Place{x, z};
                                        }),
                               definition, PositionsIn::tank);
  ASSERT_EQ(series.size(), 2 * definition.gauges.size());
  for (std::size_t k = 0; k < definition.gauges.size(); ++k) {
    const GaugeDefinition& gauge = definition.gauges[k];
    EXPECT_EQ(series[2 * k].name, "elevation@" + gauge.name);
    EXPECT_EQ(series[2 * k + 1].name, "highest_surface@" + gauge.name);
    EXPECT_EQ(series[2 * k].time, std::vector<double>{0.3});
    EXPECT_NEAR(series[2 * k].value.front(), sph::surface_elevation(p, 1, 0.35, gauge.x), 1e-12);
    EXPECT_NEAR(series[2 * k + 1].value.front(), sph::highest_surface(p, 0.35, gauge.x), 1e-12);
  }
  EXPECT_GT(series[0].value.front(), 0.01);   // under the crest
  EXPECT_LT(series[2].value.front(), -0.01);  // in the trough
}

// The places in the earth's frame are those of SPH's own frames.
TEST(ParticleSurface, TakesTheMotionOffPositionsInTheEarthsFrame) {
  const CaseDefinition definition = waved_case();
  const sph::Particles p = liquid(definition);
  const double time = 0.7;
  const auto tank = sph::RollingEarthFrame::tank(sph_scene(definition, run), time);
  const auto in_earth = [&](double x, double z) {
    const sph::Vector2 place = tank.in_frame(x, z);
    return Place{place.x, place.z};
  };
  EXPECT_GT(std::abs(in_earth(0.9, 0.3).z - 0.3), 0.01);
  const auto series = measured(table_of(p, time, in_earth), definition, PositionsIn::earth);
  for (std::size_t k = 0; k < definition.gauges.size(); ++k)
    EXPECT_NEAR(series[2 * k].value.front(),
                sph::surface_elevation(p, 1, 0.35, definition.gauges[k].x), 1e-9);
}

TEST(ParticleSurface, GivesAParticleWithoutAVolumeThatOfItsCell) {
  CaseDefinition definition = sample_case();
  const sph::Particles p =
      sph::initial_lattice(sph_scene(definition, run), [](double) { return 1000.0; });
  const std::string table = table_of(p, 0, [](double x, double z) { return Place{x, z}; });
  for (const TimeSeries& series : measured(table, definition, PositionsIn::tank, ""))
    EXPECT_NEAR(series.value.front(), 0, 1e-12) << series.name;
}

using std::numbers::pi;

struct GaugePlace {
  double x, z;
};

// Places of a lattice with the spacing 1, each moved by up to `disorder` along x and along z.
std::vector<GaugePlace> places(int side, double disorder) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> move(-disorder, disorder);
  std::vector<GaugePlace> all;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) all.push_back({i + move(generator), j + move(generator)});
  return all;
}

// The slope of the kernel, 2-D, of support 2 h.
double cubic_spline(double r, double h) {
  const double q = r / h, share = q < 1   ? -3 * q + 2.25 * q * q
                                  : q < 2 ? -0.75 * (2 - q) * (2 - q)
                                          : 0;
  return 10 / (7 * pi * h * h * h) * share;
}
double wendland_c2(double r, double h) {
  const double q = r / h;
  return q < 2 ? -5 * q * std::pow(1 - q / 2, 3) * 7 / (4 * pi * h * h * h) : 0;
}

// Returns the viscosity with which the pairs take the energy of a strain e (x cos 2a + ..., ...),
// e = 1e-6, in the mean over the particles and over the strain's directions: nu = power / (4 e^2)
// per mass of a Newtonian liquid in the plane. Lengths in spacings, densities 1.
template <class Viscosity, class Kernel>
double viscosity_of_pairs(const sph::Setting& setting, const std::vector<GaugePlace>& all, int side,
                          const Kernel& slope) {
  const Viscosity viscosity(setting);
  const double strain = 1e-6, h = setting.smoothing_length();
  double power = 0;
  int count = 0;
  for (const GaugePlace& a : all) {
    const bool inside = std::min(a.x, a.z) > 2 * h + 1 && std::max(a.x, a.z) < side - 2 * h - 2;
    if (!inside) continue;
    for (int turn = 0; turn < 16; ++turn, ++count)
      for (const GaugePlace& b : all) {
        const double x = a.x - b.x, z = a.z - b.z, r = std::hypot(x, z), angle = turn * pi / 16;
        if (r == 0 || r > 2 * h) continue;
        const double approach =
            strain * ((x * x - z * z) * std::cos(2 * angle) + 2 * x * z * std::sin(2 * angle));
        power += viscosity.pair(approach, r * r, h) * approach / r * slope(r, h) / 2;
      }
  }
  return power / count / (4 * strain * strain);
}

double expected_of(const std::string& scheme, const std::string& variant, double alpha) {
  SphRun run{scheme, 0.01, 0.01};
  run.variant = variant;
  run.numbers.artificial_viscosity = alpha;
  const double c0 = 10 * sph::expected_speed(sph_scene(sample_case(), run));
  return artificial_viscosity(sample_case(), run) / (0.01 * c0);
}

sph::Setting setting(double ratio, double alpha) {
  sph::Setting numbers{};
  numbers.particle_spacing = 1;
  numbers.smoothing_length_ratio = ratio;
  numbers.speed_of_sound = 1;
  numbers.artificial_viscosity = alpha;
  return numbers;
}

// The 0.01 h^2 in the pairs' denominator and the arrangement take up to 3 %.
TEST(ArtificialViscosity, IsThatOfThePairsOfALatticeAndOfDisorder) {
  constexpr int side = 20;
  constexpr double alpha = 0.3;
  for (const double disorder : {0.0, 0.3}) {
    const auto all = places(side, disorder);
    const double li = viscosity_of_pairs<sph::Li2010::Viscosity>(setting(1.5, alpha), all, side,
                                                                 cubic_spline),
                 zhao = viscosity_of_pairs<sph::Zhao2021Fixed::Viscosity>(setting(1.5, alpha), all,
                                                                          side, wendland_c2),
                 delta = viscosity_of_pairs<sph::DeltaSph::Viscosity>(setting(2, alpha), all, side,
                                                                      wendland_c2);
    EXPECT_NEAR(li / expected_of("li2010", "", alpha), 1, 0.05);
    EXPECT_NEAR(zhao / expected_of("zhao2021_fixed", "", alpha), 1, 0.05);
    EXPECT_NEAR(delta / expected_of("delta_sph", "", alpha), 1, 0.05);
  }
}

TEST(ArtificialViscosity, HasTheNumbersOfItsSchemeAndVariant) {
  const double all_pairs = 1.5 / 8;
  EXPECT_NEAR(expected_of("recommended", "", 1), all_pairs, 1e-12);
  EXPECT_NEAR(expected_of("recommended", "monaghan_viscosity", 1), all_pairs / 2, 1e-12);
  EXPECT_NEAR(expected_of("delta_sph", "", 1), 2.0 / 8, 1e-12);
  EXPECT_EQ(expected_of("recommended", "no_viscosity", 1), 0);
  SphRun wide{"li2010", 0.01, 0.01};
  EXPECT_EQ(artificial_viscosity(sample_case(), wide), 0);
  wide.numbers.artificial_viscosity = 1;
  const double usual = artificial_viscosity(sample_case(), wide);
  wide.numbers.smoothing_length_ratio = 3;
  wide.numbers.sound_speed_ratio = 20;
  EXPECT_NEAR(artificial_viscosity(sample_case(), wide), 4 * usual, 1e-12);
}

}  // namespace
}  // namespace slosh::particles_test
