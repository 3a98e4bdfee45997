#include "verification/solvers/particles/particle_surface.hpp"

#include "sph/recording/free_surface.hpp"

namespace slosh {
namespace {

// The measurement reads positions, volumes and the spacing alone.
sph::Particles particles_of(const ParticlesAt& moment, double spacing) {
  sph::Particles p;
  p.lattice_spacing = spacing;
  p.x.assign(moment.x.begin(), moment.x.end());
  p.z.assign(moment.z.begin(), moment.z.end());
  p.mass.assign(moment.x.size(), spacing * spacing);
  for (std::size_t i = 0; i < moment.volume.size(); ++i) p.mass[i] = moment.volume[i];
  p.density.assign(moment.x.size(), 1.0);
  return p;
}

}  // namespace

std::vector<TimeSeries> surface_series(const std::vector<ParticlesAt>& moments, double spacing,
                                       const CaseDefinition& definition) {
  std::vector<TimeSeries> all;
  for (const GaugeDefinition& gauge : definition.gauges)
    for (const char* quantity : {"elevation@", "highest_surface@"})
      all.push_back({quantity + gauge.name, "m", {}, {}});
  const double length = definition.tank.length, depth = definition.liquid.fill_depth;
  for (const ParticlesAt& moment : moments) {
    const sph::Particles p = particles_of(moment, spacing);
    for (std::size_t k = 0; k < definition.gauges.size(); ++k) {
      const double x = definition.gauges[k].x;
      const auto push = [&](TimeSeries& series, double value) {
        series.time.push_back(moment.time);
        series.value.push_back(value);
      };
      push(all[2 * k], sph::surface_elevation(p, length, depth, x));
      push(all[2 * k + 1], sph::highest_surface(p, depth, x));
    }
  }
  return all;
}

}  // namespace slosh
