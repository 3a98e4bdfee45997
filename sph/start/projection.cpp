#include "sph/start/projection.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>

#include "sph/liquid.hpp"
#include "sph/run_output.hpp"
#include "sph/start/held_tank.hpp"
#include "sph/start/initial_surface.hpp"
#include "sph/start/linear_solver.hpp"

namespace slosh::sph {
namespace {

class Projection {
 public:
  Projection(const Scene& scene, const Method& method, const Particles& start)
      : scene_(tank_.scene(scene)),
        surface_(scene),
        weightless_(scene_, operators(method, 0), start),
        heavy_(scene_, operators(method, scene.gravity), start) {
    set_density(weightless_.particles, [&](std::size_t) { return rest_density(); });
    set_density(heavy_.particles, [&](std::size_t i) {
      return heavy_.terms().density(hydrostatic_pressure(heavy_.particles, i));
    });
  }

  // `terms` are those of the run, with its equation of state.
  Particles state(double wall_velocity, double wall_acceleration, const SchemeTerms& terms) {
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
      return terms.density(hydrostatic_pressure(result, i) +
                           unit_pressure() * pressure[static_cast<long>(i)]);
    });
    return result;
  }

 private:
  // The density is the rest density times (1 + small_compression times an unknown), so that the
  // operators are linear in the unknown to 1e-6.
  static constexpr double small_compression = 1e-6;
  static constexpr double tolerance = 1e-3;  // of the divergence, relative to its initial value
  static constexpr int most_iterations = 2000;

  static Method operators(Method method, double gravity) {
    method.terms = method.terms->pressure_alone(gravity);
    return method;
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

  double rest_density() const { return weightless_.setting().rest_density; }

  double unit_pressure() const {
    const Setting& s = weightless_.setting();
    return small_compression * s.rest_density * s.speed_of_sound * s.speed_of_sound;
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
  Liquid weightless_, heavy_;
};

}  // namespace

Particles projected(const Scene& scene, const Method& method, const Particles& start) {
  return Projection(scene, method, start)
      .state(scene.velocity(0), scene.acceleration(0), *method.terms);
}

}  // namespace slosh::sph
