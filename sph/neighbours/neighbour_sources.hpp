// The sources of the pair sums, each kind sorted by cell: the liquid in the order of its particles,
// then its mirror images, then the particles of solids. `rebuild` sorts the particles, decides
// which images exist and lists the sources of every cluster; it uses positions in single precision
// and a reach that allows for their rounding. Between rebuilds, `refresh_for_...` fill in the state
// of the liquid and its images many times; the solids (walls/solids.hpp) fill in their own.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sph/neighbours/cell_grid.hpp"
#include "sph/neighbours/cluster_lists.hpp"
#include "sph/neighbours/particles.hpp"
#include "sph/walls/mirror_particles.hpp"
#include "sph/walls/obstacle_contact.hpp"
#include "sph/walls/solid_particles.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

class NeighbourSources {
 public:
  // `spacing` is that of the particles [m] and determines the cells; `support` is the largest
  // kernel radius in the scene [m]. Throws std::invalid_argument for a tank narrower or lower than
  // two reaches, in which a particle would need images of images.
  template <class Tank>
  NeighbourSources(const Tank& tank, double spacing, double support)
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

  // Adds the solids' particles and their nodes, at which their sums are evaluated, in the tank [m].
  // Sorts `places` by cell; they must not change afterwards. Images that fall into an obstacle are
  // left out, and obstacles thinner than the support hide what is behind them.
  void add_solids(std::vector<SolidPlace>& places, std::vector<Rectangle> obstacles) {
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

  // Sorts the particles by cell, and lists their images and the sources of every cluster for some
  // steps of dt. Returns false where a particle, `stray()`, is not in the tank. `scratch` is
  // overwritten.
  template <class Mirror = FreeSlipMirror, class Tank>
  bool rebuild(Particles& particles, const Tank& tank, double dt, Array<double>&& scratch = {}) {
    slack_ = slack_for(dt * fastest(particles, tank));
    reach_ = support_ + 2 * (slack_ + rounding_);
    const std::size_t n = particles.size();
    stray_ = n;
    for (std::size_t i = 0; i < n && stray_ == n; ++i)
      if (!inside(tank.in_tank(particles.x[i], particles.z[i]))) stray_ = i;
    if (stray_ != n) return false;
    sort_particles(particles, tank, scratch);
    images_.clear();
    if constexpr (Mirror::exists) list_images();
    sources_.resize(n + images_.size() + solid_order_.size());
    std::vector<SortedPoints> points{{grid_, built_x_, built_z_, 0}};
    if constexpr (Mirror::exists) points.push_back({*image_grid_, image_x_, image_z_, n});
    if (solid_grid_) points.push_back({*solid_grid_, solid_x_, solid_z_, n + images_.size()});
    if (sight_.exists()) {
      list_seen_sources(points);
      return true;
    }
    clusters_.build(grid_, built_x_, built_z_, points, reach_);
    if (node_grid_) solid_clusters_.build(*node_grid_, node_x_, node_z_, points, reach_);
    return true;
  }
  std::size_t stray() const { return stray_; }

  // Returns whether a particle may, by the end of a step of dt, have moved farther relative to the
  // tank than the lists of the last rebuild allow.
  template <class Tank>
  bool stale(const Particles& particles, const Tank& tank, double dt) const {
    if (built_x_.size() != particles.size()) return true;
    // The loop takes plain pointers and a copy of the tank because its loads would not be
    // vectorised.
    const double *x = particles.x.data(), *z = particles.z.data(),
                 *velocity_x = particles.velocity_x.data(),
                 *velocity_z = particles.velocity_z.data();
    const float *built_x = built_x_.data(), *built_z = built_z_.data();
    const std::size_t n = particles.size();
    const Tank at = tank;
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
    return !(std::sqrt(farthest2) + dt * std::sqrt(fastest2) < slack_);
  }
  // Returns the largest speed relative to the tank [m/s]. The loop is written as that of stale().
  template <class Tank>
  static double fastest(const Particles& particles, const Tank& tank) {
    const double *x = particles.x.data(), *z = particles.z.data(),
                 *velocity_x = particles.velocity_x.data(),
                 *velocity_z = particles.velocity_z.data();
    const std::size_t n = particles.size();
    const Tank at = tank;
    double fastest2 = 0;
#pragma omp parallel for simd reduction(max : fastest2)
    for (std::size_t i = 0; i < n; ++i) {
      const Vector2 wall = at.wall_velocity(x[i], z[i]);
      const double u = velocity_x[i] - wall.x, w = velocity_z[i] - wall.z;
      fastest2 = std::max(fastest2, u * u + w * w);
    }
    return std::sqrt(fastest2);
  }
  // Returns where a particle was in the tank at the last rebuild, or nothing where the lists have
  // been made stale.
  std::optional<Vector2> place_at_rebuild(std::size_t i) const {
    if (built_x_.empty()) return {};
    return Vector2{built_x_[i], built_z_[i]};
  }
  // The obstacles thinner than the support.
  const LineOfSight& sight() const { return sight_; }
  // Makes the lists stale.
  void forget() { built_x_.clear(); }
  // Returns how far a particle may move relative to the tank before the lists are stale [m].
  double slack() const { return slack_; }

  // Fills in the state that the momentum sum reads, for the liquid and its images.
  template <class Scheme, class Tank>
  void refresh_for_momentum(const Scheme& scheme, const Particles& p, const Tank& tank) {
    refresh<typename Scheme::Mirror>(scheme, p, tank, [&](Source& source, std::size_t i) {
      double pressure = scheme.state.pressure(p.density[i]);
      if constexpr (Scheme::Mirror::hydrostatic)
        pressure += pressure_rise(scheme, tank, source, p, i);
      source.strength = scheme.formulation.strength(pressure, p.density[i]);
      source.density = p.density[i];
    });
  }

  // Fills in the state that the continuity sum reads, for the liquid and its images.
  template <class Scheme, class Tank>
  void refresh_for_continuity(const Scheme& scheme, const Particles& p, const Tank& tank) {
    refresh<typename Scheme::Mirror::InContinuity>(
        scheme, p, tank, [&](Source& source, std::size_t i) {
          using Diffusion = typename Scheme::DensityDiffusion;
          if constexpr (Diffusion::active)
            source.density = scheme.density_diffusion.diffused(
                scheme.state.pressure(p.density[i]), p.density[i], tank.height(p.x[i], p.z[i]));
          if constexpr (Diffusion::of_whole_density && Scheme::Mirror::InContinuity::hydrostatic) {
            const double sound = scheme.state.speed_of_sound;
            source.density += pressure_rise(scheme, tank, source, p, i) / (sound * sound);
          }
        });
  }

  // Calls visit(source, solid) for the sources that are particles of solids; `solid` is the index
  // in their places.
  template <class Visit>
  void for_each_solid_source(const Visit& visit) {
    const std::size_t first = first_solid_source();
    for (std::size_t s = 0; s < solid_order_.size(); ++s)
      visit(sources_[first + s], solid_order_[s]);
  }
  std::size_t first_solid_source() const { return sources_.size() - solid_order_.size(); }

  // Calls visit(k, i, map) for every particle and every image: source k is particle i mapped by
  // `map`, which is the identity for the particle itself.
  template <class Mirror, class Tank, class Visit>
  void for_each_image(const Tank& tank, const Visit& visit) const {
    const std::size_t n = built_x_.size();
    const MirrorMap itself;
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i) visit(i, i, itself);
    if constexpr (Mirror::exists) {
      const auto maps = mirror_maps<Mirror>(tank);
#pragma omp parallel for schedule(static)
      for (std::size_t k = 0; k < images_.size(); ++k)
        visit(n + k, images_[k].owner, maps[images_[k].reflection]);
    }
  }

