// The liquid's initial state, one of:
//   lattice    the hydrostatic lattice with the initial velocity (initial_lattice.hpp)
//   settled    the same after a relaxation: the square lattice changes to a closer packing by its
//              own pressure, and the energy that this sets free is damped before the run
//   projected  the lattice in the incompressible liquid's state at 0+; a weakly compressible
//              liquid rings with sound waves after an impulsive start or the release of a dam. G is
//              the scheme's own pressure acceleration and D its divergence, walls included:
//                velocity  v = u + G P, D v = 0 with the walls' velocity, where P is the pressure
//                          impulse of the start (Batchelor 1967, section 6.10)
//                pressure  D (G p + g) = 0 with the walls' acceleration, where g includes the
//                          inertial forces of the tank's frame
//              This is the projection of Cummins & Rudman 1999, eqs 11 to 15.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "sph/liquid.hpp"
#include "sph/run_output.hpp"
#include "sph/scene.hpp"
#include "sph/scheme.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/start/initial_surface.hpp"
#include "sph/start/linear_solver.hpp"
#include "sph/terms/density_diffusion.hpp"
#include "sph/terms/equation_of_state.hpp"
#include "sph/terms/viscosity.hpp"
#include "sph/walls/frames.hpp"

namespace slosh::sph {

inline const char* start_name(InitialState state) {
  if (state == InitialState::lattice) return "start from the hydrostatic lattice";
  return state == InitialState::settled ? "start from settled particles"
                                        : "start from the incompressible liquid's state";
}

// The tank held at its initial position, with a given velocity and acceleration. `rolls` keeps the
// roll's initial rate and acceleration, which matter in the tank's frame only.
struct HeldTank {
  double velocity = 0, acceleration = 0;
  bool rolls = false;

  Scene scene(Scene scene) const {
    const double place = scene.displacement(0);
    scene.displacement = [place](double) { return place; };
    scene.velocity = [this](double) { return velocity; };
    scene.acceleration = [this](double) { return acceleration; };
    if (scene.roll) {
      const auto held = [this](const std::function<double(double)>& of_time) {
        return [this, value = of_time(0)](double) { return rolls ? value : 0.0; };
      };
      scene.roll->angle = [angle = scene.roll->angle(0)](double) { return angle; };
      scene.roll->rate = held(scene.roll->rate);
      scene.roll->acceleration = held(scene.roll->acceleration);
    }
    return scene;
  }
};

// The choice's operators for pressure and divergence alone, without viscosity and diffusion.
template <class Choice>
struct PressureAlone : Choice {
  using EquationOfState = LinearState;
  using Viscosity = NoViscosity;
  using DensityDiffusion = NoDensityDiffusion;
};

template <class Choice>
class Projection {
 public:
  Projection(const Scene& scene, const Particles& start)
      : scene_(tank_.scene(scene)),
        surface_(scene),
        weightless_(scene_, operators(scene, 0), start),
        heavy_(scene_, operators(scene, scene.gravity), start) {
    set_density(weightless_.particles, [&](std::size_t) { return rest_density(); });
    set_density(heavy_.particles, [&](std::size_t i) {
      return heavy_.scheme().state.density(hydrostatic_pressure(heavy_.particles, i));
    });
  }

  // Returns the initial particles in the incompressible liquid's state; their order may differ from
  // the lattice's. `density_at` gives the density [kg/m3] at a pressure [Pa]. Throws
  // SimulationError where the linear solver does not converge.
  Particles state(double wall_velocity, double wall_acceleration,
                  const std::function<double(double)>& density_at) {
    Particles result = weightless_.particles;
    push(pressure_against(result.velocity_x, result.velocity_z, wall_velocity));
    add_scaled(result.velocity_x, 1, weightless_.rates.acceleration_x);
    add_scaled(result.velocity_z, 1, weightless_.rates.acceleration_z);

    heavy_.particles.velocity_x = result.velocity_x;
    heavy_.particles.velocity_z = result.velocity_z;
    tank_ = {.acceleration = wall_acceleration, .rolls = true};
    heavy_.accelerate(0);
    tank_ = {};
    const Eigen::VectorXd pressure = pressure_against(
        heavy_.rates.acceleration_x, heavy_.rates.acceleration_z, wall_acceleration);
    set_density(result, [&](std::size_t i) {
      return density_at(hydrostatic_pressure(result, i) +
                        unit_pressure() * pressure[static_cast<long>(i)]);
    });
    return result;
  }

