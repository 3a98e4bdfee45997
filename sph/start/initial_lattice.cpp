#include "sph/start/initial_lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "sph/start/initial_surface.hpp"
#include "sph/walls/obstacle_contact.hpp"
#include "sph/walls/solid_particles.hpp"
#include "sph/walls/tank_outline.hpp"

namespace slosh::sph {
namespace {

int lattice_count(double length, double spacing, const char* what) {
  const double count = std::max(1.0, std::round(length / spacing));
  if (!(std::abs(length / (count * spacing) - 1) <= largest_stretch))
    throw std::invalid_argument(
        fmt::format("particle_spacing = {} m: expected a whole number of particles, to {:.0f} %, "
                    "along the {} of {} m",
                    spacing, 100 * largest_stretch, what, length));
  return static_cast<int>(count);
}

using DensityAt = std::function<double(double)>;

// Adds a particle of this volume [m2] at rest.
void add_particle(Particles& p, double x, double z, double spacing, double volume, double density) {
  p.x.push_back(x);
  p.z.push_back(z);
  p.velocity_x.push_back(0);
  p.velocity_z.push_back(0);
  p.density.push_back(density);
  p.mass.push_back(density * volume);
  p.spacing.push_back(spacing);
}

void lay_block(const Scene& scene, const DensityAt& density_at, double bottom, double top,
               double spacing, Particles& p) {
  const double length = scene.column_width.value_or(scene.tank_length);
  const int columns =
      lattice_count(length, spacing, scene.column_width ? "column's width" : "tank's length");
  const int rows = lattice_count(top - bottom, spacing, "liquid's depth");
  const double dx = length / columns, dz = (top - bottom) / rows;
  const InitialSurface surface(scene);
  const std::vector<Rectangle> obstacles = obstacles_on_lattice(scene, 0);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double stretch = surface.mean_height(column * dx, (column + 1) * dx) / scene.fill_depth;
      const double z = stretch * (bottom + (row + 0.5) * dz);
      const double x = (column + 0.5) * dx;
      if (std::any_of(obstacles.begin(), obstacles.end(),
                      [=](const Rectangle& obstacle) { return holds(obstacle, x, z); }))
        continue;
      add_particle(p, x, z, dx, dx * dz * stretch, density_at(surface.pressure(x, z)));
    }
}

// The lattice is turned about the middle of the liquid, and the particles share the liquid's area.
void lay_rotated(const Scene& scene, const DensityAt& density_at, Particles& p) {
  const double spacing = scene.particle_spacing, cosine = std::cos(scene.start_rotation),
               sine = std::sin(scene.start_rotation);
  const double half_length = 0.5 * scene.tank_length, half_depth = 0.5 * scene.fill_depth;
  const int reach = static_cast<int>(std::ceil(std::hypot(half_length, half_depth) / spacing));
  const InitialSurface surface(scene);
  for (int row = -reach; row < reach; ++row)
    for (int column = -reach; column < reach; ++column) {
      const double along = (column + 0.5) * spacing, across = (row + 0.5) * spacing;
      const double x = along * cosine - across * sine, z = along * sine + across * cosine;
      if (!(std::abs(x) < half_length && std::abs(z) < half_depth)) continue;
      add_particle(p, half_length + x, half_depth + z, spacing, 1,
                   density_at(surface.pressure(0, half_depth + z)));
    }
  const double area = 4 * half_length * half_depth / static_cast<double>(p.size());
  for (double& mass : p.mass) mass *= area;
}

// Each row has as many particles as fit its mean width, and the area of its part of the tank.
void lay_rows(const Scene& scene, const TankOutline& outline, const DensityAt& density_at,
              Particles& p) {
  const double spacing = scene.particle_spacing;
  const int rows = lattice_count(scene.fill_depth, spacing, "liquid's depth");
  const double dz = scene.fill_depth / rows;
  const InitialSurface surface(scene);
  for (int row = 0; row < rows; ++row) {
    const TankOutline::Extent extent = outline.mean_between(row * dz, (row + 1) * dz);
    const double columns = std::max(1.0, std::round(extent.width() / spacing)),
                 dx = extent.width() / columns, z = (row + 0.5) * dz;
    for (int column = 0; column < columns; ++column)
      add_particle(p, extent.left + (column + 0.5) * dx, z, dx, dx * dz,
                   density_at(surface.pressure(0, z)));
  }
  // The numbers of a scheme refer to the spacing that the run asks for.
  p.spacing.assign(p.size(), spacing);
}

}  // namespace

