#include "sph/liquid.hpp"

#include <algorithm>
#include <utility>

#include "sph/guards/stability_guard.hpp"
#include "sph/walls/obstacle_contact.hpp"
#include "sph/walls/thin_obstacles.hpp"

namespace slosh::sph {
namespace {

// In a scheme with one spacing, all particles have the same spacing and it is stored once.
Particles held_particles(Particles p, const SchemeTerms& terms) {
  if (terms.reads_spacing || p.spacing.empty()) return p;
  p.lattice_spacing = p.spacing.front();
  p.spacing = Array<double>();  // gives its memory back
  return p;
}

}  // namespace

Liquid::Liquid(const Scene& scene, Method method, Particles initial)
    : particles(held_particles(std::move(initial), *method.terms)),
      method_(std::move(method)),
      scene_(scene),
      neighbours_(tank_at(0), scene.particle_spacing, largest_support()),
      solids_(terms().solids(scene, largest_support())),
      obstacles_(obstacles_on_lattice(scene, largest_support())),
      outline_(outline_of(scene)),
      gap_(setting()) {
  if (gap_.exists()) gap_.begin(particles);
  neighbours_.add_solids(solids_->places(), obstacles_);
  keep_thick_obstacles();
  solids_->initialise();
  renew_neighbours(0);
}

bool Liquid::renew_neighbours(double dt) {
  const Tank tank = tank_at(time);
  const auto confine = [&](const auto& contact) { return contact.confine(particles, tank); };
  const std::size_t exchanged =
      outline_ ? confine_to(*outline_, particles, tank) : std::visit(confine, method_.wall_contact);
  exchanged_at_walls_ += exchanged;
  std::size_t moved = exchanged;
  for (const Rectangle& obstacle : obstacles_) moved += expel(particles, tank, obstacle);
  if (const LineOfSight& sight = neighbours_.sight(); sight.exists())
    moved += turn_back(particles, tank, sight,
                       [&](std::size_t i) { return neighbours_.place_at_rebuild(i); });
  if (moved > 0) of_sample_ = false;
  if (!neighbours_.stale(particles, tank, dt)) return false;
  of_sample_ = false;
  if (!neighbours_.rebuild(particles, tank, dt, terms().has_images, std::move(rates.density_rate)))
    throw_bad_particle(particles, neighbours_.stray(), time, "outside the tank");
  rates.resize(particles.size());
  return true;
}

void Liquid::accelerate(double t) {
  if (std::exchange(of_sample_, false)) return;
  accelerate(t, Dissipation::included, rates);
  if (keeps_wall_power_) wall_power_ = power_of_walls(rates, t);
}

void Liquid::accelerate_for_sample() {
  of_sample_ = false;
  accelerate(time);
  of_sample_ = true;
}

void Liquid::evaluate(Rates& result, Dissipation dissipation) {
  result.resize(particles.size());
  accelerate(time, dissipation, result);
  compress(time, dissipation, result);
}

void Liquid::accelerate(double t, Dissipation dissipation, Rates& result) {
  const Tank tank = tank_at(t);
  terms().refresh_for_momentum(at(tank));
  solids_->refresh_for_momentum(at(tank));
  terms().sum_momentum(at(tank), dissipation, result);
  std::visit([&](const auto& contact) { contact.push(particles, tank, result); },
             method_.wall_contact);
  // The friction is viscous stress, and so a part of what the energy budget leaves out.
  if (gap_.exists())
    gap_.add(dissipation == Dissipation::included ? 1 : 0, particles,
             tank_at(t - velocities_behind), result);
}

void Liquid::compress(double t, Dissipation dissipation, Rates& result) {
  const Tank tank = tank_at(t);
  terms().refresh_for_continuity(at(tank));
  solids_->refresh_for_continuity(at(tank));
  terms().sum_continuity(at(tank), dissipation, gradient_, result);
}

Array<double>& Liquid::kernel_sums() {
  const Tank tank = tank_at(time);
  terms().refresh_for_momentum(at(tank));
  solids_->refresh_for_momentum(at(tank));
  terms().sum_kernel(at(tank), rates.density_rate);
  return rates.density_rate;
}

double Liquid::median_kernel_sum() {
  Array<double>& sums = kernel_sums();
  const auto middle = sums.begin() + static_cast<std::ptrdiff_t>(sums.size() / 2);
  std::nth_element(sums.begin(), middle, sums.end());
  return *middle;
}

void Liquid::kick(double dt) {
  add_scaled(particles.velocity_x, dt, rates.acceleration_x);
  add_scaled(particles.velocity_z, dt, rates.acceleration_z);
}

void Liquid::drift(double dt) {
  add_scaled(particles.x, dt, particles.velocity_x);
  add_scaled(particles.z, dt, particles.velocity_z);
  advance_gap(dt, time);
}

void Liquid::update_density(double dt) {
  add_scaled(particles.density, dt, rates.density_rate);
  solids_->advance_density(dt);
}

void Liquid::kick_and_drift(double kick_dt, double drift_dt) {
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

void Liquid::update_density_and_drift(double density_dt, double drift_dt) {
  Particles& p = particles;
#pragma omp parallel for simd schedule(static)
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.density[i] += density_dt * rates.density_rate[i];
    p.x[i] += drift_dt * p.velocity_x[i];
    p.z[i] += drift_dt * p.velocity_z[i];
  }
  solids_->advance_density(density_dt);
  advance_gap(drift_dt, time + drift_dt);
}

void Liquid::save() {
  saved_ = particles;
  if (const Array<double>* density = solids_->density()) saved_solid_density_ = *density;
}

void Liquid::restore() {
  particles = saved_;
  if (Array<double>* density = solids_->density()) *density = saved_solid_density_;
}

void Liquid::report_memory(HeldArrays& held) {
  held.add_all("state", particles);
  held.add_all("rates", rates);
  held.add_all("saved state", saved_);
  held.add("saved state", "solid_density", saved_solid_density_);
  held.add_all("density gradient", gradient_);
  solids_->report_memory(held);
  held.add_all("neighbours", neighbours_);
}

PowerAt Liquid::power_of_walls(const Rates& of, double t) const {
  return {t, slosh::sph::power_of_walls(particles, of, tank_at(t), TankMotion(scene_, t),
                                        scene_.gravity)};
}

// The layers follow the particles while these move for dt with the velocities of the time t.
void Liquid::advance_gap(double dt, double t) {
  if (gap_.exists()) gap_.advance(particles, tank_at(t), dt);
}

// Takes the thin obstacles out of obstacles_. They turn particles back (walls/thin_obstacles.hpp);
// the others expel them through the nearest face.
void Liquid::keep_thick_obstacles() {
  std::erase_if(obstacles_, [&](const Rectangle& r) {
    return is_thin(r, largest_support(), scene_.tank_length, scene_.tank_height);
  });
}

double Liquid::largest_support() const {
  double spacing = particles.lattice_spacing;
  for (const double one : particles.spacing) spacing = std::max(spacing, one);
  return kernel_support / terms().inverse_smoothing_length(spacing);
}

}  // namespace slosh::sph
