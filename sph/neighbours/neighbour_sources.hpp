// The sources of the pair sums, each kind sorted by cell: the liquid in the order of its particles,
// then its mirror images, then the particles of solids. `rebuild` sorts the particles, decides
// which images exist and lists the sources of every cluster; it uses positions in single precision
// and a reach that allows for their rounding. Between rebuilds, `refresh_for_...` fill in the state
// of the liquid and its images many times; the solids (walls/solids.hpp) fill in their own.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
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
  NeighbourSources(const Tank& tank, double spacing, double support);

  // Adds the solids' particles and their nodes, at which their sums are evaluated, in the tank [m].
  // Sorts `places` by cell; they must not change afterwards. Images that fall into an obstacle are
  // left out, and obstacles thinner than the support hide what is behind them.
  void add_solids(std::vector<SolidPlace>& places, std::vector<Rectangle> obstacles);

  // Sorts the particles by cell, and lists their images, where walls have any, and the sources of
  // every cluster for some steps of dt. Returns false where a particle, `stray()`, is not in the
  // tank. `scratch` is overwritten.
  bool rebuild(Particles& particles, const Tank& tank, double dt, bool has_images,
               Array<double>&& scratch = {});
  std::size_t stray() const { return stray_; }

  // Returns whether a particle may, by the end of a step of dt, have moved farther relative to the
  // tank than the lists of the last rebuild allow.
  bool stale(const Particles& particles, const Tank& tank, double dt) const;
  // Returns the largest speed relative to the tank [m/s]. The loop is written as that of stale().
  static double fastest(const Particles& particles, const Tank& tank);
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
  template <class Scheme>
  void refresh_for_momentum(const Scheme& scheme, const Particles& p, const Tank& tank) {
    refresh_liquid(scheme, p, [&](Source& source, std::size_t i) {
      source.strength =
          scheme.formulation.strength(scheme.state.pressure(p.density[i]), p.density[i]);
      source.density = p.density[i];
    });
    refresh_images<Scheme, typename Scheme::Mirror>(p, tank, [&](Source& source, std::size_t i) {
      source.strength = sources_[i].strength;
      if constexpr (Scheme::Mirror::hydrostatic)
        source.strength = scheme.formulation.strength(
            scheme.state.pressure(p.density[i]) + pressure_rise(scheme, tank, source, p, i),
            p.density[i]);
      source.density = p.density[i];
    });
  }

  // Fills in the state that the continuity sum reads, for the liquid and its images.
  template <class Scheme>
  void refresh_for_continuity(const Scheme& scheme, const Particles& p, const Tank& tank) {
    using Diffusion = typename Scheme::DensityDiffusion;
    using Mirror = typename Scheme::Mirror::InContinuity;
    refresh_liquid(scheme, p, [&](Source& source, std::size_t i) {
      if constexpr (Diffusion::active)
        source.density = scheme.density_diffusion.diffused(
            scheme.state.pressure(p.density[i]), p.density[i], tank.height(p.x[i], p.z[i]));
    });
    refresh_images<Scheme, Mirror>(p, tank, [&](Source& source, std::size_t i) {
      if constexpr (Diffusion::active) source.density = sources_[i].density;
      if constexpr (Diffusion::of_whole_density && Mirror::hydrostatic) {
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
  template <class Mirror, class Visit>
  void for_each_image(const Tank& tank, const Visit& visit) const {
    const std::size_t n = built_x_.size();
    const MirrorMap itself;
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i) visit(i, i, itself);
    if constexpr (Mirror::exists) {
      const auto maps = mirror_maps(tank.walls, Mirror::no_slip);
#pragma omp parallel for schedule(static)
      for (std::size_t k = 0; k < images_.size(); ++k)
        visit(n + k, images_[k].owner, maps[images_[k].reflection]);
    }
  }

  // Returns the walls behind which a source lies, as a sum of the bits of Reflection; none for the
  // liquid and for obstacles within the tank. What continues an obstacle behind a wall lies behind
  // that wall.
  int walls_before(std::size_t source) const;

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
  [[gnu::noinline]] void list_seen_sources(const std::vector<SortedPoints>& points);

  // Fills in the state of the liquid that both sums read; complete(source, i) fills in the rest.
  template <class Scheme, class Complete>
  void refresh_liquid(const Scheme& scheme, const Particles& p, const Complete& complete) {
    const std::size_t n = built_x_.size();
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i) {
      Source& source = sources_[i];
      source.x = p.x[i];
      source.z = p.z[i];
      source.velocity_x = p.velocity_x[i];
      source.velocity_z = p.velocity_z[i];
      source.weight = scheme.formulation.weight(p.mass[i], p.density[i]);
      if constexpr (Scheme::Smoothing::reads_spacing) source.spacing = p.spacing[i];
      complete(source, i);
    }
  }

  // Fills in the state of the images that both sums read; complete(source, owner) fills in the
  // rest.
  template <class Scheme, class Mirror, class Complete>
  void refresh_images(const Particles& p, const Tank& tank, const Complete& complete) {
    if constexpr (!Mirror::exists) return;
    const std::size_t n = built_x_.size();
    const auto maps = mirror_maps(tank.walls, Mirror::no_slip);
#pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < images_.size(); ++k) {
      const std::size_t i = images_[k].owner;
      const MirrorMap& map = maps[images_[k].reflection];
      Source& source = sources_[n + k];
      source.x = map.scale_x * p.x[i] + map.offset_x;
      source.z = map.scale_z * p.z[i] + map.offset_z;
      source.velocity_x = map.velocity_scale_x * p.velocity_x[i] + map.velocity_offset_x;
      source.velocity_z = map.velocity_scale_z * p.velocity_z[i];
      source.weight = sources_[i].weight;
      if constexpr (Scheme::Smoothing::reads_spacing) source.spacing = sources_[i].spacing;
      complete(source, i);
    }
  }

  // Returns the rise of the hydrostatic pressure from the owner to its image [Pa].
  template <class Scheme>
  static double pressure_rise(const Scheme& scheme, const Tank& tank, const Source& source,
                              const Particles& p, std::size_t i) {
    const Vector2 gravity = tank.apparent_gravity(scheme.setting.gravity, p.x[i], p.z[i],
                                                  p.velocity_x[i], p.velocity_z[i]);
    return p.density[i] * (gravity.x * (source.x - p.x[i]) + gravity.z * (source.z - p.z[i]));
  }

  double slack_for(double step) const;
  bool inside(Vector2 place) const;
  void sort_particles(Particles& particles, const Tank& tank, Array<double>& scratch);
  CellGrid grid_beyond_walls() const;
  void list_images();
  void list_image(std::size_t i, int bits, const std::array<MirrorMap, reflection_count>& maps);

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
