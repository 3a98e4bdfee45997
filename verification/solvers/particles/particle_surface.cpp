#include "verification/solvers/particles/particle_surface.hpp"

#include <cmath>
#include <optional>

#include "sph/recording/free_surface.hpp"
#include "verification/case/motion.hpp"

namespace slosh {
namespace {

// Moves places in the earth's frame to those in the tank, which rolls about an axis that surges.
class IntoTank {
 public:
  explicit IntoTank(const CaseDefinition& definition)
      : surge_(surge_motion(definition)), roll_(roll_motion(definition)) {}

  void move(double time, sph::Particles& p) const {
    const double shift = surge_.displacement(time), angle = roll_ ? roll_->angle(time) : 0,
                 axis_x = roll_ ? roll_->axis_x : 0, axis_z = roll_ ? roll_->axis_z : 0,
                 cosine = std::cos(angle), sine = std::sin(angle);
    for (std::size_t i = 0; i < p.x.size(); ++i) {
      const double x = p.x[i] - shift - axis_x, z = p.z[i] - axis_z;
      p.x[i] = axis_x + cosine * x + sine * z;
      p.z[i] = axis_z - sine * x + cosine * z;
    }
  }

 private:
  SurgeMotion surge_;
  std::optional<RollMotion> roll_;
};

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

std::vector<TimeSeries> surface_series(const std::vector<ParticlesAt>& moments,
                                       const ParticleMeaning& of,
                                       const CaseDefinition& definition) {
  std::vector<TimeSeries> all;
  for (const GaugeDefinition& gauge : definition.gauges)
    for (const char* quantity : {"elevation@", "highest_surface@"})
      all.push_back({quantity + gauge.name, "m", {}, {}});
  const IntoTank into_tank(definition);
  const double length = definition.tank.length, depth = definition.liquid.fill_depth;
  for (const ParticlesAt& moment : moments) {
    sph::Particles p = particles_of(moment, of.spacing);
    if (of.frame == PositionsIn::earth) into_tank.move(moment.time, p);
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
