// The liquid of one scheme: its particles, their neighbours, and the two right-hand sides that the
// integrators call.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "sph/guards/stability_guard.hpp"
#include "sph/held_arrays.hpp"
#include "sph/integrators.hpp"
#include "sph/neighbours/density_gradient.hpp"
#include "sph/neighbours/kernel_sum.hpp"
#include "sph/neighbours/neighbour_sources.hpp"
#include "sph/neighbours/pair_sums.hpp"
#include "sph/neighbours/particles.hpp"
#include "sph/scene.hpp"
#include "sph/terms/gap_friction.hpp"
#include "sph/terms/kernels.hpp"
#include "sph/walls/obstacle_contact.hpp"
#include "sph/walls/outline_contact.hpp"
#include "sph/walls/thin_obstacles.hpp"
#include "sph/walls/wall_power.hpp"

namespace slosh::sph {

template <class Scheme>
class Liquid {
 public:
  Particles particles;
  Rates rates;
  double time = 0;
  // How long before the time the velocities are taken, by a staggered integrator [s].
  double velocities_behind = 0;

  Liquid(const Scene& scene, const Scheme& scheme, Particles initial)
      : particles(held_particles(std::move(initial))),
        scheme_(scheme),
        scene_(scene),
        neighbours_(tank_at(0), scene.particle_spacing, largest_support()),
        solids_(scene, !Scheme::Mirror::exists, largest_support()),
        obstacles_(obstacles_on_lattice(scene, largest_support())),
        outline_(outline_of(scene)),
        gap_(scheme.setting) {
    if (gap_.exists()) gap_.begin(particles);
    neighbours_.add_solids(solids_.places(), obstacles_);
    keep_thick_obstacles();
    solids_.initialise(scheme_);
    renew_neighbours(0);
  }

  auto tank_at(double t) const { return Scheme::Frame::tank(scene_, t); }

  // Makes the neighbour lists valid for a step of dt from now. Returns whether they were rebuilt.
  bool renew_neighbours(double dt) {
    const auto tank = tank_at(time);
    const std::size_t exchanged = outline_ ? confine_to(*outline_, particles, tank)
                                           : scheme_.wall_contact.confine(particles, tank);
    exchanged_at_walls_ += exchanged;
    std::size_t moved = exchanged;
    for (const Rectangle& obstacle : obstacles_) moved += expel(particles, tank, obstacle);
    if (const LineOfSight& sight = neighbours_.sight(); sight.exists())
      moved += turn_back(particles, tank, sight,
                         [&](std::size_t i) { return neighbours_.place_at_rebuild(i); });
    if (moved > 0) of_sample_ = false;
    if (!neighbours_.stale(particles, tank, dt)) return false;
    of_sample_ = false;
    if (!neighbours_.rebuild<typename Scheme::Mirror>(particles, tank, dt,
                                                      std::move(rates.density_rate)))
      throw_bad_particle(particles, neighbours_.stray(), time, "outside the tank");
    rates.resize(particles.size());
    return true;
  }

  void accelerate(double t) {
    if (std::exchange(of_sample_, false)) return;
    accelerate(scheme_, t, rates);
    if (keeps_wall_power_) wall_power_ = power_of_walls(rates, t);
  }
  // Evaluates the accelerations of the present state and time, which a sample records and which
  // limit the next step. That step begins with them unless it first changes the state or the order
  // of the particles.
  void accelerate_for_sample() {
    of_sample_ = false;
    accelerate(time);
    of_sample_ = true;
  }
  void compress(double t) { compress(scheme_, tank_at(t), rates); }

  // Computes the rates of the present state with the numbers of `scheme`, without any effect on the
  // liquid's later steps.
  void evaluate(const Scheme& scheme, Rates& result) {
    result.resize(particles.size());
    accelerate(scheme, time, result);
    compress(scheme, tank_at(time), result);
  }

