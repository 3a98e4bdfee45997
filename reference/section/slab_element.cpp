#include "reference/section/slab_element.hpp"

#include <algorithm>

#include "reference/potential_flow/decompositions.hpp"

namespace slosh::reference {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Adds the Kronecker product of a matrix in z and one across.
void add_product(const MatrixXd& up, const MatrixXd& across, MatrixXd& sum) {
  const Index n = across.rows();
  for (Index i = 0; i < up.rows(); ++i) {
    for (Index j = 0; j < up.cols(); ++j) sum.block(i * n, j * n, n, n) += up(i, j) * across;
  }
}

MatrixXd stiffness(const Slab& slab, const PiecewiseGrid& across, const PiecewiseGrid& up) {
  const VectorXd half_width = up.points.unaryExpr([&](double z) { return slab.half_width(z); });
  const VectorXd slope =
      (slab.middle_slope() + slab.half_width_slope() * across.points.array()).matrix();
  const VectorXd weights = across.weights, steep = (1 + slope.array().square()).matrix();
  const MatrixXd &v = across.values, &d = across.slopes, &p = up.values, &q = up.slopes;
  const auto of_heights = [&](const VectorXd& factor) {
    return VectorXd(up.weights.cwiseProduct(factor));
  };
  const MatrixXd mixed_up = transposed_product(p, up.weights.asDiagonal() * q),
                 mixed = -transposed_product(d, weights.cwiseProduct(slope).asDiagonal() * v);
  MatrixXd sum = MatrixXd::Zero(up.size() * across.size(), up.size() * across.size());
  add_product(transposed_product(p, of_heights(half_width.cwiseInverse()).asDiagonal() * p),
              transposed_product(d, weights.cwiseProduct(steep).asDiagonal() * d), sum);
  add_product(mixed_up, mixed, sum);
  add_product(mixed_up.transpose(), mixed.transpose(), sum);
  add_product(transposed_product(q, of_heights(half_width).asDiagonal() * q),
              transposed_product(v, weights.asDiagonal() * v), sum);
  return sum;
}

// With v_x = v_xi/w and v_z = v_z|xi - s v_xi/w.
VectorXd turning_load(const Slab& slab, const PiecewiseGrid& across, const PiecewiseGrid& up,
                      const Corner& axis) {
  const Eigen::ArrayXd xi = across.points.array();
  const Eigen::ArrayXd slope = slab.middle_slope() + slab.half_width_slope() * xi;
  VectorXd load = VectorXd::Zero(up.size() * across.size());
  for (Index r = 0; r < up.points.size(); ++r) {
    const double z = up.points[r], w = slab.half_width(z);
    const Eigen::ArrayXd x = slab.middle(z) - axis.x + w * xi;
    const VectorXd level = up.weights[r] * across.slopes.transpose() *
                           (across.weights.array() * (-(z - axis.z) - slope * x)).matrix();
    const VectorXd change =
        up.weights[r] * w * across.values.transpose() * (across.weights.array() * x).matrix();
    for (Index i = 0; i < up.size(); ++i) {
      load.segment(i * across.size(), across.size()) +=
          up.values(r, i) * level + up.slopes(r, i) * change;
    }
  }
  return load;
}

// At a pointed bottom all nodes are one, which is the first of the values that are returned.
void join_bottom(Index across, MatrixXd& stiffness, VectorXd& load) {
  const Index rest = stiffness.rows() - across;
  MatrixXd rows(rest + 1, stiffness.cols());
  rows << stiffness.topRows(across).colwise().sum(), stiffness.bottomRows(rest);
  MatrixXd joined(rest + 1, rest + 1);
  joined << rows.leftCols(across).rowwise().sum(), rows.rightCols(rest);
  stiffness = joined;
  VectorXd joined_load(rest + 1);
  joined_load << load.head(across).sum(), load.tail(rest);
  load = joined_load;
}

}  // namespace

SlabElement::SlabElement(const Slab& slab, const PiecewiseGrid& across, int degree,
                         const Corner& axis, const std::optional<Condensed>& below)
    : slab_(slab), up_({slab.bottom, slab.top}, {degree}) {
  const Index n = across.size();
  MatrixXd matrix = stiffness(slab, across, up_);
  VectorXd load = turning_load(slab, across, up_, axis);
  if (below) {
    matrix.topLeftCorner(n, n) += below->stiffness;
    load.head(n) += below->load;
  }
  if (slab.pointed()) join_bottom(n, matrix, load);

  const Index inner = matrix.rows() - n;
  MatrixXd right(inner, n + 1);
  right << matrix.topRightCorner(inner, n), load.head(inner);
  const MatrixXd solved = solve_positive(matrix.topLeftCorner(inner, inner), right);
  MatrixXd from_top = -solved.leftCols(n);
  VectorXd from_load = solved.col(n);
  const MatrixXd schur =
      matrix.bottomRightCorner(n, n) + product(matrix.bottomLeftCorner(n, inner), from_top);
  condensed_ = {.stiffness = (schur + schur.transpose()) / 2,
                .load = load.tail(n) + from_top.transpose() * load.head(inner),
                .energy = load.head(inner).dot(from_load) + (below ? below->energy : 0)};
  if (slab.pointed()) {
    from_top_.resize(inner - 1 + n, n);
    from_top_ << from_top.row(0).replicate(n, 1), from_top.bottomRows(inner - 1);
    from_load_.resize(inner - 1 + n);
    from_load_ << VectorXd::Constant(n, from_load[0]), from_load.tail(inner - 1);
  } else {
    from_top_ = std::move(from_top);
    from_load_ = std::move(from_load);
  }
}

MatrixXd SlabElement::set_potentials(const MatrixXd& top) {
  potentials_.resize(from_top_.rows() + top.rows(), top.cols());
  potentials_ << product(from_top_, top), top;
  potentials_.col(top.cols() - 1).head(from_load_.size()) += from_load_;
  from_top_.resize(0, 0);
  return potentials_.topRows(top.rows());
}

SlabElement::Values SlabElement::at(const PiecewiseGrid& across, double z, double xi) const {
  // In the tip of a triangle the gradient is that just above it.
  if (slab_.pointed()) z = std::max(z, slab_.bottom + 1e-6 * (slab_.top - slab_.bottom));
  const auto [up, up_slope] = up_.at(z);
  const auto [along, along_slope] = across.at(xi);
  const Index n = across.size();
  Eigen::RowVectorXd value(potentials_.rows()), by_xi(value.size()), by_z(value.size());
  for (Index i = 0; i < up_.size(); ++i) {
    value.segment(i * n, n) = up[i] * along;
    by_xi.segment(i * n, n) = up[i] * along_slope;
    by_z.segment(i * n, n) = up_slope[i] * along;
  }
  const double w = slab_.half_width(z), s = slab_.middle_slope() + slab_.half_width_slope() * xi;
  return {(value * potentials_).transpose(), (by_xi * potentials_ / w).transpose(),
          ((by_z - s / w * by_xi) * potentials_).transpose()};
}

}  // namespace slosh::reference