Particles initial_lattice(const Scene& scene, const DensityAt& density_at) {
  Particles particles;
  if (const auto outline = outline_of(scene)) {
    lay_rows(scene, *outline, density_at, particles);
    return particles;
  }
  if (scene.start_rotation != 0) {
    lay_rotated(scene, density_at, particles);
    return particles;
  }
  const double coarse = scene.particle_spacing, fine = scene.surface_particle_spacing;
  if (fine == coarse) {
    lay_block(scene, density_at, 0, scene.fill_depth, coarse, particles);
    return particles;
  }
  // The coarse block has a whole number of coarse layers; the fine block fills the rest.
  const double interface =
      coarse * std::floor((scene.fill_depth - fine_layers * fine) / coarse + 1e-9);
  if (!(fine > 0 && fine < coarse && interface > 0))
    throw std::invalid_argument(
        fmt::format("surface_particle_spacing = {} m: expected a value below the particle spacing "
                    "{} m that leaves room for {} layers",
                    fine, coarse, fine_layers));
  lay_block(scene, density_at, 0, interface, coarse, particles);
  lay_block(scene, density_at, interface, scene.fill_depth, fine, particles);
  return particles;
}

void perturb_symmetrically(Particles& p, double middle, double distance) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double from_middle = p.x[i] - middle, side = from_middle < 0 ? -1 : 1;
    // The displacement depends on the number of the lattice cell, which round-off does not change.
    const double column = std::floor(std::abs(from_middle) / p.spacing_of(i) + 0.25),
                 row = std::floor(p.z[i] / p.spacing_of(i) + 0.25);
    const double a = 12.9898 * column + 78.233 * row, b = 39.425 * column + 11.135 * row;
    p.x[i] += side * distance * std::sin(a * a);
    p.z[i] += distance * std::sin(b * b);
  }
}

void perturb_randomly(Particles& p, double share, unsigned seed) {
  if (!(share >= 0 && share <= largest_disorder))
    throw std::invalid_argument(
        fmt::format("start_disorder = {}: expected a share of the particle spacing from 0 to {}",
                    share, largest_disorder));
  std::mt19937 random(seed);
  // The distributions of the standard library give other numbers in other implementations.
  const auto from_minus_one_to_one = [&] { return random() / 2147483647.5 - 1.0; };
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.x[i] += share * p.spacing_of(i) * from_minus_one_to_one();
    p.z[i] += share * p.spacing_of(i) * from_minus_one_to_one();
  }
}

Particles lattice_of_volumes(const Scene& scene) {
  return initial_lattice(scene, [](double) { return 1.0; });
}

double flattest_cell(const Particles& volumes) {
  double ratio = 1;
  for (std::size_t i = 0; i < volumes.size(); ++i)
    ratio = std::min(ratio, volumes.mass[i] / (volumes.spacing[i] * volumes.spacing[i]));
  return ratio;
}

double mean_depth(const Particles& volumes, const Scene& scene) {
  const InitialSurface surface(scene);
  double moment = 0, volume = 0;
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    moment += volumes.mass[i] * (surface.height(volumes.x[i]) - volumes.z[i]);
    volume += volumes.mass[i];
  }
  return moment / volume;
}

}  // namespace slosh::sph