 private:
  using Operators = Scheme<PressureAlone<Choice>>;
  // The density is the rest density times (1 + small_compression times an unknown), so that the
  // operators are linear in the unknown to 1e-6.
  static constexpr double small_compression = 1e-6;
  static constexpr double tolerance = 1e-3;  // of the divergence, relative to its initial value
  static constexpr int most_iterations = 2000;

  static Operators operators(const Scene& scene, double gravity) {
    Operators operators(scene);
    operators.setting.gravity = gravity;
    operators.setting.breadth = 0;
    return operators;
  }

  // Sets the densities and keeps the volumes.
  template <class DensityOf>
  static void set_density(Particles& p, const DensityOf& density_of) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double density = density_of(i);
      p.mass[i] *= density / p.density[i];
      p.density[i] = density;
    }
  }

  double hydrostatic_pressure(const Particles& p, std::size_t i) const {
    const Vector2 place = weightless_.tank_at(0).in_tank(p.x[i], p.z[i]);
    return surface_.pressure(place.x, place.z);
  }

  double rest_density() const { return weightless_.scheme().setting.rest_density; }

  double unit_pressure() const {
    const LinearState& state = weightless_.scheme().state;
    return small_compression * state.rest_density * state.speed_of_sound * state.speed_of_sound;
  }

  // Computes the acceleration by the pressure into the weightless liquid's rates.
  void push(const Eigen::VectorXd& pressure) {
    Array<double>& density = weightless_.particles.density;
    const double rest = rest_density();
    for (std::size_t i = 0; i < density.size(); ++i)
      density[i] = rest * (1 + small_compression * pressure[static_cast<long>(i)]);
    weightless_.accelerate(0);
    std::fill(density.begin(), density.end(), rest);
  }

  Eigen::VectorXd divergence(const Array<double>& x, const Array<double>& z, double wall_velocity) {
    weightless_.particles.velocity_x = x;
    weightless_.particles.velocity_z = z;
    tank_.velocity = wall_velocity;
    weightless_.compress(0);
    tank_.velocity = 0;
    const Array<double>& rate = weightless_.rates.density_rate;
    return Eigen::Map<const Eigen::VectorXd>(rate.data(), static_cast<long>(rate.size()));
  }

  // Returns the pressure whose acceleration cancels the divergence of the field (x, z).
  Eigen::VectorXd pressure_against(const Array<double>& x, const Array<double>& z,
                                   double wall_velocity) {
    const Eigen::VectorXd excess = divergence(x, z, wall_velocity);
    if (excess.norm() == 0) return Eigen::VectorXd::Zero(excess.size());
    // The scale keeps the response linear and the density's change well above round-off.
    const double scale = 1e-3 / excess.lpNorm<Eigen::Infinity>();
    const LinearSolution solution = solve(
        [this](const Eigen::VectorXd& pressure) {
          push(pressure);
          return Eigen::VectorXd(
              -divergence(weightless_.rates.acceleration_x, weightless_.rates.acceleration_z, 0));
        },
        scale * excess, tolerance, most_iterations);
    if (!(solution.relative_residual <= 10 * tolerance))
      throw SimulationError(
          fmt::format("initial_state = projected: the pressure's residual is {:.2g} after {} "
                      "iterations, expected {:.0g}",
                      solution.relative_residual, solution.iterations, tolerance));
    return solution.x / scale;
  }

  HeldTank tank_;
  Scene scene_;
  InitialSurface surface_;
  Liquid<Operators> weightless_, heavy_;
};

