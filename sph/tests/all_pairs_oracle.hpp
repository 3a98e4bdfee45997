// The right-hand sides of the papers' equations, summed over every particle, every one of its
// mirror images and every particle of the solids, without a neighbour search, and written out from
// the papers on their own: each term is a formula of a pair.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "sph/neighbours/particles.hpp"
#include "sph/setting.hpp"
#include "sph/walls/solid_particles.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

// A particle, an image of one, or a particle of a solid.
struct PairSource {
  double x, z, u, w;        // the velocity as the momentum equation has it
  double slide_u, slide_w;  // and as the continuity equation has it
  double density, mass, pressure, spacing;
  double diffused;                // the density that diffuses [kg/m3]
  double gradient_x, gradient_z;  // of that density [kg/m4]
  std::size_t owner = 0;          // whose image it is
  double side_x = 1, side_z = 1;  // -1 where it is reflected
  int face = -1;                  // of a thin obstacle, that it stands behind
  double volume() const { return mass / density; }
};

struct Pair {
  const PairSource &a, &b;
  double dx, dz, h;
  double r2() const { return dx * dx + dz * dz; }
  double approach() const { return (a.u - b.u) * dx + (a.w - b.w) * dz; }
  double slide() const { return (a.slide_u - b.slide_u) * dx + (a.slide_w - b.slide_w) * dz; }
};

// W h^2 of q = r / h, and its derivative.
struct KernelFormula {
  double (*value)(double q);
  double (*slope)(double q);
};

inline double power_of_rest(double whole, double q, int power) {
  return std::pow(std::max(0.0, whole - q), power);
}

// Monaghan & Lattanzio 1985, as Li et al. 2010 print it.
inline const KernelFormula cubic_formula{
    [](double q) {
      return 10 / (7 * std::numbers::pi) *
             (q < 1 ? 1 - 1.5 * q * q + 0.75 * q * q * q : 0.25 * power_of_rest(2, q, 3));
    },
    [](double q) {
      return 10 / (7 * std::numbers::pi) *
             (q < 1 ? -3 * q + 2.25 * q * q : -0.75 * power_of_rest(2, q, 2));
    }};

// Dehnen & Aly 2012, table 1, in two dimensions; their radius is the support, 2 h.
inline const KernelFormula wendland_c2_formula{
    [](double q) { return 7 / (4 * std::numbers::pi) * power_of_rest(1, q / 2, 4) * (1 + 2 * q); },
    [](double q) { return 7 / (4 * std::numbers::pi) * -5 * q * power_of_rest(1, q / 2, 3); }};
inline const KernelFormula wendland_c4_formula{[](double q) {
                                                 return 9 / (4 * std::numbers::pi) *
                                                        power_of_rest(1, q / 2, 6) *
                                                        (1 + 3 * q + 35.0 / 12 * q * q);
                                               },
                                               [](double q) {
                                                 return 9 / (4 * std::numbers::pi) * -14.0 / 3 * q *
                                                        (1 + 2.5 * q) * power_of_rest(1, q / 2, 5);
                                               }};
inline const KernelFormula wendland_c6_formula{
    [](double q) {
      return 78 / (28 * std::numbers::pi) * power_of_rest(1, q / 2, 8) *
             (1 + 4 * q + 6.25 * q * q + 4 * q * q * q);
    },
    [](double q) {
      return 78 / (28 * std::numbers::pi) * -5.5 * q * (1 + 3.5 * q + 4 * q * q) *
             power_of_rest(1, q / 2, 7);
    }};

// Morris, Fox & Zhu 1997, eq. 24, whose smoothing length is a third of the support.
inline const KernelFormula quintic_formula{
    [](double q) {
      const double s = 1.5 * q;
      return 2.25 * 7 / (478 * std::numbers::pi) *
             (power_of_rest(3, s, 5) - 6 * power_of_rest(2, s, 5) + 15 * power_of_rest(1, s, 5));
    },
    [](double q) {
      const double s = 1.5 * q;
      return 1.5 * 2.25 * 7 / (478 * std::numbers::pi) * -5 *
             (power_of_rest(3, s, 4) - 6 * power_of_rest(2, s, 4) + 15 * power_of_rest(1, s, 4));
    }};

