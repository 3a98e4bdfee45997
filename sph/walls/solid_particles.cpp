#include "sph/walls/solid_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sph/walls/obstacle_contact.hpp"
#include "sph/walls/outline_layers.hpp"
#include "sph/walls/thin_obstacles.hpp"

namespace slosh::sph {
namespace {

// Returns the size of the cells of which a whole number fills the length, near the spacing.
double cell_along(double length, double spacing) {
  return length / std::max(1.0, std::round(length / spacing));
}

// Returns the nearest border between cells, or the wall at `end` where that is as near.
double snapped(double edge, double cell, double end) {
  return std::abs(edge - end) <= 0.5 * cell ? end : cell * std::round(edge / cell);
}

void fill_obstacle(const Scene& scene, const Rectangle& r, double depth,
                   std::vector<SolidPlace>& places) {
  const double dx = cell_along(r.right - r.left, scene.particle_spacing),
               dz = cell_along(r.top - r.bottom, scene.particle_spacing);
  for (double z = r.bottom + 0.5 * dz; z < r.top; z += dz)
    for (double x = r.left + 0.5 * dx; x < r.right; x += dx) {
      SolidPlace place = behind_nearest_face(x, z, r, scene.tank_length, scene.tank_height);
      if (std::hypot(place.node_x - x, place.node_z - z) > 2 * depth) continue;
      place.in_obstacle = true;
      fold_into_tank(place, scene);
      places.push_back(place);
    }
}

// Adds a place behind a wall as `count` places of equal shares beside one another along it. A place
// in a corner is divided along both walls.
void divide_along_walls(const SolidPlace& place, int count, double dx, double dz,
                        const Scene& scene, std::vector<SolidPlace>& places) {
  const int columns = place.turn.zz < 0 ? count : 1, rows = place.turn.xx < 0 ? count : 1;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double x = place.x + ((column + 0.5) / columns - 0.5) * dx,
                   z = place.z + ((row + 0.5) / rows - 0.5) * dz;
      SolidPlace& part = places.emplace_back(SolidPlace{x, z, x, z});
      part.cell_share = 1.0 / (columns * rows);
      fold_into_tank(part, scene);
    }
}

void fill_tank_walls(const Scene& scene, double depth, int along_walls,
                     const std::vector<Rectangle>& obstacles, std::vector<SolidPlace>& places) {
  const double dp = scene.particle_spacing;
  const int layers = whole_layers(depth, dp);
  const int columns = static_cast<int>(std::round(scene.tank_length / dp)),
            rows = static_cast<int>(std::round(scene.tank_height / dp));
  const double dx = scene.tank_length / columns, dz = scene.tank_height / rows;
  for (int row = -layers; row < rows + layers; ++row)
    for (int column = -layers; column < columns + layers; ++column) {
      if (row >= 0 && row < rows && column >= 0 && column < columns) continue;
      const double x = (column + 0.5) * dx, z = (row + 0.5) * dz;
      if (std::any_of(obstacles.begin(), obstacles.end(),
                      [=](const Rectangle& obstacle) { return holds(obstacle, x, z); }))
        continue;
      SolidPlace place{x, z, x, z};
      fold_into_tank(place, scene);
      divide_along_walls(place, along_walls, dx, dz, scene, places);
    }
}

}  // namespace

std::vector<Rectangle> obstacles_on_lattice(const Scene& scene, double depth) {
  const double dp = scene.particle_spacing;
  const double dx = cell_along(scene.tank_length, dp), dz = cell_along(scene.fill_depth, dp);
  std::vector<Rectangle> obstacles;
  for (const Rectangle& given : scene.obstacles) {
    Rectangle r{
        snapped(given.left, dx, scene.tank_length), snapped(given.right, dx, scene.tank_length),
        snapped(given.bottom, dz, scene.tank_height), snapped(given.top, dz, scene.tank_height)};
    const double thin =
        std::min(r.left > 0 && r.right < scene.tank_length ? given.right - given.left : dp,
                 r.bottom > 0 && r.top < scene.tank_height ? given.top - given.bottom : dp);
    if (!(r.right > r.left && r.top > r.bottom && thin >= dp * (1 - 1e-9)))
      throw std::invalid_argument(fmt::format(
          "obstacle from x = {} to {} m and z = {} to {} m: expected one at least as thick as a "
          "particle spacing, {} m",
          given.left, given.right, given.bottom, given.top, dp));
    const int layers = whole_layers(depth, dp);
    if (r.left <= 0) r.left = -layers * dx;
    if (r.right >= scene.tank_length) r.right = scene.tank_length + layers * dx;
    if (r.bottom <= 0) r.bottom = -layers * dz;
    if (r.top >= scene.tank_height) r.top = scene.tank_height + layers * dz;
    obstacles.push_back(r);
  }
  return obstacles;
}

std::vector<SolidPlace> solid_places(const Scene& scene, bool tank_walls, double depth,
                                     int along_walls) {
  if (!scene.outline.empty())
    return tank_walls ? outline_layers(TankOutline(scene.outline), scene.particle_spacing, depth,
                                       along_walls)
                      : std::vector<SolidPlace>();
  std::vector<SolidPlace> places;
  const std::vector<Rectangle> obstacles = obstacles_on_lattice(scene, depth);
  if (tank_walls) fill_tank_walls(scene, depth, along_walls, obstacles, places);
  for (const Rectangle& obstacle : obstacles)
    if (thin_obstacles({obstacle}, depth, scene.tank_length, scene.tank_height).empty())
      fill_obstacle(scene, obstacle, depth, places);
  add_places_behind_faces(scene, obstacles, depth, places);
  places.shrink_to_fit();  // they stay as long as the run
  return places;
}

}  // namespace slosh::sph
