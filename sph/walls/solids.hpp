// The state of the particles of obstacles, and of the tank's walls in schemes without mirror
// particles.
//   NoSolids       the scheme takes no obstacles
//   GhostSolids    fixed ghost particles with pressure and velocity extrapolated from the liquid
//   DynamicSolids  dynamic boundary particles: their density follows the continuity equation
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sph/neighbours/ghost_fill.hpp"
#include "sph/neighbours/neighbour_sources.hpp"
#include "sph/neighbours/pair_sums.hpp"
#include "sph/setting.hpp"
#include "sph/start/initial_surface.hpp"
#include "sph/walls/node_sums.hpp"
#include "sph/walls/solid_particles.hpp"

namespace slosh::sph {

// Gives a solid's source its position on the wall, the wall's velocity and its share of a cell.
template <class Scheme, class Axes>
void place(const Scheme& scheme, const SolidPlace& at, const Axes& axes, Source& source) {
  const double rho = scheme.setting.rest_density, dp = scheme.setting.particle_spacing;
  const Vector2 place = axes.in_frame(at.x, at.z);
  const Vector2 velocity = axes.wall_velocity(place.x, place.z);
  source.x = place.x;
  source.z = place.z;
  source.velocity_x = velocity.x;
  source.velocity_z = velocity.z;
  source.weight = scheme.formulation.weight(at.cell_share * rho * dp * dp, rho);
  source.spacing = dp;
}

class NoSolids {
 public:
  static constexpr const char* name = "";
  static constexpr bool has_density = false;

  NoSolids(const Scene& scene, bool, double) {
    if (!scene.obstacles.empty())
      throw std::invalid_argument("obstacle: expected none, this scheme's walls take no obstacles");
  }
  std::vector<SolidPlace>& places() { return places_; }
  template <class Visit>
  void for_each_named_field(const Visit&) {}
  template <class... Arguments>
  void initialise(const Arguments&...) {}
  template <class... Arguments>
  void refresh_for_momentum(const Arguments&...) {}
  template <class... Arguments>
  void refresh_for_continuity(const Arguments&...) {}

 private:
  std::vector<SolidPlace> places_;
};

// A particle has the liquid's pressure and velocity at its node (node_sums.hpp), extrapolated to
// its own position: the pressure rises by rho_0 (g - a_wall) . (r - r_node). For the viscous stress
// the velocity is 2 v_wall - v in the normal component, and with no slip in the tangential one too.
//
// In the continuity equation a particle of the tank's walls has the velocity 2 v_wall - v in the
// normal component alone (Marrone et al. 2011, section 3). Two things keep these particles as close
// to mirror images as fixed ones can be: they stand twice as densely along the wall as the liquid,
// whose lattice would otherwise catch on theirs, and they count only as far as there is liquid at
// their nodes (ghost_fill.hpp).
//
// A particle of an obstacle counts whole and has the wall's velocity in the continuity equation
// (Adami, Hu & Adams 2012). With a velocity extrapolated from the liquid, still water around an
// obstacle's edges was measured to gain energy, because no pressure balances it.
template <Slip slip>
class GhostSolids {
 public:
  static constexpr const char* name =
      slip == Slip::free ? "fixed ghost particles, extrapolated pressure, free slip"
                         : "fixed ghost particles, extrapolated pressure, no slip";
  static constexpr bool has_density = false;

  GhostSolids(const Scene& scene, bool tank_walls, double depth)
      : places_(solid_places(scene, tank_walls, depth, 2)),
        sight_(thin_obstacles(obstacles_on_lattice(scene, depth), depth, scene.tank_length,
                              scene.tank_height)) {}
  std::vector<SolidPlace>& places() { return places_; }
  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    visit("places", places_);
    nodes_.for_each_named_field(visit);
    fill_.for_each_named_field(visit);
  }

