#include "reference/section/piecewise_grid.hpp"

#include <cmath>

#include "reference/potential_flow/decompositions.hpp"

namespace slosh::reference {
namespace {

// The points and weights of Gauss's quadrature on [-1, 1] are the eigenvalues and, from the
// eigenvectors' first components, the weights of the Legendre polynomials' recurrence (Golub &
// Welsch, 1969).
struct Gauss {
  Eigen::VectorXd points, weights;

  explicit Gauss(int count) {
    Eigen::VectorXd off_diagonal(count - 1);
    for (int k = 1; k < count; ++k) off_diagonal[k - 1] = k / std::sqrt(4.0 * k * k - 1);
    const Eigenpairs pairs = tridiagonal_eigenpairs(off_diagonal);
    points = pairs.values;
    weights = 2 * pairs.vectors.row(0).transpose().array().square();
  }
};

}  // namespace

PiecewiseGrid::PiecewiseGrid(const std::vector<double>& breaks, const std::vector<int>& degrees) {
  std::vector<double> places, shares;
  for (std::size_t e = 0; e < degrees.size(); ++e) {
    pieces_.emplace_back(breaks[e], breaks[e + 1], degrees[e] + 1);
    size_ += degrees[e];
    const Gauss gauss(degrees[e] + 2);
    const double half = (breaks[e + 1] - breaks[e]) / 2;
    for (Eigen::Index i = 0; i < gauss.points.size(); ++i) {
      places.push_back(breaks[e] + half * (1 + gauss.points[i]));
      shares.push_back(half * gauss.weights[i]);
    }
  }
  nodes.resize(size_);
  Eigen::Index first = 0;
  for (const LegendreGrid& piece : pieces_) {
    nodes.segment(first, piece.nodes.size()) = piece.nodes;
    first += piece.nodes.size() - 1;
  }
  const auto count = static_cast<Eigen::Index>(places.size());
  points = Eigen::Map<Eigen::VectorXd>(places.data(), count);
  weights = Eigen::Map<Eigen::VectorXd>(shares.data(), count);
  values.resize(count, size_);
  slopes.resize(count, size_);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Rows rows = at(points[i]);
    values.row(i) = rows.value;
    slopes.row(i) = rows.slope;
  }
}

PiecewiseGrid::Rows PiecewiseGrid::at(double place) const {
  std::size_t e = 0;
  Eigen::Index first = 0;
  while (e + 1 < pieces_.size() && place > pieces_[e].nodes[pieces_[e].nodes.size() - 1]) {
    first += pieces_[e].nodes.size() - 1;
    ++e;
  }
  Rows rows{Eigen::RowVectorXd::Zero(size_), Eigen::RowVectorXd::Zero(size_)};
  const Eigen::RowVectorXd value = pieces_[e].interpolation(place);
  rows.value.segment(first, value.size()) = value;
  rows.slope.segment(first, value.size()) = value * pieces_[e].derivative;
  return rows;
}

}  // namespace slosh::reference