  // Returns the walls behind which a source lies, as a sum of the bits of Reflection; none for the
  // liquid and for obstacles within the tank. What continues an obstacle behind a wall lies behind
  // that wall.
  int walls_before(std::size_t source) const {
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

  const Source* sources() const { return sources_.data(); }
  std::size_t source_count() const { return sources_.size(); }
  const ClusterLists& clusters() const { return clusters_; }
  // Returns the clusters of the solids' nodes.
  const ClusterLists& solid_clusters() const { return solid_clusters_; }

  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    visit("sources", sources_);
    clusters_.for_each_named_field(visit);
    solid_clusters_.for_each_named_field(visit);
    grid_.for_each_named_field(visit);
    for (auto* grid : {&image_grid_, &solid_grid_, &node_grid_})
      if (*grid) (*grid)->for_each_named_field(visit);
    for (auto* images : {&images_, &listed_}) visit("images", *images);
    for (auto* places : {&image_x_, &image_z_}) visit("images", *places);
    for (auto* places : {&node_x_, &node_z_, &solid_x_, &solid_z_}) visit("solids", *places);
    visit("solids", solid_order_);
    for (auto* faces : {&solid_faces_, &node_faces_}) visit("solids", *faces);
    for (auto* sorted : {&keys_, &order_}) visit("order", *sorted);
    for (auto* built : {&built_x_, &built_z_}) visit("built_places", *built);
  }

 private:
  // Kept out of the code of the scenes without thin obstacles.
  [[gnu::noinline]] void list_seen_sources(const std::vector<SortedPoints>& points) {
    const std::size_t first_solid = first_solid_source();
    clusters_.build(grid_, built_x_, built_z_, points, reach_,
                    SeenSources(sight_, built_x_, built_z_, reach_, solid_faces_, first_solid, {}));
    if (!node_grid_) return;
    solid_clusters_.build(
        *node_grid_, node_x_, node_z_, points, reach_,
        SeenSources(sight_, node_x_, node_z_, reach_, solid_faces_, first_solid, node_faces_));
  }

