#include "sph/walls/wall_contact.hpp"

#include <cmath>

#include "sph/walls/obstacle_contact.hpp"

namespace slosh::sph {
namespace {

// The usual case, found in a loop without branches, which takes plain pointers and a copy of the
// axes because its loads would not be vectorised otherwise.
template <class Axes>
bool all_inside(const Particles& p, const Axes& axes) {
  const double *x = p.x.data(), *z = p.z.data();
  const std::size_t n = p.size();
  const Axes at = axes;
  const double length = at.length(), height = at.tank_height();
  double outside = 0;
#pragma omp parallel for simd schedule(static) reduction(+ : outside)
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 place = at.in_tank(x[i], z[i]);
    const double out =
        place.x > 0 && place.x < length && place.z > 0 && place.z < height ? 0.0 : 1.0;
    outside += out;
  }
  return outside == 0;
}
bool inside(double position, double length) { return position > 0 && position < length; }
double reflected(double position, double length) {
  return 2 * (position <= 0 ? 0 : length) - position;
}

}  // namespace

std::size_t ReflectingWall::confine(Particles& p, const Tank& tank) const {
  if (tank.with_axes([&](const auto& axes) { return all_inside(p, axes); })) return 0;
  std::size_t exchanged = 0;
#pragma omp parallel for schedule(static) reduction(+ : exchanged)
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 place = tank.in_tank(p.x[i], p.z[i]);
    const bool out_x = !inside(place.x, tank.length()),
               out_z = !inside(place.z, tank.tank_height());
    if (!out_x && !out_z) continue;
    ++exchanged;
    move_with_tank(p, i, tank,
                   {out_x ? reflected(place.x, tank.length()) : place.x,
                    out_z ? reflected(place.z, tank.tank_height()) : place.z},
                   out_x, out_z);
  }
  return exchanged;
}

void RepulsiveWall::push(const Particles& p, const Tank& tank, Rates& rates, int of) const {
  const TankWalls& walls = tank.walls;
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double r0 = range * p.spacing_of(i);
    const double from_left = p.x[i] - walls.left, from_right = p.x[i] - walls.right;
    const double from_bottom = p.z[i] - walls.bottom, from_roof = p.z[i] - walls.roof;
    double& ax = rates.acceleration_x[i];
    double& az = rates.acceleration_z[i];
    if (from_left < r0 && (of & in_left)) push_one(from_left, from_bottom, r0, ax, az);
    if (-from_right < r0 && (of & in_right)) push_one(from_right, from_bottom, r0, ax, az);
    if (from_bottom < r0 && (of & in_bottom)) push_one(from_bottom, from_left, r0, az, ax);
    if (-from_roof < r0 && (of & in_roof)) push_one(from_roof, from_left, r0, az, ax);
  }
}

// `normal` is the signed distance from the wall, `along` the position along it from a wall
// particle.
void RepulsiveWall::push_one(double normal, double along, double r0, double& normal_rate,
                             double& tangential_rate) const {
  const double pitch = r0;
  const double nearest = std::round(along / pitch);
  for (int k = -1; k <= 1; ++k) {
    const double tangential = along - (nearest + k) * pitch;
    const double r2 = normal * normal + tangential * tangential;
    if (r2 >= r0 * r0) continue;
    const double ratio4 = (r0 * r0 / r2) * (r0 * r0 / r2);
    const double f = strength * (ratio4 * ratio4 * ratio4 - ratio4) / r2;
    normal_rate += f * normal;
    tangential_rate += f * tangential;
  }
}

std::size_t confine_to(const TankOutline& outline, Particles& p, const Tank& tank) {
  std::size_t exchanged = 0;
#pragma omp parallel for schedule(static) reduction(+ : exchanged)
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 place = tank.in_tank(p.x[i], p.z[i]);
    if (outline.contains(place.x, place.z)) continue;
    const OutlinePoint wall = outline.nearest(place.x, place.z);
    if (!std::isfinite(place.x + place.z)) continue;  // the stability guard reports it
    ++exchanged;
    Vector2 back{2 * wall.at.x - place.x, 2 * wall.at.z - place.z};
    if (!outline.contains(back.x, back.z)) {
      const double inside = 1e-6 * (outline.top() - outline.bottom());
      const OutlinePoint opposite = outline.nearest(back.x, back.z);
      back = {opposite.at.x + inside * opposite.inward.x,
              opposite.at.z + inside * opposite.inward.z};
    }
    const Vector2 velocity = tank.wall_velocity(p.x[i], p.z[i]),
                  normal = tank.along_frame(wall.inward.x, wall.inward.z);
    p.turn_velocity(i, normal.x, normal.z, velocity.x * normal.x + velocity.z * normal.z);
    const Vector2 to = tank.in_frame(back.x, back.z);
    p.x[i] = to.x;
    p.z[i] = to.z;
  }
  return exchanged;
}

}  // namespace slosh::sph