  // The places must have their final order.
  template <class Scheme>
  void initialise(const Scheme& scheme) {
    nodes_.place(places_);
    fill_.initialise(function_of<typename Scheme::Kernel>(), places_,
                     scheme.setting.smoothing_length(), scheme.setting.particle_spacing, sight_);
  }

  template <class Scheme>
  void refresh_for_momentum(const Scheme& scheme, NeighbourSources& neighbours, const Tank& at,
                            InstructionSet set) {
    look_up(NodeValue::strength, scheme, neighbours, at, set);
    const Tank tank = at;  // a copy, which the loop cannot change
    const double rho = scheme.setting.rest_density;
    neighbours.for_each_solid_source([&](Source& source, std::size_t i) {
      place_with_share(scheme, i, tank, source);
      if (nodes_.found(i)) reflect(i, slip, tank, source);
      const double rise = pressure_rise(scheme, i, tank);
      source.strength =
          nodes_.found(i) ? nodes_.value[i] + scheme.formulation.strength(rise, rho) : 0.0;
      source.density = rho;
    });
  }

  template <class Scheme>
  void refresh_for_continuity(const Scheme& scheme, NeighbourSources& neighbours, const Tank& at,
                              InstructionSet set) {
    look_up(NodeValue::density, scheme, neighbours, at, set);
    const Tank tank = at;
    neighbours.for_each_solid_source([&](Source& source, std::size_t i) {
      place_with_share(scheme, i, tank, source);
      if (nodes_.found(i) && !places_[i].in_obstacle) reflect(i, Slip::free, tank, source);
      if constexpr (Scheme::DensityDiffusion::active)
        if (!nodes_.found(i)) {
          // The particle has the density of a liquid without pressure.
          const double rho = scheme.setting.rest_density;
          source.density =
              scheme.density_diffusion.diffused(0.0, rho, tank.height(source.x, source.z));
          return;
        }
      source.density = nodes_.value[i];
      if constexpr (Scheme::DensityDiffusion::of_whole_density) {
        const double sound = scheme.state.speed_of_sound;
        source.density += pressure_rise(scheme, i, tank) / (sound * sound);
      }
    });
  }

 private:
  template <class Scheme>
  void place_with_share(const Scheme& scheme, std::size_t i, const Tank& tank,
                        Source& source) const {
    place(scheme, places_[i], tank.walls, source);
    if (!places_[i].in_obstacle)
      source.weight *= fill_.share(i, scheme.formulation.volume_of_weight * nodes_.liquid[i]);
  }

  void reflect(std::size_t i, Slip at_wall, const Tank& tank, Source& source) const {
    const Turn turn = at_wall == Slip::none ? Turn::both() : places_[i].turn;
    const Vector2 image =
        turn.of({nodes_.velocity_x[i], nodes_.velocity_z[i]}, tank.walls.velocity);
    source.velocity_x = image.x;
    source.velocity_z = image.z;
  }

  // Returns the pressure's rise from the node to the particle [Pa].
  template <class Scheme>
  double pressure_rise(const Scheme& scheme, std::size_t i, const Tank& tank) const {
    const SolidPlace& at = places_[i];
    const Vector2 gravity = tank.apparent_gravity(scheme.setting.gravity, at.x, at.z, 0, 0);
    return scheme.setting.rest_density *
           (gravity.x * (at.x - at.node_x) + gravity.z * (at.z - at.node_z));
  }

  template <class Scheme>
  void look_up(NodeValue value, const Scheme& scheme, NeighbourSources& neighbours,
               const Tank& tank, InstructionSet set) {
    if (places_.empty()) return;
    sum_at_nodes<typename Scheme::Kernel>(value, scheme.setting.smoothing_length(), neighbours,
                                          tank.walls, nodes_, set);
  }

  std::vector<SolidPlace> places_;
  Nodes nodes_;
  LineOfSight sight_;
  GhostFill fill_;
};

