// The tank's motion as DualSPHysics's AccInput takes it: a table of accelerations that the solver
// adds to gravity, of which it integrates velocities.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// A row of the table. x points to the right, z up and y away from the viewer, so that an angular
// acceleration about y turns clockwise.
struct AccInputRow {
  double time;       // [s]
  double x, z;       // [m/s2], added to gravity
  double angular_y;  // [rad/s2]
};

// Returns the rows; none for a tank that stands still.
//
// With the angular acceleration a_y of the row, and the velocities V and W that it sums of the
// rows (V_k = V_(k-1) + x_k (t_k - t_(k-1)), both 0 in the first one), DualSPHysics 5 adds at the
// place (x, z) from the centre and the velocity (u, w), by JDsAccInput::RunCpu,
//     x + a_y z - W^2 x + 2 W w   and   z - a_y x - W^2 z - 2 W (u - V).
// In the tank's frame these are, but for two terms, what motion_table.hpp says for a_y = theta''
// and W = theta': the rows take the uniform 2 W V off again, and begin before 0 so that W starts at
// theta'(0). The centrifugal term has the wrong sign in DualSPHysics and stays so
// (DualSPHysics#296).
std::vector<AccInputRow> acc_input(const CaseDefinition& definition);

// Returns the file: a remark, then rows "time;linx;liny;linz;angx;angy;angz".
std::string acc_input_file(const std::vector<AccInputRow>& rows);

// Returns the largest error that the centrifugal term's sign leaves anywhere in the tank [m/s2].
double largest_centrifugal_error(const CaseDefinition& definition);

}  // namespace slosh
