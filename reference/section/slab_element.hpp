// Laplace's equation in one slab of the liquid by one spectral element, reduced to the values on
// the slab's top. With xi in [-1, 1] across the width, x = m(z) + w(z) xi and s = m' + w' xi,
//   integral |grad phi|^2 dx dz
//     = integral phi_xi^2 (1 + s^2)/w - 2 s phi_xi phi_z + w phi_z^2  dxi dz,
// where phi_z is taken at constant xi. As s does not depend on z, the matrix is a sum of four
// Kronecker products of matrices in z and in xi. The values below the top are eliminated, together
// with what the slabs below have left on the bottom (a Schur complement). No condition is set on
// the walls, so that the normal velocity there is that of the load: zero for the modes, and
//   integral grad v . (-(z - z0), x - x0) dx dz
// for a tank that turns about (x0, z0), as the integral of v n . (-(z - z0), x - x0) along the
// whole boundary is that over the area.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "reference/section/piecewise_grid.hpp"
#include "reference/section/slabs.hpp"

namespace slosh::reference {

// What the liquid below a level is for the liquid above: an energy, half of
//   u . stiffness u - 2 u . load - energy, of the values u at the level.
struct Condensed {
  Eigen::MatrixXd stiffness;  // [across x across]
  Eigen::VectorXd load;       // of the turning tank, [across]
  double energy;              // of the load with values zero at the level
};

class SlabElement {
 public:
  // `below` is what the slabs below have left, none for the lowest.
  SlabElement(const Slab& slab, const PiecewiseGrid& across, int degree, const Corner& axis,
              const std::optional<Condensed>& below);

  const Condensed& condensed() const { return condensed_; }

  // Sets the potentials of which `top` holds the values at the top, [across x potentials]. The last
  // has the turning tank's load, and the others have none. Returns the values at the bottom. It is
  // called once.
  Eigen::MatrixXd set_potentials(const Eigen::MatrixXd& top);

  // Every potential and its gradient at (z, xi), [potentials].
  struct Values {
    Eigen::VectorXd potential, x_slope, z_slope;
  };
  Values at(const PiecewiseGrid& across, double z, double xi) const;

 private:
  Slab slab_;
  PiecewiseGrid up_;
  Condensed condensed_;
  Eigen::MatrixXd from_top_;    // maps values at the top to those at the nodes below
  Eigen::VectorXd from_load_;   // the values at these nodes by the load alone
  Eigen::MatrixXd potentials_;  // [nodes x potentials]; the nodes of a height are contiguous
};

}  // namespace slosh::reference
