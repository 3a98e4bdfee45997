// The layers of cells between the gap walls. In two dimensions there is one, 1 m
// thick, so that every integral is one per metre of breadth.
//
// In three dimensions they fill half of a narrow tank's gap b: from y = 0, at a wall to which the
// liquid sticks, to y = b / 2, a plane of symmetry. Each is thicker than the one before by the
// ratio r, so that the layer at the wall is
//
//     w = (b / 2) (r - 1) / (r^n - 1).
//
// Without a given w the last layer is seven times as thick as the first. In laminar flow that
// oscillates as exp(i omega t) in such layers, of which the equation in y is solved as the solver
// does, the force of the wall in phase with the velocity is that of gap_friction.hpp to:
//
//     layers                                        4       6       8      12      16
//     delta / b = 0.17                            -3 %    -1 %    -1 %   -0.2 %  -0.1 %
//     delta / b = 0.08 (oil of 5e-5 m2/s in a
//       gap of 62 mm at 4 rad/s)                  -2 %   -0.2 %    0 %    0.1 %   0.1 %
//     delta / b = 0.025                            5 %     9 %     8 %      5 %     3 %
//
// with the Stokes layer delta = sqrt(2 nu / omega). The part out of phase, an added mass, is 11 %,
// 4 % and 1 % too small in 4, 8 and 16 layers at delta / b = 0.08.
#pragma once

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// Throws std::invalid_argument for a gap without breadth or with fewer than four layers, and for
// layers beside the wall so thin that r would exceed 2.
void check_layers(const SloshingTank& tank);

class Layers {
 public:
  // A wall_cell that is thicker than layers of one thickness gives these. With one that is too thin
  // r is 2.
  explicit Layers(const SloshingTank& tank);

  bool is_half_gap() const { return is_half_gap_; }
  int count() const { return count_; }
  double depth() const { return depth_; }  // [m], of all layers together
  double at_wall() const;                  // [m], the thickness of the first layer
  double share(int layer) const;           // of the depth
  double expansion() const;                // thickness of the last over that of the first
  // y [m] of the centres of the last layer, the one next to the plane of symmetry, in which
  // sensors, probes and fields of results are.
  double measured_y() const;

 private:
  bool is_half_gap_ = false;
  int count_ = 1;
  double depth_ = 1;
  double ratio_ = 1;  // r
};

}  // namespace slosh::openfoam
