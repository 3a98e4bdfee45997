#include "sph/walls/solid_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace slosh::sph {
namespace {

double snapped(double edge, double spacing) { return spacing * std::round(edge / spacing); }

// The image of (x, z) in the nearest of the rectangle's four faces, seen from within.
SolidPlace behind_nearest_face(double x, double z, const Rectangle& r) {
  const std::array<double, 4> depth{x - r.left, r.right - x, z - r.bottom, r.top - z};
  switch (std::min_element(depth.begin(), depth.end()) - depth.begin()) {
    case 0:
      return {x, z, 2 * r.left - x, z, true, false};
    case 1:
      return {x, z, 2 * r.right - x, z, true, false};
    case 2:
      return {x, z, x, 2 * r.bottom - z, false, true};
    default:
      return {x, z, x, 2 * r.top - z, false, true};
  }
}

// Brings a node that lies behind the tank's walls back into the tank.
void fold_into_tank(SolidPlace& place, const Scene& scene) {
  const auto fold = [](double& at, bool& turns, double length) {
    if (at > 0 && at < length) return;
    at = at <= 0 ? -at : 2 * length - at;
    turns = !turns;
  };
  fold(place.node_x, place.turns_x, scene.tank_length);
  fold(place.node_z, place.turns_z, scene.tank_height);
}

void fill_obstacle(const Scene& scene, const Rectangle& r, double depth,
                   std::vector<SolidPlace>& places) {
  const double dp = scene.particle_spacing;
  for (double z = r.bottom + 0.5 * dp; z < r.top; z += dp)
    for (double x = r.left + 0.5 * dp; x < r.right; x += dp) {
      SolidPlace place = behind_nearest_face(x, z, r);
      if (std::hypot(place.node_x - x, place.node_z - z) > 2 * depth) continue;
      fold_into_tank(place, scene);
      places.push_back(place);
    }
}

void fill_tank_walls(const Scene& scene, double depth, std::vector<SolidPlace>& places) {
  const double dp = scene.particle_spacing;
  const int layers = static_cast<int>(std::ceil(depth / dp - 1e-9));
  const int columns = static_cast<int>(std::round(scene.tank_length / dp)),
            rows = static_cast<int>(std::round(scene.tank_height / dp));
  const double dx = scene.tank_length / columns, dz = scene.tank_height / rows;
  for (int row = -layers; row < rows + layers; ++row)
    for (int column = -layers; column < columns + layers; ++column) {
      if (row >= 0 && row < rows && column >= 0 && column < columns) continue;
      const double x = (column + 0.5) * dx, z = (row + 0.5) * dz;
      SolidPlace place{x, z, x, z, false, false};
      fold_into_tank(place, scene);
      places.push_back(place);
    }
}

}  // namespace

std::vector<Rectangle> obstacles_on_lattice(const Scene& scene, double depth) {
  const double dp = scene.particle_spacing;
  std::vector<Rectangle> obstacles;
  for (const Rectangle& given : scene.obstacles) {
    Rectangle r{snapped(given.left, dp), snapped(given.right, dp), snapped(given.bottom, dp),
                snapped(given.top, dp)};
    const double thin =
        std::min(r.left > 0 && r.right < scene.tank_length ? r.right - r.left : depth,
                 r.bottom > 0 && r.top < scene.tank_height ? r.top - r.bottom : depth);
    if (!(r.right > r.left && r.top > r.bottom && thin >= depth * (1 - 1e-9)))
      throw std::invalid_argument(fmt::format(
          "obstacle from x = {} to {} m and z = {} to {} m: expected one at least as thick as the "
          "kernel reaches, {:.4g} m at the particle spacing of {} m",
          given.left, given.right, given.bottom, given.top, depth, dp));
    if (r.left <= 0) r.left -= depth;
    if (r.right >= scene.tank_length) r.right += depth;
    if (r.bottom <= 0) r.bottom -= depth;
    if (r.top >= scene.tank_height) r.top += depth;
    obstacles.push_back(r);
  }
  return obstacles;
}

void expel(Particles& p, const TankWalls& walls, const Rectangle& obstacle) {
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.x[i] - walls.left, z = p.z[i] - walls.bottom;
    if (!holds(obstacle, x, z)) continue;
    const SolidPlace place = behind_nearest_face(x, z, obstacle);
    p.x[i] = walls.left + place.node_x;
    p.z[i] = walls.bottom + place.node_z;
    if (place.turns_x) p.velocity_x[i] = 2 * walls.velocity - p.velocity_x[i];
    if (place.turns_z) p.velocity_z[i] = -p.velocity_z[i];
  }
}

std::vector<SolidPlace> solid_places(const Scene& scene, bool tank_walls, double depth) {
  std::vector<SolidPlace> places;
  if (tank_walls) fill_tank_walls(scene, depth, places);
  for (const Rectangle& obstacle : obstacles_on_lattice(scene, depth))
    fill_obstacle(scene, obstacle, depth, places);
  return places;
}

}  // namespace slosh::sph
