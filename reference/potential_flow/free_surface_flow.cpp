#include "reference/potential_flow/free_surface_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slosh::reference {

using Eigen::ArrayXd, Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

// The residual flux through the surface, relative to that of a liquid at rest in the earth's frame;
// ten times the tolerance of Laplace's equation. A tank that is at rest to rounding has no such
// flux: its share of the speed sqrt(g length) counts then.
constexpr double start_tolerance = 1e-10, least_flux = 1e-14;
constexpr int most_start_iterations = 1000;

// Each returns a component of the tank's velocity, or acceleration, at all points of an array.
ArrayXd along_x(const RigidField& rigid, const ArrayXd& z) {
  return rigid.x - rigid.spin * (z - rigid.axis_z);
}
ArrayXd along_z(const RigidField& rigid, const ArrayXd& x) {
  return rigid.z + rigid.spin * (x - rigid.axis_x);
}

}  // namespace

// The potential at one time and, on the surface, the velocity and the rate of the elevation.
struct FreeSurfaceFlow::Flow {
  TankPlace place;
  MatrixXd potential;
  ArrayXd u, w, elevation_rate;
};

FreeSurfaceFlow::FreeSurfaceFlow(const Tank& tank, const TankMotion& motion, int nodes_x,
                                 int nodes_z)
    : tank_(tank),
      motion_(motion),
      laplace_(tank.length, tank.fill_depth, nodes_x, nodes_z),
      guess_(MatrixXd::Zero(nodes_x, nodes_z)),
      guess_rate_(guess_) {}

MappedLaplace::WallData FreeSurfaceFlow::on_walls(const RigidField& rigid) const {
  const MatrixXd z = laplace_.heights();
  return {along_x(rigid, z.row(0).transpose()), along_x(rigid, z.row(z.rows() - 1).transpose()),
          along_z(rigid, x().nodes)};
}

FreeSurfaceFlow::Flow FreeSurfaceFlow::solve(const State& state, double t) {
  laplace_.set_surface(state.elevation);
  const TankPlace now = place(motion_, t);
  auto [potential, surface_flux] = laplace_.solve(state.potential, on_walls(now.velocity), guess_);
  guess_ = potential;

  const ArrayXd slope = laplace_.slope(), along = x().derivative * state.potential;
  const ArrayXd w = (surface_flux.array() + slope * along) / (1 + slope * slope);
  const ArrayXd tank_flux =
      along_z(now.velocity, x().nodes) - slope * along_x(now.velocity, state.elevation);
  return {now, std::move(potential), along - w * slope, w, surface_flux.array() - tank_flux};
}

// Returns phi_t at the x nodes.
ArrayXd FreeSurfaceFlow::potential_rate(const Flow& flow, const State& state) const {
  const auto& [now, potential, u, w, elevation_rate] = flow;
  const ArrayXd u_tank = along_x(now.velocity, state.elevation);
  const ArrayXd w_tank = along_z(now.velocity, x().nodes);
  const auto height = [&now = now](double x, double z) { return now.height(x, z); };
  const ArrayXd heights = x().nodes.binaryExpr(state.elevation, height);
  return u_tank * u + w_tank * w - (u * u + w * w) / 2 - tank_.gravity * heights +
         w * elevation_rate;
}

FreeSurfaceFlow::Rates FreeSurfaceFlow::rates(const State& state, double t) {
  const Flow flow = solve(state, t);
  const TankPlace& now = flow.place;
  const auto velocity = laplace_.gradient(flow.potential);
  const MatrixXd z = laplace_.heights();
  MatrixXd energy(z.rows(), z.cols()), energy_rate(z.rows(), z.cols());
  for (Index j = 0; j < z.cols(); ++j) {
    for (Index i = 0; i < z.rows(); ++i) {
      const double x_i = x().nodes[i], z_ij = z(i, j);
      const double vx = velocity.x(i, j), vz = velocity.z(i, j);
      energy(i, j) = (vx * vx + vz * vz) / 2 - now.velocity.along_x(z_ij) * vx -
                     now.velocity.along_z(x_i) * vz;
      energy_rate(i, j) = -now.acceleration.along_x(z_ij) * vx - now.acceleration.along_z(x_i) * vz;
    }
  }
  const ArrayXd weights = tank_.gravity * x().weights, eta = state.elevation;
  const double lean = (weights * x().nodes.array() * eta).sum();
  const double rise = (weights * eta * eta).sum() / 2;
  const double cosine = std::cos(now.angle), sine = std::sin(now.angle);
  return {flow.elevation_rate, potential_rate(flow, state),
          laplace_.integral(energy) + lean * sine + rise * cosine,
          laplace_.integral(energy_rate) + now.velocity.spin * (lean * cosine - rise * sine)};
}