  // Returns each particle's kernel sum over liquid, images and solids (neighbours/kernel_sum.hpp).
  // Overwrites the densities' rates, which every step computes before it reads them.
  Array<double>& kernel_sums() {
    const auto tank = tank_at(time);
    neighbours_.refresh_for_momentum(scheme_, particles, tank);
    solids_.refresh_for_momentum(scheme_, neighbours_, tank, instructions_);
    sum_kernel(scheme_, neighbours_.clusters(), neighbours_.sources(), particles,
               rates.density_rate, instructions_);
    return rates.density_rate;
  }
  // Returns their median, and overwrites the same rates.
  double median_kernel_sum() {
    Array<double>& sums = kernel_sums();
    const auto middle = sums.begin() + static_cast<std::ptrdiff_t>(sums.size() / 2);
    std::nth_element(sums.begin(), middle, sums.end());
    return *middle;
  }

  void kick(double dt) {
    add_scaled(particles.velocity_x, dt, rates.acceleration_x);
    add_scaled(particles.velocity_z, dt, rates.acceleration_z);
  }
  void drift(double dt) {
    add_scaled(particles.x, dt, particles.velocity_x);
    add_scaled(particles.z, dt, particles.velocity_z);
    advance_gap(dt, time);
  }
  void update_density(double dt) {
    add_scaled(particles.density, dt, rates.density_rate);
    if constexpr (Scheme::Solids::has_density) solids_.advance_density(scheme_, dt);
  }