// A fitted polynomial, which terms_test.cpp compares with the Bessel function.
inline const KernelFormula kaiser_bessel_formula{
    [](double q) { return KaiserBessel::normalisation * KaiserBessel::shape(q); },
    [](double q) { return KaiserBessel::normalisation * q * KaiserBessel::gradient_shape(q); }};

// Monaghan 1994; Antuono et al. 2010, eq. 1.
inline double tait_pressure(const Setting& s, double density) {
  return s.rest_density * std::pow(s.speed_of_sound, 2) / 7 *
         (std::pow(density / s.rest_density, 7) - 1);
}
inline double linear_pressure(const Setting& s, double density) {
  return std::pow(s.speed_of_sound, 2) * (density - s.rest_density);
}

// Pi_ab times the density: none; Monaghan 1992, eqs 4.1 and 4.2, beta = alpha; Antuono et al. 2010;
// Monaghan 2005, section 8.5.
inline double inviscid(const Setting&, const Pair&) { return 0; }
inline double monaghan_viscous(const Setting& s, const Pair& pair) {
  if (pair.approach() >= 0) return 0;
  const double mu = pair.h * pair.approach() / (pair.r2() + 0.01 * pair.h * pair.h);
  return -s.artificial_viscosity * s.speed_of_sound * mu + s.artificial_viscosity * mu * mu;
}
inline double linear_viscous(const Setting& s, const Pair& pair) {
  return -s.artificial_viscosity * s.speed_of_sound * pair.h * pair.approach() /
         (pair.r2() + 0.01 * pair.h * pair.h);
}
// von Neumann and Richtmyer's quadratic term beside the linear one (Monaghan 1992, eq. 4.1, beta
// 1).
inline double impact_viscous(const Setting& s, const Pair& pair) {
  const double mu = pair.h * pair.approach() / (pair.r2() + 0.01 * pair.h * pair.h);
  return linear_viscous(s, pair) + (mu < 0 ? mu * mu : 0);
}
inline double laminar_viscous(const Setting& s, const Pair& pair) {
  return -8 * s.kinematic_viscosity * pair.approach() / (pair.r2() + 0.01 * pair.h * pair.h);
}

// What diffuses: nothing; the density (Molteni & Colagrossi 2009); that above the hydrostatic one
// (Fourtakas et al. 2019); that beyond its renormalised gradient (Antuono et al. 2010).
enum class Diffuses { nothing, density, dynamic_density, beyond_gradient };

// The image's velocity and pressure: normal velocity turned and hydrostatic; that in both
// components in the momentum equation alone; that everywhere, with the owner's pressure (Li); or
// none, the walls being of particles.
enum class Images { free_slip, sticking, of_li, none };

// Of solids' particles: there are none, extrapolated with or without slip, or with a density of
// their own.
enum class SolidFormula { none, ghost_free_slip, ghost_no_slip, dynamic };

struct Formulas {
  KernelFormula kernel;
  bool volumes;  // p_a + p_b with volumes, or p/rho^2 with masses
  double (*pressure)(const Setting&, double density);
  double (*viscous)(const Setting&, const Pair&);
  Diffuses diffuses;
  Images images;
  SolidFormula solids;
};

class AllPairs {
 public:
  AllPairs(const Setting& setting, const Formulas& formulas, const Particles& p,
           const TankWalls& walls)
      : s_(setting), f_(formulas), walls_(walls), count_(p.size()) {
    for (std::size_t i = 0; i < count_; ++i) {
      add_with_pressure({p.x[i], p.z[i], p.velocity_x[i], p.velocity_z[i], p.velocity_x[i],
                         p.velocity_z[i], p.density[i], p.mass[i], 0, p.spacing_of(i), 0, 0, 0, i});
    }
    if (f_.images != Images::none)
      for (std::size_t i = 0; i < count_; ++i) add_images(i);
  }

  // Returns the face that hides the second of two places in the tank from the first, or -1.
  using HidingFace = std::function<int(Vector2 from, Vector2 to)>;
  // Only what is not hidden counts from now on, and of the solids behind faces only what the very
  // face hides.
  void hide(HidingFace hiding_face) { hiding_face_ = std::move(hiding_face); }

