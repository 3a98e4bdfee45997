// Fully nonlinear potential flow in a rectangular tank that surges and rolls by any amount. The
// equations of free_surface_flow.hpp are integrated in time by an explicit Runge-Kutta-Fehlberg
// method of eighth order, whose step size keeps the error of each step below 1e-11 of the tank's
// length. The solution is valid for an inviscid liquid whose surface neither breaks nor reaches the
// roof, and while the grid resolves it. The run checks these conditions and ends where one fails.
//
// Accuracy in Li's tank (nonlinear_convergence_test.cpp): a standing wave of 20 mm has converged to
// 2e-11 m with 24 nodes along x. A wave with smooth forcing has converged to 6e-10 m with 48 nodes
// and to 3e-11 m with 64, but only to 2e-9 m on the wall itself: at a wall that accelerates the
// surface has a slope and its curvature is singular, so that a cosine series would gain only two
// orders there. 20 s of the paper's case take 6 s of processor time with 48 nodes and 15 s with 64,
// and differ from linear theory by 2.5 % rms.
//
// Starts. "earth": the liquid is at rest in the earth's frame and the walls move off at once. This
// excites every mode of the tank, also modes so short that no grid resolves them. The excitation of
// the n-th mode, cos n pi (x/length + 1/2), is therefore multiplied by exp(-36 (5n/2nodes_x)^8): it
// is complete up to nodes_x/5 and zero above nodes_x/2.5. "tank": the potential flow whose surface
// keeps its shape in the tank, eta_t = 0. In a roll the liquid below the surface then moves
// relative to the tank, as no potential flow is at rest in a tank that turns. The surface starts
// horizontal or as `initial_elevation` gives it.
//
// An acceleration a at 0 s excites the n-th mode as n^-2. The short waves that no grid resolves are
// then part of the solution, and `unresolved` may exceed its limit by 8 a length/(g nodes_x^2 A)
// (nonlinear_range_test.cpp). Measured in a tank of 1.73 m with a = 0.076 g, over 6 s: 48 nodes
// differ from 96 by 3e-4 rms of the wave at 0.05 m from the wall and by 5e-4 on it, 64 by 2e-4 and
// 3e-4. The surface then steepens, and 48 and 64 nodes no longer resolve it after 9.0 s, 96 after
// 14.4 s.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "reference/potential_flow/tank_motion.hpp"
#include "reference/tank.hpp"

namespace slosh::reference {

struct NonlinearSloshing {
  Tank tank;
  double roof = std::numeric_limits<double>::infinity();  // [m] above the still surface
  TankMotion motion = {};
  Start start = Start::earth;
  // eta(x, 0) [m]; empty for the horizontal surface -x tan(theta(0)).
  std::function<double(double)> initial_elevation = {};
  int nodes_x = 64, nodes_z = 24;
};

struct Observation {
  std::vector<double> times;        // [s], rising, from 0 on
  std::vector<double> gauges = {};  // x [m] from the tank's centre
  // A place fixed in the tank, for pressure and velocity. Above the surface the pressure is that of
  // the gas, 0, and the velocity is given as 0.
  struct Place {
    double x, z;  // [m] from the tank's centre and from the still surface
  };
  std::vector<Place> places = {};
};

// Series at the observation's times up to `valid_until`.
struct NonlinearRecord {
  std::vector<double> times;                   // [s]
  std::vector<std::vector<double>> elevation;  // [gauge][time], m, normal to the still surface
  std::vector<std::vector<double>> pressure;   // [place][time], Pa above the gas's
  std::vector<std::vector<double>> velocity_x, velocity_z;  // [place][time], m/s, in the tank
  std::vector<WallLoad> load;                               // [time]
  // Measures of the numerical error, [time]: the drift of the mean level [m]; the change of the
  // energy less the walls' work, relative to the energy g length A^2/2 of the highest wave so far;
  // and the largest of the last quarter of the surface's Legendre coefficients, relative to that
  // wave's height A. A is taken as length/1000 at least.
  std::vector<double> volume_error, energy_error, unresolved;
  double valid_until = 0;          // [s]
  std::string left_range_because;  // empty where the run reached its end
};

// The record ends before the last time where the surface is steeper than 2 (63 degrees), reaches
// the roof or comes within 2 % of the fill depth of the bottom; where `unresolved` exceeds 1e-3
// (after an acceleration at 0 s more, see above), the volume error 1e-8 of the depth or the energy
// error 1e-4; and where Laplace's equation or the time step does not converge. Throws
// std::invalid_argument for an impossible tank, grid, motion, initial elevation, time or place,
// also where the motion is not finite at a later time.
NonlinearRecord run_nonlinear_potential_flow(const NonlinearSloshing& sloshing,
                                             const Observation& observation);

}  // namespace slosh::reference