// Solves by conjugate gradients: the operator from the surface's values to the flux through it is
// symmetric under the grid's weights.
VectorXd FreeSurfaceFlow::potential_at_rest_in_tank(const VectorXd& elevation, double t) {
  VectorXd potential = VectorXd::Zero(elevation.size());
  ArrayXd residual = -solve({elevation, potential}, t).elevation_rate;
  const auto still = on_walls(RigidField{});
  const MatrixXd no_guess = MatrixXd::Zero(guess_.rows(), guess_.cols());
  const ArrayXd weights = x().weights;
  ArrayXd search = residual;
  double error = (weights * residual * residual).sum();
  const double first = error, length = tank_.length,
               allowed = std::max(start_tolerance * start_tolerance * first,
                                  least_flux * least_flux * tank_.gravity * length * length);
  for (int iteration = 0; error > allowed; ++iteration) {
    if (iteration == most_start_iterations) {
      throw NoLaplaceSolution(fmt::format(
          "no potential flow leaves the surface at rest in the tank (relative flux {:.1e})",
          std::sqrt(error / first)));
    }
    const ArrayXd response = laplace_.solve(search, still, no_guess).surface_flux;
    const double step = error / (weights * search * response).sum();
    potential += (step * search).matrix();
    residual -= step * response;
    const double next = (weights * residual * residual).sum();
    search = residual + next / error * search;
    error = next;
  }
  return potential.array() - x().weights.dot(potential) / length;
}

FreeSurfaceFlow::Pressure FreeSurfaceFlow::pressure(const State& state, double t) {
  const Flow flow = solve(state, t);
  const TankPlace& now = flow.place;
  const VectorXd surface_rate = potential_rate(flow, state) - flow.w * flow.elevation_rate;
  guess_rate_ = laplace_.solve(surface_rate, on_walls(now.acceleration), guess_rate_).potential;

  const auto velocity = laplace_.gradient(flow.potential);
  const MatrixXd z = laplace_.heights();
  Pressure result{MatrixXd(z.rows(), z.cols()), laplace_.column(), velocity, {}};
  for (Index j = 0; j < z.cols(); ++j) {
    for (Index i = 0; i < z.rows(); ++i) {
      const double x_i = x().nodes[i], vx = velocity.x(i, j), vz = velocity.z(i, j);
      result.field(i, j) =
          tank_.density *
          (now.velocity.along_x(z(i, j)) * vx + now.velocity.along_z(x_i) * vz -
           (vx * vx + vz * vz) / 2 - tank_.gravity * now.height(x_i, z(i, j)) - guess_rate_(i, j));
      result.velocity.x(i, j) -= now.velocity.along_x(z(i, j));
      result.velocity.z(i, j) -= now.velocity.along_z(x_i);
    }
  }
  const auto last = z.rows() - 1;
  const ArrayXd left =
      result.column[0] * s().weights.array() * result.field.row(0).transpose().array();
  const ArrayXd right =
      result.column[last] * s().weights.array() * result.field.row(last).transpose().array();
  const ArrayXd bottom = x().weights.array() * result.field.col(0).array();
  const double axis_z = motion_.axis_z;
  result.load.left = -left.sum();
  result.load.right = right.sum();
  result.load.force_x = result.load.left + result.load.right;
  result.load.force_z = -bottom.sum();
  result.load.moment = ((z.row(0).transpose().array() - axis_z) * left).sum() -
                       ((z.row(last).transpose().array() - axis_z) * right).sum() -
                       ((x().nodes.array() - motion_.axis_x) * bottom).sum();
  return result;
}

}  // namespace slosh::reference