// Returns the lattice after a damped relaxation in a tank at rest. A small disorder, symmetric
// about the tank's middle, starts the rearrangement.
template <class Choice>
Particles settled(const Scene& scene, const Scheme<Choice>& scheme, const Particles& start) {
  const HeldTank tank;
  const Scene still = tank.scene(scene);
  Liquid<Scheme<Choice>> liquid(still, scheme, start);
  Particles& p = liquid.particles;
  const double middle = liquid.tank_at(0).in_frame(0.5 * scene.tank_length, 0).x;
  perturb_symmetrically(p, middle, 0.02 * scene.particle_spacing);
  std::fill(p.velocity_x.begin(), p.velocity_x.end(), 0.0);
  // At a depth of 0.35 m the duration is 3 s. There the kinetic energy of the remaining and of the
  // later motion was measured to stay below 3e-6 of the potential energy at 10 mm and 8e-6 at 25
  // mm.
  const double unit = std::sqrt(scene.fill_depth / scene.gravity);
  const double duration = 16 * unit, damping = 0.4 / unit;
  typename Choice::Integrator integrator;
  const double dt = scheme.time_step(scene.gravity, scheme.setting.speed_of_sound);
  for (; liquid.time < duration; liquid.time += dt) {
    integrator.advance(liquid, dt);
    add_scaled(p.velocity_x, -damping * dt, p.velocity_x);
    add_scaled(p.velocity_z, -damping * dt, p.velocity_z);
  }
  Particles result = p;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 place = liquid.tank_at(0).in_tank(p.x[i], p.z[i]);
    result.x[i] = place.x;
    result.z[i] = place.z;
  }
  enter<typename Choice::Frame>(scene, result);
  return result;
}

template <class Choice>
InitialState chosen_state(const Scene& scene) {
  return scene.initial_state.value_or(Choice::initial_state);
}

// Throws std::invalid_argument for an initial state that is impossible with the scheme or the
// scene.
template <class Choice>
void require_initial_state(const Scene& scene) {
  const InitialState wanted = chosen_state<Choice>(scene);
  if (wanted == InitialState::projected &&
      (Choice::Solids::has_density || Choice::Smoothing::reads_spacing))
    throw std::invalid_argument(
        "initial_state = projected: expected lattice | settled, because this scheme has walls with "
        "a density of their own or two spacings");
  if (wanted == InitialState::settled && (scene.column_width || scene.initial_wave))
    throw std::invalid_argument(
        "initial_state = settled: expected lattice | projected, because a dam would break and a "
        "wave would run while the particles settle");
  if (scene.start_rotation != 0 &&
      (wanted != InitialState::settled || !scene.obstacles.empty() || !scene.outline.empty() ||
       scene.surface_particle_spacing != scene.particle_spacing))
    throw std::invalid_argument(fmt::format(
        "start_rotation = {} rad: expected 0 unless the initial state is settled, in a rectangular "
        "tank without obstacles and with one spacing, because rotated rows do not fit the walls",
        scene.start_rotation));
}

// Returns the lattice in the scheme's frame, before any preparation.
template <class Choice>
Particles start_lattice(const Scene& scene, const Scheme<Choice>& scheme) {
  require_initial_state<Choice>(scene);
  Particles lattice =
      initial_lattice(scene, [&](double pressure) { return scheme.state.density(pressure); });
  perturb_randomly(lattice, scene.start_disorder, scene.start_seed);
  enter<typename Choice::Frame>(scene, lattice);
  return lattice;
}

template <class Choice>
Particles initial_state(const Scene& scene, const Scheme<Choice>& scheme) {
  const auto density_at = [&](double pressure) { return scheme.state.density(pressure); };
  Particles lattice = start_lattice(scene, scheme);
  if (scene.duration == 0) return lattice;
  const InitialState wanted = chosen_state<Choice>(scene);
  if (wanted == InitialState::settled) return settled<Choice>(scene, scheme, lattice);
  if constexpr (!Choice::Solids::has_density && !Choice::Smoothing::reads_spacing)
    if (wanted == InitialState::projected)
      return Projection<Choice>(scene, lattice)
          .state(scene.velocity(0), scene.acceleration(0), density_at);
  return lattice;
}

}  // namespace slosh::sph