  // `density`: of dynamic particles.
  void add_solids(const std::vector<SolidPlace>& places, const Array<double>& density) {
    const std::vector<PairSource> liquid = sources_;
    first_solid_ = sources_.size();
    const double dp = s_.particle_spacing, rho = s_.rest_density, c2 = std::pow(sound(), 2);
    for (std::size_t k = 0; k < places.size(); ++k) {
      PairSource b{.x = walls_.left + places[k].x,
                   .z = walls_.bottom + places[k].z,
                   .u = walls_.velocity,
                   .w = 0,
                   .slide_u = walls_.velocity,
                   .slide_w = 0,
                   .density = rho,
                   .mass = places[k].cell_share * rho * dp * dp,
                   .pressure = 0,
                   .spacing = dp,
                   .diffused = 0,
                   .gradient_x = 0,
                   .gradient_z = 0,
                   .face = places[k].face};
      if (f_.solids == SolidFormula::dynamic) {
        // The volume is the lattice's.
        b.density = density[k];
        b.mass = density[k] * dp * dp;
        add_with_pressure(b);
        continue;
      }
      const Extrapolation at_node = extrapolate(liquid, places[k]);
      if (!places[k].in_obstacle) b.mass *= share_of_ghost(places[k], at_node.liquid, places);
      const double rise = -rho * (walls_.acceleration * (places[k].x - places[k].node_x) +
                                  s_.gravity * (places[k].z - places[k].node_z));
      b.diffused = hydrostatic_diffused(b.z);
      if (at_node.found) {
        b.pressure = at_node.pressure + rise;
        b.diffused = at_node.diffused;
        if (f_.diffuses != Diffuses::dynamic_density) b.diffused += rise / c2;
        const bool no_slip = f_.solids == SolidFormula::ghost_no_slip;
        b.u = places[k].turn.xx < 0 || no_slip ? 2 * walls_.velocity - at_node.u : at_node.u;
        b.w = places[k].turn.zz < 0 || no_slip ? -at_node.w : at_node.w;
        if (!places[k].in_obstacle) {
          b.slide_u = places[k].turn.xx < 0 ? 2 * walls_.velocity - at_node.u : at_node.u;
          b.slide_w = places[k].turn.zz < 0 ? -at_node.w : at_node.w;
        }
      }
      sources_.push_back(b);
    }
  }

  // Antuono et al. 2010, eq. 1, or Li et al. 2010, eqs 6 to 8.
  Rates rates() {
    if (f_.diffuses == Diffuses::beyond_gradient) find_gradients();
    Rates rates;
    rates.resize(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      rates.acceleration_z[i] = -s_.gravity;
      for_each_neighbour(sources_[i], [&](const Pair& pair, double slope_over_r) {
        const double stress = pair_stress(pair);
        rates.acceleration_x[i] -= stress * slope_over_r * pair.dx;
        rates.acceleration_z[i] -= stress * slope_over_r * pair.dz;
      });
      rates.density_rate[i] = density_rate(sources_[i]);
    }
    return rates;
  }

  double density_rate_of_solid(std::size_t k) const {
    return density_rate(sources_[first_solid_ + k]);
  }

 private:
  struct Extrapolation {
    bool found = false;
    double pressure = 0, diffused = 0, u = 0, w = 0;
    double liquid = 0;  // sum of V_b W of the liquid
  };

  double sound() const { return s_.speed_of_sound; }

  double hydrostatic_diffused(double z) const {
    const double hydrostatic = s_.rest_density * s_.gravity * (s_.fill_depth - z);
    return f_.diffuses == Diffuses::dynamic_density ? -hydrostatic / std::pow(sound(), 2)
                                                    : s_.rest_density;
  }

  void add_with_pressure(PairSource b) {
    b.pressure = f_.pressure(s_, b.density);
    b.diffused = b.density;
    if (f_.diffuses == Diffuses::dynamic_density)
      b.diffused = b.pressure / std::pow(sound(), 2) + hydrostatic_diffused(b.z);
    sources_.push_back(b);
  }

  void add_images(std::size_t i) {
    const PairSource own = sources_[i];
    for (double wall_x : {walls_.left, walls_.right})
      sources_.push_back(reflected_sideways(own, wall_x));
    for (double wall_z : {walls_.bottom, walls_.roof}) {
      const PairSource image = reflected_vertically(own, wall_z);
      sources_.push_back(image);
      for (double wall_x : {walls_.left, walls_.right})
        sources_.push_back(reflected_sideways(image, wall_x));
    }
  }

  void raise_pressure(PairSource& image, double rise) const {
    if (f_.images == Images::of_li) return;
    image.pressure += rise;
    if (f_.diffuses != Diffuses::dynamic_density) image.diffused += rise / std::pow(sound(), 2);
  }