// Dynamic boundary particles (Crespo, Gomez-Gesteira & Dalrymple 2007; Zhao et al. 2021, section
// 2.3): they move with the wall, their density follows from the continuity equation over the
// liquid, and their pressure from the equation of state. A density below the rest density is raised
// to it, so that the wall does not attract the liquid.
class DynamicSolids {
 public:
  static constexpr const char* name = "dynamic boundary particles";
  static constexpr bool has_density = true;

  DynamicSolids(const Scene& scene, bool tank_walls, double depth)
      : places_(solid_places(scene, tank_walls, depth, 1)),
        wetted_length_(scene.column_width ? *scene.column_width + depth
                                          : scene.tank_length + depth),
        surface_(scene) {
    for (SolidPlace& place : places_) {  // the sums are evaluated at the particles themselves
      place.node_x = place.x;
      place.node_z = place.z;
    }
  }
  std::vector<SolidPlace>& places() { return places_; }
  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    visit("places", places_);
    particles_.for_each_named_field(visit);
    rates_.for_each_named_field(visit);
  }

  // Sets the density at rest; the places must have their final order.
  template <class Scheme>
  void initialise(const Scheme& scheme) {
    static_assert(!Scheme::Smoothing::reads_spacing);  // the particles hold none
    const std::size_t n = places_.size();
    for (auto* field : {&particles_.x, &particles_.z, &particles_.velocity_x,
                        &particles_.velocity_z, &particles_.density, &rates_.density_rate})
      field->assign(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      const bool wetted = places_[i].x < wetted_length_;
      const double pressure = surface_.pressure(places_[i].x, places_[i].z);
      particles_.density[i] = scheme.state.density(wetted ? std::max(0.0, pressure) : 0.0);
    }
  }

  template <class Scheme>
  void refresh_for_momentum(const Scheme& scheme, NeighbourSources& neighbours, const Tank& tank,
                            InstructionSet) {
    tank.with_axes([&](const auto& axes) {
      neighbours.for_each_solid_source([&](Source& source, std::size_t i) {
        place(scheme, places_[i], axes, source);
        const double rho = particles_.density[i];
        source.strength = scheme.formulation.strength(scheme.state.pressure(rho), rho);
        source.density = rho;
      });
    });
  }

  // Also evaluates the solids' own density rate.
  template <class Scheme>
  void refresh_for_continuity(const Scheme& scheme, NeighbourSources& neighbours, const Tank& tank,
                              InstructionSet set) {
    neighbours.for_each_solid_source([&](Source& source, std::size_t i) {
      tank.with_axes([&](const auto& axes) { place(scheme, places_[i], axes, source); });
      particles_.x[i] = source.x;
      particles_.z[i] = source.z;
      particles_.velocity_x[i] = source.velocity_x;
      particles_.velocity_z[i] = source.velocity_z;
      if constexpr (Scheme::DensityDiffusion::active) {
        const double rho = particles_.density[i];
        source.density = scheme.density_diffusion.diffused(
            scheme.state.pressure(rho), rho, tank.height(particles_.x[i], particles_.z[i]));
      }
    });
    sum_continuity(scheme, tank, neighbours.solid_clusters(), neighbours.sources(), {}, particles_,
                   rates_, set);
  }

  template <class Scheme>
  void advance_density(const Scheme& scheme, double dt) {
    for (std::size_t i = 0; i < places_.size(); ++i)
      particles_.density[i] = std::max(scheme.setting.rest_density,
                                       particles_.density[i] + dt * rates_.density_rate[i]);
  }
  const Array<double>& density() const { return particles_.density; }
  Array<double>& density() { return particles_.density; }
  void set_density(const Array<double>& density) { particles_.density = density; }

 private:
  std::vector<SolidPlace> places_;
  double wetted_length_;  // how far the liquid of the start reaches [m]
  InitialSurface surface_;
  // The fields of the solids' particles that the continuity sum reads, and their rates.
  Particles particles_;
  Rates rates_;
};

}  // namespace slosh::sph
