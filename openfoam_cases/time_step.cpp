#include "openfoam_cases/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "openfoam_cases/geometry/layers.hpp"

namespace slosh::openfoam {

// The first-order errors in time of Euler's method and of the acceleration source damp and shift
// the first natural mode by about omega_1 dt. With omega_1 dt = 0.01 (2 ms in the tank of 1 m
// filled to 0.35 m) the error of that mode's frequency is 0.02 % at 50 x 50 cells; half the step
// changes its decay rate from 0.0067 to 0.0053 1/s. For a tank with an initial wave, the mode of
// that wave sets the step.
double max_time_step(const SloshingTank& tank) {
  const int mode = tank.initial_wave ? tank.initial_wave->mode : 1;
  const double wave_number = mode * std::numbers::pi / tank.length;
  const double omega =
      std::sqrt(tank.gravity * wave_number * std::tanh(wave_number * tank.fill_depth));
  return 0.01 / omega;
}

// The initial flux is zero (0/phi), which is wrong where a roll starts suddenly: the surface would
// not move during the first step, which is therefore short. Each further step is longer by a fifth.
double first_time_step(const SloshingTank& tank) {
  const bool set_off = tank.roll && tank.roll->initial_relative_rate != 0;
  return set_off ? max_time_step(tank) / 100 : max_time_step(tank);
}

// With 2000 intervals the spline's error stays below that of the time step where samples are far
// apart.
double motion_step(const SloshingTank& tank) {
  return std::min(tank.sample_interval, tank.duration / 2000);
}

// There is no momentum predictor, because its first-order error damps the waves (14 % more at a
// Reynolds number of 50). Each correction therefore takes the viscous stress of a cell's neighbours
// from the correction before, and reduces the error by the factor d / (1 + d),
// d = 2 nu dt (1/dx^2 + 1/dy^2 + 1/dz^2), without the y in two dimensions. The number of
// corrections leaves at most 0.2 % of the error, which changes the frequency by 0.1 %. In a wave of
// Re = 50 at 50 x 75 cells (d = 0.96) the errors of frequency and damping are -12.6 % and -23 %
// with two corrections, -0.7 % and -1.4 % with six, and -0.03 % and +0.05 % with ten. For water two
// corrections are enough.
int pressure_corrections(const SloshingTank& tank) {
  constexpr int fewest = 2;
  constexpr double left = 0.002;
  const double width = tank.length / tank.cells_x, height = tank.height / tank.cells_z;
  double squares = 0;  // 1/dx^2 + 1/dy^2 + 1/dz^2 [1/m2]
  if (tank.gap) {
    // Where two walls meet the liquid hardly moves, so that the cells beside one wall count.
    const double at_wall = std::min({width, height, Layers(tank).at_wall(),
                                     tank.wall_cell.value_or(std::numeric_limits<double>::max())});
    squares = 1 / (at_wall * at_wall) + 1 / (width * width) + 1 / (height * height);
  } else {
    // Graded cells are smallest in the tank's corners.
    const double per_length = tank.wall_cell ? 1 / *tank.wall_cell : tank.cells_x / tank.length,
                 per_height = tank.wall_cell ? 1 / *tank.wall_cell : tank.cells_z / tank.height;
    squares = per_length * per_length + per_height * per_height;
  }
  const double diffusion = 2 * tank.liquid.kinematic_viscosity * max_time_step(tank) * squares;
  if (!(diffusion > 0)) return fewest;
  return std::max(
      fewest, static_cast<int>(std::ceil(std::log(left) / std::log(diffusion / (1 + diffusion)))));
}

}  // namespace slosh::openfoam