  // Each of these does two updates, in the order of its name, in one pass over the memory. They
  // serve a half of a step, with velocities of its middle.
  void kick_and_drift(double kick_dt, double drift_dt) {
    Particles& p = particles;
#pragma omp parallel for simd schedule(static)
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.velocity_x[i] += kick_dt * rates.acceleration_x[i];
      p.velocity_z[i] += kick_dt * rates.acceleration_z[i];
      p.x[i] += drift_dt * p.velocity_x[i];
      p.z[i] += drift_dt * p.velocity_z[i];
    }
    advance_gap(drift_dt, time + drift_dt);
  }
  void update_density_and_drift(double density_dt, double drift_dt) {
    Particles& p = particles;
#pragma omp parallel for simd schedule(static)
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.density[i] += density_dt * rates.density_rate[i];
      p.x[i] += drift_dt * p.velocity_x[i];
      p.z[i] += drift_dt * p.velocity_z[i];
    }
    if constexpr (Scheme::Solids::has_density) solids_.advance_density(scheme_, density_dt);
    advance_gap(drift_dt, time + drift_dt);
  }

  // These serve integrators that return to the start of a step.
  void save() {
    saved_ = particles;
    if constexpr (Scheme::Solids::has_density) saved_solid_density_ = solids_.density();
  }
  void restore() {
    particles = saved_;
    if constexpr (Scheme::Solids::has_density) solids_.set_density(saved_solid_density_);
  }

  // Both call visit(name, value) for the state that the next step reads besides the time.
  template <class Visit>
  void for_each_number(const Visit& visit) {
    visit("exchanged_at_walls", exchanged_at_walls_);
    visit("velocities_behind", velocities_behind);
  }
  template <class Visit>
  void for_each_saved_field(const Visit& visit) {
    particles.for_each_named_field(visit);
    visit("acceleration_x", rates.acceleration_x);
    visit("acceleration_z", rates.acceleration_z);
    if constexpr (Scheme::Solids::has_density) visit("solid_density", solids_.density());
  }
  void report_memory(HeldArrays& held) {
    held.add_all("state", particles);
    held.add_all("rates", rates);
    held.add_all("saved state", saved_);
    held.add("saved state", "solid_density", saved_solid_density_);
    held.add_all("density gradient", gradient_);
    held.add_all("solids", solids_);
    held.add_all("neighbours", neighbours_);
  }
  // The next step sorts the particles and builds the neighbour lists anew.
  void forget_neighbours() { neighbours_.forget(); }

  // Sets the instruction set of the pair loops; the default is the processor's widest.
  void use(InstructionSet set) { instructions_ = set; }

  const Scheme& scheme() const { return scheme_; }
  const NeighbourSources& neighbours() const { return neighbours_; }
  const typename Scheme::Solids& solids() const { return solids_; }
  // Returns the walls' power on the liquid, given its accelerations `of` at the time t.
  PowerAt power_of_walls(const Rates& of, double t) const {
    return {t, slosh::sph::power_of_walls(particles, of, tank_at(t), Motion<Scheme>(scene_, t),
                                          scene_.gravity)};
  }
  // From the next evaluation of the accelerations on, wall_power() is the walls' power on the
  // liquid at the latest evaluation.
  void keep_wall_power() { keeps_wall_power_ = true; }
  const PowerAt& wall_power() const { return wall_power_; }
  // How often a particle that had crossed a wall was put back.
  std::size_t exchanged_at_walls() const { return exchanged_at_walls_; }

 private:
  void accelerate(const Scheme& scheme, double t, Rates& result) {
    const auto tank = tank_at(t);
    neighbours_.refresh_for_momentum(scheme, particles, tank);
    solids_.refresh_for_momentum(scheme, neighbours_, tank, instructions_);
    sum_momentum(scheme, tank, neighbours_.clusters(), neighbours_.sources(), particles, result,
                 instructions_);
    scheme.wall_contact.push(particles, tank, result);
    // The friction is viscous stress, and so a part of what the energy budget leaves out.
    if (gap_.exists())
      gap_.add(scheme.formulation.viscous_share, particles, tank_at(t - velocities_behind), result);
  }
  void compress(const Scheme& scheme, const Tank<Scheme>& tank, Rates& result) {
    neighbours_.refresh_for_continuity(scheme, particles, tank);
    solids_.refresh_for_continuity(scheme, neighbours_, tank, instructions_);
    if constexpr (Scheme::DensityDiffusion::reads_gradient)
      sum_density_gradient(scheme, neighbours_, particles, tank, gradient_, instructions_);
    sum_continuity(scheme, tank, neighbours_.clusters(), neighbours_.sources(), gradient_,
                   particles, result, instructions_);
  }

  // The layers follow the particles while these move for dt with the velocities of the time t.
  void advance_gap(double dt, double t) {
    if (gap_.exists()) gap_.advance(particles, tank_at(t), dt);
  }

  // In a scheme with one spacing, all particles have the same spacing and it is stored once.
  static Particles held_particles(Particles p) {
    if (Scheme::Smoothing::reads_spacing || p.spacing.empty()) return p;
    p.lattice_spacing = p.spacing.front();
    p.spacing = Array<double>();  // gives its memory back
    return p;
  }

  // Takes the thin obstacles out of obstacles_. They turn particles back
  // (walls/thin_obstacles.hpp); the others expel them through the nearest face.
  void keep_thick_obstacles() {
    std::erase_if(obstacles_, [&](const Rectangle& r) {
      return is_thin(r, largest_support(), scene_.tank_length, scene_.tank_height);
    });
  }

  double largest_support() const {
    double spacing = particles.lattice_spacing;
    for (const double one : particles.spacing) spacing = std::max(spacing, one);
    return kernel_support / scheme_.smoothing.inverse(spacing, spacing);
  }

  Scheme scheme_;
  const Scene& scene_;
  NeighbourSources neighbours_;
  typename Scheme::Solids solids_;
  std::vector<Rectangle> obstacles_;
  std::optional<TankOutline> outline_;
  GapFriction gap_;
  DensityGradient gradient_;
  Particles saved_;
  Array<double> saved_solid_density_;
  std::size_t exchanged_at_walls_ = 0;
  bool of_sample_ = false;  // whether the accelerations are those of the present state
  bool keeps_wall_power_ = false;
  PowerAt wall_power_ = {};
  InstructionSet instructions_ = widest_instruction_set();
};

}  // namespace slosh::sph
