// The lattice in the incompressible liquid's state at 0+. A weakly compressible liquid rings with
// sound waves after an impulsive start or the release of a dam, and this state spares it that. G is
// the scheme's own pressure acceleration and D its divergence, walls included:
//   velocity  v = u + G P, D v = 0 with the walls' velocity, where P is the pressure impulse of the
//             start (Batchelor 1967, section 6.10)
//   pressure  D (G p + g) = 0 with the walls' acceleration, where g includes the inertial forces of
//             the tank's frame
// This is the projection of Cummins & Rudman 1999, eqs 11 to 15.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>

#include "sph/liquid.hpp"
#include "sph/run_output.hpp"
#include "sph/scene.hpp"
#include "sph/scheme.hpp"
#include "sph/start/held_tank.hpp"
#include "sph/start/initial_surface.hpp"
#include "sph/start/linear_solver.hpp"
#include "sph/terms/density_diffusion.hpp"
#include "sph/terms/equation_of_state.hpp"
#include "sph/terms/viscosity.hpp"

namespace slosh::sph {

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

}  // namespace slosh::sph
