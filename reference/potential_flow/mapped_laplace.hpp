// Laplace's equation in the liquid between the bottom z = -h, two vertical walls and the surface
// z = eta(x), solved with one spectral element in the boundary-fitted coordinates
//   x,  s = (z + h)/D in [0, 1],  D = h + eta(x).
// The weak form, for every v on the Gauss-Lobatto-Legendre grid of nodes_x times nodes_z nodes, is
//   integral grad Phi . grad v dx dz = integral over the boundary of v dPhi/dn,
//   Phi_x = Phi_x|s - s eta_x/D Phi_s,  Phi_z = Phi_s/D.
// dPhi/dn on the walls and Phi on the surface are given. The form is symmetric, so that its rows on
// the surface give the flux Phi_z - eta_x Phi_x through it as a symmetric operator on the surface
// values. Small waves then neither grow nor decay on any grid, and the volume is conserved.
// The system is solved by conjugate gradients. The preconditioner is the same operator under a flat
// surface, which is diagonal in the products of two sets of one-dimensional eigenvectors (Lynch,
// Rice & Thomas, 1964). The flux converges spectrally where eta and the data are smooth.
#pragma once

#include <Eigen/Core>
#include <stdexcept>
#include <string>

#include "reference/potential_flow/legendre_grid.hpp"

namespace slosh::reference {

// Thrown where the liquid's depth is not positive everywhere or the iteration does not converge.
class NoLaplaceSolution : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class MappedLaplace {
 public:
  MappedLaplace(double length, double depth, int nodes_x, int nodes_z);

  const LegendreGrid& x() const { return x_; }  // [-length/2, length/2]
  const LegendreGrid& s() const { return s_; }  // [0, 1]

  // Sets the surface's elevation at the x nodes [m] for the calls that follow. Throws
  // NoLaplaceSolution unless the surface lies above the bottom everywhere.
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
  // `guess` is an initial guess, zeros or the solution of a similar problem. Throws
  // NoLaplaceSolution where 200 iterations do not bring the error, in the norm of the kinetic
  // energy, below 1e-11 of the solution; 4 to 8 iterations are usual.
  Solution solve(const Eigen::VectorXd& surface_values, const WallData& walls,
                 Eigen::MatrixXd guess) const;

  struct Gradient {
    Eigen::MatrixXd x, z;  // [nodes_x x nodes_z]
  };
  Gradient gradient(const Eigen::MatrixXd& potential) const;
  // Integrates values at the nodes over the liquid.
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
