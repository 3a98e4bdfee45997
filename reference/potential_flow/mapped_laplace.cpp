#include "reference/potential_flow/mapped_laplace.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reference/potential_flow/decompositions.hpp"

namespace slosh::reference {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr int most_iterations = 200;
constexpr double tolerance = 1e-11;

}  // namespace

MappedLaplace::MappedLaplace(double length, double depth, int nodes_x, int nodes_z)
    : depth_(depth), x_(-length / 2, length / 2, nodes_x), s_(0, 1, nodes_z) {
  const auto stiffness_of = [](const LegendreGrid& grid) -> MatrixXd {
    return grid.derivative.transpose() * grid.weights.asDiagonal() * grid.derivative;
  };
  const auto inner = nodes_z - 1;  // without the surface, whose values are given
  const Eigenpairs along = generalized_eigenpairs(stiffness_of(x_), x_.weights.asDiagonal());
  const Eigenpairs up = generalized_eigenpairs(stiffness_of(s_).topLeftCorner(inner, inner),
                                               s_.weights.head(inner).asDiagonal());
  modes_x_ = along.vectors;
  modes_s_ = up.vectors;
  inverse_stiffness_ = (depth * along.values.replicate(1, inner) +
                        up.values.transpose().replicate(nodes_x, 1) / depth)
                           .array()
                           .inverse();
  set_surface(VectorXd::Zero(nodes_x));
}

void MappedLaplace::set_surface(const VectorXd& elevation) {
  column_ = elevation.array() + depth_;
  if (!(column_.minCoeff() > 0)) {
    throw NoLaplaceSolution(fmt::format("the depth falls to {:.3g} m", column_.minCoeff()));
  }
  slope_ = x_.derivative * elevation;
}

MatrixXd MappedLaplace::heights() const {
  return (column_ * s_.nodes.transpose()).array() - depth_;
}

MappedLaplace::Gradient MappedLaplace::gradient(const MatrixXd& potential) const {
  Gradient gradient;
  gradient.z.noalias() = potential * s_.derivative.transpose();
  gradient.z.array().colwise() /= column_.array();
  gradient.x.noalias() = x_.derivative * potential;
  gradient.x.array() -= (slope_ * s_.nodes.transpose()).array() * gradient.z.array();
  return gradient;
}

double MappedLaplace::integral(const MatrixXd& values) const {
  return x_.weights.cwiseProduct(column_).dot(values * s_.weights);
}

MatrixXd MappedLaplace::stiffness(const MatrixXd& potential) const {
  auto [u, w] = gradient(potential);
  const MatrixXd weights = x_.weights * s_.weights.transpose();
  w.array() -= (slope_ * s_.nodes.transpose()).array() * u.array();
  w.array() *= weights.array();
  u.array() *= weights.array().colwise() * column_.array();
  MatrixXd result(potential.rows(), potential.cols());
  result.noalias() = x_.derivative.transpose() * u;
  result.noalias() += w * s_.derivative;
  return result;
}

MatrixXd MappedLaplace::flat_inverse(const MatrixXd& residual) const {
  MatrixXd modal = modes_x_.transpose() * residual * modes_s_;
  modal.array() *= inverse_stiffness_;
  return modes_x_ * modal * modes_s_.transpose();
}

MappedLaplace::Solution MappedLaplace::solve(const VectorXd& surface_values, const WallData& walls,
                                             MatrixXd potential) const {
  const auto rows = potential.rows(), inner = potential.cols() - 1;
  MatrixXd load = MatrixXd::Zero(rows, inner + 1);
  load.row(0) -= column_[0] * s_.weights.cwiseProduct(walls.left).transpose();
  load.row(rows - 1) += column_[rows - 1] * s_.weights.cwiseProduct(walls.right).transpose();
  load.col(0) -= x_.weights.cwiseProduct(walls.bottom);

  potential.col(inner) = surface_values;
  MatrixXd reaction = stiffness(potential) - load;
  MatrixXd residual = -reaction.leftCols(inner);
  MatrixXd search = MatrixXd::Zero(rows, inner + 1);
  double before = 1;
  for (int iteration = 0;; ++iteration) {
    const MatrixXd improvement = flat_inverse(residual);
    const double error = improvement.cwiseProduct(residual).sum();
    // Twice the kinetic energy, with the largest contribution of the walls' and surface's data.
    const double scale = std::abs((reaction + load).cwiseProduct(potential).sum()) + 1e-30;
    if (error <= tolerance * tolerance * scale) break;
    if (!std::isfinite(error))
      throw NoLaplaceSolution("Laplace's equation has data that are not finite");
    if (iteration == most_iterations) {
      throw NoLaplaceSolution(fmt::format(
          "Laplace's equation is not solved after {} iterations (relative error {:.1e})", iteration,
          std::sqrt(error / scale)));
    }
    search.leftCols(inner) = (improvement + (error / before) * search.leftCols(inner)).eval();
    before = error;
    const MatrixXd response = stiffness(search);
    const double step = error / search.cwiseProduct(response).sum();
    potential += step * search;
    reaction += step * response;
    residual -= step * response.leftCols(inner);
  }
  return {potential, reaction.col(inner).cwiseQuotient(x_.weights)};
}

}  // namespace slosh::reference
