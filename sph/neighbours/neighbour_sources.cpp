#include "sph/neighbours/neighbour_sources.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "sph/walls/obstacle_contact.hpp"
#include "sph/walls/thin_obstacles.hpp"

namespace slosh::sph {
namespace {

struct Farthest {
  double distance, speed;  // [m], [m/s]
};

// The loops over all particles take plain pointers and a copy of the axes because their loads would
// not be vectorised.
template <class Axes>
Farthest farthest_since(const Particles& particles, const Axes& axes, const Array<float>& at_x,
                        const Array<float>& at_z) {
  const double *x = particles.x.data(), *z = particles.z.data(),
               *velocity_x = particles.velocity_x.data(), *velocity_z = particles.velocity_z.data();
  const float *built_x = at_x.data(), *built_z = at_z.data();
  const std::size_t n = particles.size();
  const Axes at = axes;
  double farthest2 = 0, fastest2 = 0;
#pragma omp parallel for simd reduction(max : farthest2, fastest2)
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 place = at.in_tank(x[i], z[i]);
    const double dx = place.x - built_x[i], dz = place.z - built_z[i];
    const Vector2 wall = at.wall_velocity(x[i], z[i]);
    const double u = velocity_x[i] - wall.x, w = velocity_z[i] - wall.z;
    farthest2 = std::max(farthest2, dx * dx + dz * dz);
    fastest2 = std::max(fastest2, u * u + w * w);
  }
  return {std::sqrt(farthest2), std::sqrt(fastest2)};
}

template <class Axes>
double fastest_against(const Particles& particles, const Axes& axes) {
  const double *x = particles.x.data(), *z = particles.z.data(),
               *velocity_x = particles.velocity_x.data(), *velocity_z = particles.velocity_z.data();
  const std::size_t n = particles.size();
  const Axes at = axes;
  double fastest2 = 0;
#pragma omp parallel for simd reduction(max : fastest2)
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 wall = at.wall_velocity(x[i], z[i]);
    const double u = velocity_x[i] - wall.x, w = velocity_z[i] - wall.z;
    fastest2 = std::max(fastest2, u * u + w * w);
  }
  return std::sqrt(fastest2);
}

}  // namespace

NeighbourSources::NeighbourSources(const Tank& tank, double spacing, double support)
    : support_(support),
      length_(tank.length()),
      height_(tank.tank_height()),
      rounding_(4 * std::numeric_limits<float>::epsilon() * std::max(length_, height_)),
      grid_(0, length_, 0, height_, cell_width * spacing, cell_height * spacing) {
  const double narrowest = std::min(length_, height_);
  if (!(narrowest >= 2 * support * (1 + 2 * largest_slack)))
    throw std::invalid_argument(
        "particle_spacing: expected one whose kernel reaches across at most half the tank");
}

void NeighbourSources::add_solids(std::vector<SolidPlace>& places,
                                  std::vector<Rectangle> obstacles) {
  std::sort(places.begin(), places.end(), [&](const SolidPlace& a, const SolidPlace& b) {
    return grid_.cell(a.node_x, a.node_z) < grid_.cell(b.node_x, b.node_z);
  });
  obstacles_ = std::move(obstacles);
  sight_ = LineOfSight(thin_obstacles(obstacles_, support_, length_, height_));
  if (places.empty()) return;
  solid_grid_ = grid_beyond_walls();
  std::vector<std::uint32_t> node_cells, cells, in_order;
  for (const SolidPlace& place : places) {
    node_cells.push_back(grid_.cell(place.node_x, place.node_z));
    cells.push_back(solid_grid_->cell(place.x, place.z));
    node_x_.push_back(static_cast<float>(place.node_x));
    node_z_.push_back(static_cast<float>(place.node_z));
  }
  node_grid_ = grid_;
  node_grid_->sort(node_cells, in_order);
  solid_grid_->sort(cells, solid_order_);
  for (const std::uint32_t i : solid_order_) {
    solid_x_.push_back(static_cast<float>(places[i].x));
    solid_z_.push_back(static_cast<float>(places[i].z));
  }
  if (!sight_.exists()) return;
  for (const std::uint32_t i : solid_order_) solid_faces_.push_back(places[i].face);
  for (const SolidPlace& place : places) {
    const bool at_node = place.x == place.node_x && place.z == place.node_z;
    node_faces_.push_back(at_node ? place.face : no_face);
  }
}

bool NeighbourSources::rebuild(Particles& particles, const Tank& tank, double dt, bool has_images,
                               Array<double>&& scratch) {
  slack_ = slack_for(dt * fastest(particles, tank));
  reach_ = support_ + 2 * (slack_ + rounding_);
  const std::size_t n = particles.size();
  stray_ = n;
  for (std::size_t i = 0; i < n && stray_ == n; ++i)
    if (!inside(tank.in_tank(particles.x[i], particles.z[i]))) stray_ = i;
  if (stray_ != n) return false;
  sort_particles(particles, tank, scratch);
  images_.clear();
  if (has_images) list_images();
  sources_.resize(n + images_.size() + solid_order_.size());
  std::vector<SortedPoints> points{{grid_, built_x_, built_z_, 0}};
  if (has_images) points.push_back({*image_grid_, image_x_, image_z_, n});
  if (solid_grid_) points.push_back({*solid_grid_, solid_x_, solid_z_, n + images_.size()});
  if (sight_.exists()) {
    list_seen_sources(points);
    return true;
  }
  clusters_.build(grid_, built_x_, built_z_, points, reach_);
  if (node_grid_) solid_clusters_.build(*node_grid_, node_x_, node_z_, points, reach_);
  return true;
}

