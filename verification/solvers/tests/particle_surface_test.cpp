#include "verification/solvers/particles/particle_surface.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sph/recording/free_surface.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/walls/frames.hpp"
#include "verification/solvers/sph_scene.hpp"
#include "verification/tests/sample_case.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::particle_surface_test {
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
  return surface_series(read_particle_table(workspace.write("p.csv", table), columns),
                        {frame, run.particle_spacing}, definition);
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

}  // namespace
}  // namespace slosh::particle_surface_test
