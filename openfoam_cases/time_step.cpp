#include "openfoam_cases/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slosh::openfoam {

// Euler's and the source's first-order error in time damps and shifts the first natural mode by
// about omega_1 dt. At a hundredth (2 ms in the 1 m tank filled to 0.35 m) that mode's frequency is
// right to 0.02 % at 50 x 50 cells; half the step changes its decay from 0.0067 to 0.0053 1/s. A
// tank with an initial wave is asked for that mode.
double max_time_step(const SloshingTank& tank) {
  const int mode = tank.initial_wave ? tank.initial_wave->mode : 1;
  const double wave_number = mode * std::numbers::pi / tank.length;
  const double omega =
      std::sqrt(tank.gravity * wave_number * std::tanh(wave_number * tank.fill_depth));
  return 0.01 / omega;
}

// The first step's flux is given as zero (0/phi), which is wrong where a roll starts at once: the
// surface would stand still for that step, so it is a short one. The steps then grow by a fifth.
double first_time_step(const SloshingTank& tank) {
  const bool set_off = tank.roll && tank.roll->initial_relative_rate != 0;
  return set_off ? max_time_step(tank) / 100 : max_time_step(tank);
}

// Without a momentum predictor, whose first-order error damps the waves (14 % more at a Reynolds
// number of 50), a correction takes the viscous stress of a cell's neighbours from the one before:
// what is left of the error shrinks by d / (1 + d), d = 2 nu dt (1/dx^2 + 1/dz^2). Left are at most
// 0.2 %, which moves the frequency by 0.1 %: in the wave of Re = 50 at 50 x 75 cells (d = 0.96) two
// corrections give -12.6 % in frequency and -23 % in damping, six -0.7 and -1.4 %, ten -0.03 and
// +0.05 %. Of water two are enough.
int pressure_corrections(const SloshingTank& tank) {
  constexpr int fewest = 2;
  constexpr double left = 0.002;
  const double per_length = tank.cells_x / tank.length, per_height = tank.cells_z / tank.height;
  const double diffusion = 2 * tank.liquid.kinematic_viscosity * max_time_step(tank) *
                           (per_length * per_length + per_height * per_height);
  if (!(diffusion > 0)) return fewest;
  return std::max(
      fewest, static_cast<int>(std::ceil(std::log(left) / std::log(diffusion / (1 + diffusion)))));
}

}  // namespace slosh::openfoam