  PairSource reflected_sideways(PairSource image, double wall_x) const {
    const double owner_x = image.x;
    image.x = 2 * wall_x - owner_x;
    image.side_x = -1;
    image.u = 2 * walls_.velocity - image.u;
    image.slide_u = 2 * walls_.velocity - image.slide_u;
    if (f_.images != Images::free_slip) image.w = -image.w;
    if (f_.images == Images::of_li) image.slide_w = -image.slide_w;
    raise_pressure(image, -image.density * walls_.acceleration * (image.x - owner_x));
    return image;
  }

  PairSource reflected_vertically(PairSource image, double wall_z) const {
    const double owner_z = image.z;
    image.z = 2 * wall_z - owner_z;
    image.side_z = -1;
    image.w = -image.w;
    image.slide_w = -image.slide_w;
    if (f_.images != Images::free_slip) image.u = 2 * walls_.velocity - image.u;
    if (f_.images == Images::of_li) image.slide_u = 2 * walls_.velocity - image.slide_u;
    raise_pressure(image, -image.density * s_.gravity * (image.z - owner_z));
    return image;
  }

  // The value at the node of the plane that fits best, weighted by V W (Marrone et al. 2011, eq.
  // 12); the mean where the neighbours lie on a line or nearly so.
  Extrapolation extrapolate(const std::vector<PairSource>& liquid, const SolidPlace& place) const {
    const double h = s_.smoothing_length();
    std::array<std::array<double, 3>, 3> m{};
    std::array<std::array<double, 3>, 4> right{};  // of pressure, diffused, u, w
    for (const PairSource& b : liquid) {
      const double dx = (b.x - walls_.left - place.node_x) / h,
                   dz = (b.z - walls_.bottom - place.node_z) / h;
      if (!counts({place.node_x, place.node_z}, b)) continue;
      const double weight = b.volume() * f_.kernel.value(std::hypot(dx, dz));
      const std::array<double, 3> basis{1, dx, dz};
      const std::array<double, 4> values{b.pressure, b.diffused, b.u, b.w};
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
          m[row][column] += weight * basis[row] * basis[column];
        for (int field = 0; field < 4; ++field)
          right[field][row] += weight * basis[row] * values[field];
      }
    }
    if (!(m[0][0] > 0)) return {};
    const auto value = [&](int field) {
      auto first_replaced = m;
      for (int row = 0; row < 3; ++row) first_replaced[row][0] = right[field][row];
      const bool flat = determinant(m) <= 1e-3 * std::pow(m[0][0], 3);
      return flat ? right[field][0] / m[0][0] : determinant(first_replaced) / determinant(m);
    };
    return {true, value(0), value(1), value(2), value(3), m[0][0] / (h * h)};
  }

  // A ghost counts whole where the liquid's kernel sum at its node, over what the solids leave of
  // it, is that half a spacing inside a surface, and not at all half a spacing outside. The sum
  // falls across the surface by the kernel's integral along it.
  double share_of_ghost(const SolidPlace& at, double liquid,
                        const std::vector<SolidPlace>& places) const {
    const double h = s_.smoothing_length(), dp = s_.particle_spacing;
    double solid = 0;
    for (const SolidPlace& b : places) {
      const double dx = (b.x - at.node_x) / h, dz = (b.z - at.node_z) / h;
      if (hiding_face_ && hiding_face_({at.node_x, at.node_z}, {b.x, b.z}) != b.face) continue;
      if (dx * dx + dz * dz < 4)
        solid += b.cell_share * dp * dp / (h * h) * f_.kernel.value(std::hypot(dx, dz));
    }
    return std::clamp((liquid / (1 - solid) - 0.5) / (dp * kernel_along_a_line_) + 0.5, 0.0, 1.0);
  }

  double kernel_along_a_line() const {
    double sum = 0;
    for (double q = -1.9995; q < 2; q += 0.001) sum += f_.kernel.value(std::abs(q));
    return 0.001 * sum / s_.smoothing_length();
  }

  bool counts(Vector2 from, const PairSource& b) const {
    if (!hiding_face_) return true;
    return hiding_face_(from, {b.x - walls_.left, b.z - walls_.bottom}) == b.face;
  }

  static double determinant(const std::array<std::array<double, 3>, 3>& m) {
    double sum = 0;
    for (int i = 0; i < 3; ++i)
      sum +=
          m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3]);
    return sum;
  }

  // Calls visit(pair, (dW/dr)/r) for all sources within the kernel's support but a itself.
  template <class Visit>
  void for_each_neighbour(const PairSource& a, const Visit& visit) const {
    for (const PairSource& b : sources_) {
      const double h = s_.smoothing_length_ratio * (a.spacing + b.spacing) / 2;
      const Pair pair{a, b, a.x - b.x, a.z - b.z, h};
      const double r2 = pair.r2();
      if (r2 == 0 || r2 >= 4 * h * h) continue;
      if (!counts({a.x - walls_.left, a.z - walls_.bottom}, b)) continue;
      const double r = std::sqrt(r2);
      visit(pair, f_.kernel.slope(r / h) / (h * h * h) / r);
    }
  }

  // In the formulation with masses all that the diffusion knows of a volume is the mass.
  double diffusing_volume(const PairSource& b) const {
    return f_.volumes ? b.volume() : b.mass / s_.rest_density;
  }

  double pair_stress(const Pair& pair) const {
    const auto& [a, b, dx, dz, h] = pair;
    const double viscous = f_.viscous(s_, pair);
    if (f_.volumes)
      return b.volume() * (a.pressure + b.pressure + s_.rest_density * viscous) / a.density;
    return b.mass * (a.pressure / (a.density * a.density) + b.pressure / (b.density * b.density) +
                     viscous / ((a.density + b.density) / 2));
  }

  double density_rate(const PairSource& a) const {
    double rate = 0;
    for_each_neighbour(a, [&](const Pair& pair, double slope_over_r) {
      const PairSource& b = pair.b;
      rate += (f_.volumes ? a.density * b.volume() : b.mass) * pair.slide() * slope_over_r;
      if (f_.diffuses == Diffuses::nothing) return;
      // psi_ab . grad W = 2 (difference) r_ab . grad W / r^2, of the nearer minus the own.
      double difference = b.diffused - a.diffused;
      if (f_.diffuses == Diffuses::beyond_gradient)
        difference += 0.5 * ((a.gradient_x + b.gradient_x) * pair.dx +
                             (a.gradient_z + b.gradient_z) * pair.dz);
      rate -= s_.density_diffusion * pair.h * sound() * diffusing_volume(b) * 2 * difference *
              slope_over_r;
    });
    return rate;
  }

  // Antuono et al. 2010, eq. 3; none where the matrix is nearly singular. Walls continue the
  // hydrostatic gradient.
  void find_gradients() {
    for (std::size_t i = 0; i < count_; ++i) {
      double xx = 0, xz = 0, zz = 0, x = 0, z = 0;
      for_each_neighbour(sources_[i], [&](const Pair& pair, double slope_over_r) {
        const double weight = -pair.b.volume() * slope_over_r,
                     difference = pair.a.diffused - pair.b.diffused;
        xx += weight * pair.dx * pair.dx;
        xz += weight * pair.dx * pair.dz;
        zz += weight * pair.dz * pair.dz;
        x += weight * pair.dx * difference;
        z += weight * pair.dz * difference;
      });
      const double d = xx * zz - xz * xz;
      sources_[i].gradient_x = d > 0.01 ? (zz * x - xz * z) / d : 0;
      sources_[i].gradient_z = d > 0.01 ? (xx * z - xz * x) / d : 0;
    }
    const double scale = -s_.rest_density / std::pow(sound(), 2);
    for (std::size_t k = count_; k < sources_.size(); ++k) {
      PairSource& b = sources_[k];
      const double still_x = scale * walls_.acceleration, still_z = scale * s_.gravity;
      const bool solid = k >= first_solid_;
      const PairSource& own = sources_[b.owner];
      b.gradient_x = solid ? still_x : still_x + b.side_x * (own.gradient_x - still_x);
      b.gradient_z = solid ? still_z : still_z + b.side_z * (own.gradient_z - still_z);
    }
  }

  Setting s_;
  Formulas f_;
  TankWalls walls_;
  HidingFace hiding_face_;
  double kernel_along_a_line_ = kernel_along_a_line();  // [1/m]
  std::size_t count_, first_solid_ = static_cast<std::size_t>(-1);
  std::vector<PairSource> sources_;
};

}  // namespace slosh::sph
