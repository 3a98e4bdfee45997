// Laplace's equation in the liquid between the bottom z = -h, two vertical walls and the surface
// z = eta(x), by one spectral element on the boundary-fitted coordinates
//   x,  s = (z + h)/D in [0, 1],  D = h + eta(x).
// The weak form, for every v on the Gauss-Lobatto-Legendre grid (nodes_x times nodes_z),
//   integral grad Phi . grad v dx dz = integral over the boundary of v dPhi/dn,
//   Phi_x = Phi_x|s - s eta_x/D Phi_s,  Phi_z = Phi_s/D,
// takes the walls' dPhi/dn as given, and the surface's values. It is symmetric, so that its
// rows on the surface give the flux Phi_z - eta_x Phi_x through it as a symmetric operator on those
// values: small waves on any grid neither grow nor decay, and no flux is lost from the volume.
// Solved by conjugate gradients, preconditioned with the same operator under a flat surface, which
// is diagonal in the products of two sets of one-dimensional eigenvectors (Lynch, Rice & Thomas,
// 1964). The flux converges spectrally where eta and the data are smooth.
#pragma once

#include <Eigen/Dense>
#include <stdexcept>
#include <string>

#include "reference/legendre_grid.hpp"

namespace slosh::reference {

// The equation has no solution to the accuracy asked for: the liquid's depth is not positive
// everywhere, or the iteration did not converge.
class NoLaplaceSolution : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class MappedLaplace {
 public:
  MappedLaplace(double length, double depth, int nodes_x, int nodes_z);

  const LegendreGrid& x() const { return x_; }  // [-length/2, length/2]
  const LegendreGrid& s() const { return s_; }  // [0, 1]

  // The surface's elevation at the x nodes [m], kept until the next. Throws NoLaplaceSolution
  // unless it lies above the bottom everywhere.
  void set_surface(const Eigen::VectorXd& elevation);
  const Eigen::VectorXd& column() const { return column_; }  // D [m] at the x nodes
  const Eigen::VectorXd& slope() const { return slope_; }    // eta_x there
  Eigen::MatrixXd heights() const;                           // z [m], [nodes_x x nodes_z]

  // Phi_x on the walls, at the s nodes, and Phi_z on the bottom, at the x nodes [m/s].
  struct WallData {
    Eigen::VectorXd left, right, bottom;
  };

  struct Solution {
    Eigen::MatrixXd potential;     // [nodes_x x nodes_z], last column on the surface [m2/s]
    Eigen::VectorXd surface_flux;  // Phi_z - eta_x Phi_x at the x nodes [m/s]
  };
  // `guess` is a field to start from, zeros or a neighbouring solution. Throws NoLaplaceSolution
  // when 200 iterations do not bring the error, in the norm of the kinetic energy, below 1e-11 of
  // the solution; 4 to 8 are usual.
  Solution solve(const Eigen::VectorXd& surface_values, const WallData& walls,
                 Eigen::MatrixXd guess) const;

  struct Gradient {
    Eigen::MatrixXd x, z;  // [nodes_x x nodes_z]
  };
  Gradient gradient(const Eigen::MatrixXd& potential) const;
  // Over the liquid, of values at the nodes.
  double integral(const Eigen::MatrixXd& values) const;

 private:
  Eigen::MatrixXd stiffness(const Eigen::MatrixXd& potential) const;
  Eigen::MatrixXd flat_inverse(const Eigen::MatrixXd& residual) const;

  double depth_;
  LegendreGrid x_, s_;
  Eigen::MatrixXd modes_x_, modes_s_;  // eigenvectors of the flat operator
  Eigen::ArrayXXd inverse_stiffness_;  // of each product of two of them
  Eigen::VectorXd column_, slope_;
};

}  // namespace slosh::reference