  // Fills in the state that both sums read; complete(source, owner) fills in the rest.
  template <class Mirror, class Scheme, class Tank, class Complete>
  void refresh(const Scheme& scheme, const Particles& p, const Tank& tank,
               const Complete& complete) {
    for_each_image<Mirror>(tank, [&](std::size_t k, std::size_t i, const MirrorMap& map) {
      Source& source = sources_[k];
      source.x = map.scale_x * p.x[i] + map.offset_x;
      source.z = map.scale_z * p.z[i] + map.offset_z;
      source.velocity_x = map.velocity_scale_x * p.velocity_x[i] + map.velocity_offset_x;
      source.velocity_z = map.velocity_scale_z * p.velocity_z[i];
      source.weight = scheme.formulation.weight(p.mass[i], p.density[i]);
      if constexpr (Scheme::Smoothing::reads_spacing) source.spacing = p.spacing[i];
      complete(source, i);
    });
  }

  // Returns the rise of the hydrostatic pressure from the owner to its image [Pa].
  template <class Scheme, class Tank>
  static double pressure_rise(const Scheme& scheme, const Tank& tank, const Source& source,
                              const Particles& p, std::size_t i) {
    const Vector2 gravity = tank.apparent_gravity(scheme.setting.gravity, p.x[i], p.z[i],
                                                  p.velocity_x[i], p.velocity_z[i]);
    return p.density[i] * (gravity.x * (source.x - p.x[i]) + gravity.z * (source.z - p.z[i]));
  }

  // Returns the slack for `steps_per_list` steps of this length, within the efficient bounds, but
  // at least for one step.
  double slack_for(double step) const {
    return std::max(1.01 * step, std::clamp(steps_per_list * step, smallest_slack * support_,
                                            largest_slack * support_));
  }

  // The comparisons are false for NaN.
  bool inside(Vector2 place) const {
    return place.x > 0 && place.x < length_ && place.z > 0 && place.z < height_;
  }

  template <class Tank>
  void sort_particles(Particles& particles, const Tank& tank, Array<double>& scratch) {
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

  CellGrid grid_beyond_walls() const {
    return {-support_,          length_ + support_,      -support_,
            height_ + support_, kernel_cells * support_, kernel_cells * support_};
  }

  void list_images() {
    if (!image_grid_) image_grid_ = grid_beyond_walls();
    listed_.clear();
    keys_.clear();
    const auto maps = mirror_maps<FreeSlipMirror>({0, length_, 0, height_, 0, 0});
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

  void list_image(std::size_t i, int bits, const std::array<MirrorMap, reflection_count>& maps) {
    const double x = maps[bits].scale_x * built_x_[i] + maps[bits].offset_x,
                 z = maps[bits].scale_z * built_z_[i] + maps[bits].offset_z;
    for (const Rectangle& obstacle : obstacles_)
      if (holds(obstacle, x, z)) return;
    listed_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint8_t>(bits)});
    keys_.push_back(image_grid_->cell(x, z));
  }

  struct Image {
    std::uint32_t owner;
    std::uint8_t reflection;
  };

  // In kernel radii; the values were chosen by measurement on a calm and on a breaking surge.
  static constexpr double smallest_slack = 0.0125, largest_slack = 0.1, steps_per_list = 6;
  // In particle spacings: eight particles of a row form a cluster about as wide as it is high.
  static constexpr double cell_height = 2.83, cell_width = 0.5;

  // Cells of images and solids, in kernel radii; these points are few and need few cells.
  static constexpr double kernel_cells = 0.5;

  double support_, length_, height_, rounding_, reach_ = 0, slack_ = 0;
  CellGrid grid_;
  std::optional<CellGrid> image_grid_, solid_grid_, node_grid_;  // where there are any
  Array<Source> sources_;
  ClusterLists clusters_, solid_clusters_;
  std::vector<Rectangle> obstacles_;
  LineOfSight sight_;
  // The faces that solids stand behind, in the order of their sources, and those that the nodes
  // stand behind that are the places of solids themselves; empty without thin obstacles.
  std::vector<int> solid_faces_, node_faces_;
  std::vector<std::uint32_t> solid_order_;
  Array<float> node_x_, node_z_, solid_x_, solid_z_;
  std::vector<Image> images_, listed_;
  Array<float> image_x_, image_z_;
  std::vector<std::uint32_t> keys_, order_;
  Array<float> built_x_, built_z_;
  std::size_t stray_ = 0;
};

}  // namespace slosh::sph
