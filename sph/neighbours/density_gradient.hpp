// The renormalised density gradient of Antuono et al. 2010, eq. 3:
//   grad rho_a = L_a sum_b V_b (rho_b - rho_a) grad_a W_ab,
//   L_a = [ sum_b V_b (r_b - r_a) (x) grad_a W_ab ]^-1,
// which is exact for a linear density. An image has its owner's gradient, whose deviation from the
// hydrostatic gradient is reflected. The particles of solids have the hydrostatic gradient.
#pragma once

#include <vector>

#include "sph/neighbours/cluster_lists.hpp"
#include "sph/neighbours/instruction_sets.hpp"
#include "sph/neighbours/lanes.hpp"
#include "sph/neighbours/neighbour_sources.hpp"
#include "sph/neighbours/particles.hpp"
#include "sph/neighbours/two_sources.hpp"
#include "sph/terms/kernels.hpp"

namespace slosh::sph {

struct SourceGradient {
  double x, z;  // [kg/m4]
};

struct DensityGradient {
  Array<double> x, z;                      // of the particles [kg/m4]
  std::vector<SourceGradient> of_sources;  // in their order

  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    visit("density_gradient_x", x);
    visit("density_gradient_z", z);
    visit("density_gradient_of_sources", of_sources);
  }
};

// (dW/dr)/r of a pair [1/m4] is gradient_scale times the kernel's gradient_shape; `inverse_h` is
// 1/h [1/m].
template <class Kernel, class Length>
inline Length gradient_scale(Length inverse_h) {
  const Length inverse_h2 = inverse_h * inverse_h;
  return Kernel::normalisation * inverse_h2 * inverse_h2;
}
template <class Kernel, class Number, class Length>
inline Number gradient_over_distance(Number distance2, Length inverse_h) {
  return gradient_scale<Kernel>(inverse_h) * gradient_shape_of_pair<Kernel>(distance2, inverse_h);
}

// sum_b V_b (r_b - r_a) (x) grad_a W_ab, which is the identity inside the liquid.
template <Vector Number>
struct Renormalisation {
  Number xx{}, xz{}, zz{};

  // Adds a pair at (dx, dz) = r_a - r_b, where `f` is V_b (dW/dr)/r.
  template <class NumberOrTwo>
  void add(NumberOrTwo f, NumberOrTwo dx, NumberOrTwo dz) {
    xx -= f * dx * dx;
    xz -= f * dx * dz;
    zz -= f * dz * dz;
  }
  // Returns the inverse of the determinant, or 0 for a drop of a few particles, which defines no
  // gradient. The determinant is 1 inside the liquid.
  Number inverse_determinant() const {
    constexpr double least = 0.01;
    const Number determinant = xx * zz - xz * xz;
    return determinant > least - Number{} ? 1.0 / determinant : Number{};
  }
};

// The template depends on the kernel alone, so that schemes share its builds.
template <class Kernel>
struct DensityGradientOfCluster {
  template <Vector Number>
  static void run(double inverse_h, const Cluster* cluster, const Source* sources,
                  const Particles* particles, DensityGradient* gradient) {
    const Particles& p = *particles;
    for (std::size_t i = cluster->first; i < cluster->first + cluster->size;
         i += lanes_of<Number>) {
      const std::size_t count = cluster->first + cluster->size - i;
      const Number x = load<Number>(&p.x[i]), z = load<Number>(&p.z[i]),
                   rho = load<Number>(&p.density[i]);
      Renormalisation<Number> support;
      Number sum_x{}, sum_z{};
      const auto add = [&](const auto& b, std::size_t) {
        const auto dx = x - b.x, dz = z - b.z;
        const auto f = b.weight * gradient_over_distance<Kernel>(dx * dx + dz * dz, inverse_h);
        support.add(f, dx, dz);
        sum_x += f * (b.density - rho) * dx;
        sum_z += f * (b.density - rho) * dz;
      };
      for_two_sources_each(*cluster, sources, cluster->source_count, add);
      const Number scale = support.inverse_determinant();
      store(&gradient->x[i], scale * (support.zz * sum_x - support.xz * sum_z), count);
      store(&gradient->z[i], scale * (support.xx * sum_z - support.xz * sum_x), count);
    }
  }
};

template <class Scheme>
void sum_density_gradient(const Scheme& scheme, const NeighbourSources& neighbours,
                          const Particles& particles, const Tank& tank, DensityGradient& gradient,
                          InstructionSet set) {
  gradient.x.resize(particles.size());
  gradient.z.resize(particles.size());
  neighbours.clusters().for_each([&](const Cluster& cluster) {
    call_in_registers<DensityGradientOfCluster<typename Scheme::Kernel>>(
        set, scheme.smoothing.inverse_length, &cluster, neighbours.sources(), &particles,
        &gradient);
  });
  const double sound = scheme.state.speed_of_sound;
  const double compressibility = scheme.setting.rest_density / (sound * sound);  // d rho / d(p/rho)
  gradient.of_sources.resize(neighbours.source_count());
  // The gradient of the hydrostatic density of a liquid at rest relative to the wall.
  const auto at_wall = [&](double x, double z, double u, double w) {
    const Vector2 gravity = tank.apparent_gravity(scheme.setting.gravity, x, z, u, w);
    return Vector2{compressibility * gravity.x, compressibility * gravity.z};
  };
  const Particles& p = particles;
  neighbours.for_each_image<typename Scheme::Mirror>(
      tank, [&](std::size_t k, std::size_t i, const MirrorMap& map) {
        const Vector2 wall = at_wall(p.x[i], p.z[i], p.velocity_x[i], p.velocity_z[i]);
        gradient.of_sources[k] = {map.scale_x * gradient.x[i] + (1 - map.scale_x) * wall.x,
                                  map.scale_z * gradient.z[i] + (1 - map.scale_z) * wall.z};
      });
  for (std::size_t k = neighbours.first_solid_source(); k < neighbours.source_count(); ++k) {
    const Source& solid = neighbours.sources()[k];
    const Vector2 wall = at_wall(solid.x, solid.z, 0, 0);
    gradient.of_sources[k] = {wall.x, wall.z};
  }
}

}  // namespace slosh::sph