bool NeighbourSources::stale(const Particles& particles, const Tank& tank, double dt) const {
  if (built_x_.size() != particles.size()) return true;
  const Farthest moved = tank.with_axes(
      [&](const auto& axes) { return farthest_since(particles, axes, built_x_, built_z_); });
  return !(moved.distance + dt * moved.speed < slack_);
}

double NeighbourSources::fastest(const Particles& particles, const Tank& tank) {
  return tank.with_axes([&](const auto& axes) { return fastest_against(particles, axes); });
}

int NeighbourSources::walls_before(std::size_t source) const {
  const std::size_t liquid = built_x_.size();
  if (source < liquid) return in_none;
  if (source < liquid + images_.size()) return images_[source - liquid].reflection;
  const std::size_t solid = source - first_solid_source();
  double x = solid_x_[solid], z = solid_z_[solid];
  if (const int face = solid_faces_.empty() ? no_face : solid_faces_[solid]; face != no_face) {
    // The wall that it stands behind may be one that its face hides.
    const bool across_x = face % 4 == left_side || face % 4 == right_side;
    (across_x ? x : z) = 0.5 * (across_x ? length_ : height_);
  }
  return (x < 0         ? in_left
          : x > length_ ? in_right
                        : in_none) +
         (z < 0         ? in_bottom
          : z > height_ ? in_roof
                        : in_none);
}

void NeighbourSources::list_seen_sources(const std::vector<SortedPoints>& points) {
  const std::size_t first_solid = first_solid_source();
  clusters_.build(grid_, built_x_, built_z_, points, reach_,
                  SeenSources(sight_, built_x_, built_z_, reach_, solid_faces_, first_solid, {}));
  if (!node_grid_) return;
  solid_clusters_.build(
      *node_grid_, node_x_, node_z_, points, reach_,
      SeenSources(sight_, node_x_, node_z_, reach_, solid_faces_, first_solid, node_faces_));
}

// Returns the slack for `steps_per_list` steps of this length, within the efficient bounds, but
// at least for one step.
double NeighbourSources::slack_for(double step) const {
  return std::max(1.01 * step, std::clamp(steps_per_list * step, smallest_slack * support_,
                                          largest_slack * support_));
}

// The comparisons are false for NaN.
bool NeighbourSources::inside(Vector2 place) const {
  return place.x > 0 && place.x < length_ && place.z > 0 && place.z < height_;
}

void NeighbourSources::sort_particles(Particles& particles, const Tank& tank,
                                      Array<double>& scratch) {
  const std::size_t n = particles.size();
  keys_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 place = tank.in_tank(particles.x[i], particles.z[i]);
    keys_[i] = grid_.cell(place.x, place.z);
  }
  grid_.sort(keys_, order_);
  particles.for_each_field([&](Array<double>& field) {
    scratch.resize(n);
    for (std::size_t i = 0; i < n; ++i) scratch[i] = field[order_[i]];
    field.swap(scratch);
  });
  built_x_.resize(n);
  built_z_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 place = tank.in_tank(particles.x[i], particles.z[i]);
    built_x_[i] = static_cast<float>(place.x);
    built_z_[i] = static_cast<float>(place.z);
  }
}

CellGrid NeighbourSources::grid_beyond_walls() const {
  return {-support_,          length_ + support_,      -support_,
          height_ + support_, kernel_cells * support_, kernel_cells * support_};
}

void NeighbourSources::list_images() {
  if (!image_grid_) image_grid_ = grid_beyond_walls();
  listed_.clear();
  keys_.clear();
  const auto maps = mirror_maps({0, length_, 0, height_, 0, 0}, false);
  for (std::size_t i = 0; i < built_x_.size(); ++i) {
    const double x = built_x_[i], z = built_z_[i];
    const int side = x < reach_ ? in_left : x > length_ - reach_ ? in_right : in_none;
    const int level = z < reach_ ? in_bottom : z > height_ - reach_ ? in_roof : in_none;
    if (side) list_image(i, side, maps);
    if (level) list_image(i, level, maps);
    if (side && level) list_image(i, side + level, maps);
  }
  image_grid_->sort(keys_, order_);
  image_x_.clear();
  image_z_.clear();
  for (const std::uint32_t k : order_) {
    const Image& image = images_.emplace_back(listed_[k]);
    const MirrorMap& map = maps[image.reflection];
    image_x_.push_back(static_cast<float>(map.scale_x * built_x_[image.owner] + map.offset_x));
    image_z_.push_back(static_cast<float>(map.scale_z * built_z_[image.owner] + map.offset_z));
  }
}

void NeighbourSources::list_image(std::size_t i, int bits,
                                  const std::array<MirrorMap, reflection_count>& maps) {
  const double x = maps[bits].scale_x * built_x_[i] + maps[bits].offset_x,
               z = maps[bits].scale_z * built_z_[i] + maps[bits].offset_z;
  for (const Rectangle& obstacle : obstacles_)
    if (holds(obstacle, x, z)) return;
  listed_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint8_t>(bits)});
  keys_.push_back(image_grid_->cell(x, z));
}

}  // namespace slosh::sph
