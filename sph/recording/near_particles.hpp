// The particles near a place, each with its kernel weight, for the instruments that average over
// them: Wendland C2 over three particle spacings.
#pragma once

#include <cmath>

#include "sph/neighbours/particles.hpp"
#include "sph/scene.hpp"
#include "sph/terms/kernels.hpp"
#include "sph/walls/line_of_sight.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

// The weights W(r) [1/m2] about a place, of which the integral over the plane is one.
class WeightsAbout {
 public:
  explicit WeightsAbout(double spacing)
      : radius_(3 * spacing),
        h_(radius_ / kernel_support),
        scale_(WendlandC2::normalisation / (h_ * h_)) {}

  double radius() const { return radius_; }
  // Returns 0 beyond the radius.
  double at(double dx, double dz) const {
    const double distance2 = dx * dx + dz * dz;
    if (!(distance2 < radius_ * radius_)) return 0;
    return scale_ * WendlandC2::shape(std::sqrt(distance2) / h_);
  }

 private:
  double radius_, h_, scale_;
};

// Returns the line of sight past the scene's obstacles that are thinner than the instruments'
// radius. An instrument counts what it sees from its place.
LineOfSight sight_of_instruments(const Scene& scene);

// Calls visit(i, share, dx, dz) for every particle within three spacings of the place: `share` is
// its volume times its weight, and (dx, dz) leads from it to the place. Particles that are not seen
// from the place do not count.
template <class Visit>
void for_each_near(const Particles& p, Vector2 place, double spacing, const LineOfSight& sight,
                   const Visit& visit) {
  const WeightsAbout weights(spacing);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double dx = place.x - p.x[i], dz = place.z - p.z[i];
    if (const double weight = weights.at(dx, dz); weight > 0 && sight.sees(place, {p.x[i], p.z[i]}))
      visit(i, p.mass[i] / p.density[i] * weight, dx, dz);
  }
}

}  // namespace slosh::sph
