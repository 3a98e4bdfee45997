// Fully nonlinear potential flow in a rectangular tank that surges and rolls at will: the equations
// of free_surface_flow.hpp from a start on, by an explicit Runge-Kutta-Fehlberg method of the
// eighth order whose step keeps the error of a step below 1e-11 of the tank's length.
// Valid for an inviscid liquid whose surface neither breaks nor reaches the roof, and as long as
// the grid resolves it: the run watches all of that and ends where it ceases to hold.
//
// Measured in Li's tank (nonlinear_convergence_test.cpp, nonlinear_order_test.cpp): a standing wave
// of 20 mm is settled to 2e-11 m with 24 nodes along x; a wave forced smoothly to 6e-10 m with 48
// and 3e-11 m with 64, on the wall itself to 2e-9 m, for at a wall that accelerates the surface is
// sloped and its curvature singular: a cosine series would gain only two orders there. 20 s of the
// paper's case take 6 s of processor time with 48 nodes and 15 s with 64, and differ from linear
// theory by 2.5 % in the root of the mean square.
//
// Starts. "earth": the liquid is at rest against the earth and the walls are set off at once, which
// excites every mode of the tank, the short ones by as much as no grid resolves. The n-th mode
// (cos n pi (x/length + 1/2)) is therefore set off by exp(-36 (5n/2nodes_x)^8) of what it would be:
// all of it up to nodes_x/5, nothing above nodes_x/2.5. "tank": the potential flow of which the
// surface keeps its shape in the tank, eta_t = 0; in a roll the liquid below turns over, as no
// potential flow stands still in a tank that turns. The surface is level, or what
// `initial_elevation` says.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "reference/linear_surge.hpp"
#include "reference/tank_motion.hpp"

namespace slosh::reference {

struct NonlinearSloshing {
  Tank tank;
  double roof = std::numeric_limits<double>::infinity();  // [m] above the still surface
  TankMotion motion = {};
  Start start = Start::earth;
  // eta(x, 0) [m]; empty for the level surface -x tan(theta(0)).
  std::function<double(double)> initial_elevation = {};
  int nodes_x = 64, nodes_z = 24;
};

struct Observation {
  std::vector<double> times;        // [s], rising, from 0 on
  std::vector<double> gauges = {};  // x [m] from the tank's centre
  // Fixed in the tank; above the surface the pressure is the gas's, 0.
  struct Place {
    double x, z;  // [m]
  };
  std::vector<Place> pressure_places = {};
};

// Series at those of the observation's times up to `valid_until`.
struct NonlinearRecord {
  std::vector<double> times;                   // [s]
  std::vector<std::vector<double>> elevation;  // [gauge][time], m, normal to the still surface
  std::vector<std::vector<double>> pressure;   // [place][time], Pa above the gas's
  std::vector<WallLoad> load;                  // [time]
  // How far the run can be trusted, [time]: the mean level's drift [m]; the energy less the walls'
  // work against its start, by the greatest wave's energy g length A^2/2; and the greatest of the
  // surface's last quarter of Legendre coefficients, by that wave's height A, length/1000 at least.
  std::vector<double> volume_error, energy_error, unresolved;
  double valid_until = 0;          // [s]
  std::string left_range_because;  // empty: it did not
};

// Ends before the last of the times where the surface is steeper than 2 (63 degrees), reaches the
// roof or comes within 2 % of the fill depth of the bottom; where `unresolved` exceeds 1e-3, the
// volume is off by 1e-8 of the depth or the energy by 1e-4; and where Laplace's equation or the
// step in time does not converge. Throws std::invalid_argument for an impossible tank, grid,
// motion, initial elevation, time or place, a motion that turns out not finite on the way among
// them.
NonlinearRecord run_nonlinear_potential_flow(const NonlinearSloshing& sloshing,
                                             const Observation& observation);

}  // namespace slosh::reference
