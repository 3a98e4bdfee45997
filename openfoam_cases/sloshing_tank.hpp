// A tank as a program of OpenFOAM's interFoam family (volume of fluid) is to solve it: the tank
// surges, rolls or both.
// The solution is computed in the tank's frame on a static mesh with a tabulated acceleration and
// slip walls, in two dimensions, unless told otherwise. x is measured from the left wall and z up
// from the bottom. The liquid starts under a horizontal level, under a wave or as a dam about to
// break, and the tank may carry obstacles.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slosh::openfoam {

struct Fluid {
  double density;              // [kg/m3]
  double kinematic_viscosity;  // [m2/s]
};

struct Gauge {
  std::string name;
  double x;  // [m] from the left wall
};

// A rectangle that the tank carries, with walls like the tank's own [m]. It may touch the tank's
// walls and other obstacles. Its edges lie on faces of the uniform cells, to a hundredth of a cell.
struct Obstacle {
  double left, right;  // from the left wall
  double bottom, top;  // from the tank's bottom
};

// A corner of the tank's outline [m], from the left wall and the bottom.
struct Corner {
  double x, z;
};

// A sensor in a wall of the tank that measures the mean pressure over its width.
struct PressureGauge {
  enum class Wall { left, right, bottom, roof };
  std::string name;
  Wall wall;
  double position;  // [m] of its middle, above the bottom or from the left wall
  double width;     // [m] along the wall; 0 for a point
  // Its middle on the outline of a tank that has one, to 1e-6 of the tank's size; the wall and the
  // position are then ignored. A width that reaches beyond a corner goes on along the next edge.
  std::optional<Corner> at = {};
};

// A place in the tank where velocity and pressure are measured [m].
struct Probe {
  std::string name;
  double x, z;  // from the left wall and above the bottom
};

// The level at the start is amplitude cos(mode pi x / length) above the fill depth.
struct InitialWave {
  int mode;          // number of half waves between the walls
  double amplitude;  // [m]
};

// A rotation about an axis that moves with the tank's surge, counter-clockwise positive with x to
// the right and z up. At the angle 0 the tank is upright.
struct Roll {
  std::function<double(double)> angle, rate, acceleration;  // [rad], [rad/s], [rad/s2]
  double axis_x, axis_z;         // [m] from the tank's bottom left corner; may lie outside the tank
  double initial_relative_rate;  // of liquid and gas relative to the tank [rad/s]: -rate(0) for a
                                 // start at rest in the earth's frame
};

// The gap of a narrow tank that is solved in three dimensions,
// of which the mesh has one half (geometry/layers.hpp).
struct Gap {
  double breadth;  // [m]
  int cells;       // across the half, at least 4
};

// The program that solves the case.
enum class Program {
  inter_foam,      // an algebraic flux with compression (MULES) keeps the interface sharp
  inter_iso_foam,  // the interface is a polygon in each cell (isoAdvector, Roenby et al. 2016)
  compressible_inter_foam  // as interFoam, of a liquid and a gas that are compressible
                           // (compressible_fluids.hpp); it knows no friction in a gap
};

struct SloshingTank {
  double length, height, fill_depth;  // [m]
  // The corners of a tank that is not rectangular, counter-clockwise; they form a closed simple
  // polygon. Length and height are those of the rectangle around it, whose bottom left corner is
  // the origin, and cells_x and cells_z divide that rectangle (geometry/cut_mesh.hpp). It excludes
  // obstacles, a column and forces by wall.
  std::vector<Corner> outline = {};
  // The liquid stands from the left wall to here [m]; empty where it reaches from wall to wall.
  std::optional<double> column_width = {};
  std::vector<Obstacle> obstacles = {};
  std::optional<InitialWave> initial_wave = {};  // excludes a column and obstacles
  // A disturbance of a level that would otherwise be at rest, which makes repeats of a run differ
  // (geometry/initial_liquid.hpp). It excludes a column, obstacles and an initial wave.
  std::optional<InitialWave> start_disturbance = {};
  double gravity;  // [m/s2], downward
  Fluid liquid, gas;
  // Rate at which the gap walls of a narrow tank slow the liquid down [1/s]; 0: not
  // at all. It needs a viscous liquid.
  double gap_friction = 0;
  std::function<double(double)> velocity, acceleration;  // X'(t) [m/s], X''(t) [m/s2] of the surge,
                                                         // along the earth's horizontal
  double initial_relative_velocity;  // of liquid and gas relative to the tank [m/s]: -X'(0) for a
                                     // start at rest in the earth's frame
  std::optional<Roll> roll = {};
  double duration;         // [s]
  double sample_interval;  // [s]
  std::vector<Gauge> gauges;
  std::vector<PressureGauge> pressure_gauges = {};
  std::vector<Probe> probes = {};
  // The walls whose forces are recorded one by one: left, right, bottom, roof.
  std::vector<std::string> loaded_walls = {};
  std::vector<double> snapshot_times = {};  // [s]
  int cells_x, cells_z;
  int processes = 1;
  // The largest Courant numbers of any cell and of the cells that the interface cuts. In violent
  // flow they limit the time step.
  double courant_number = 0.5, interface_courant_number = 0.5;
  // How often a time step solves the whole set of equations. With one solution the compression that
  // moves the interface of compressibleInterFoam is a step old, and in breaking waves the volume of
  // the liquid drifts; with several the step is Euler's implicit one, which damps a wave at the
  // rate omega^2 dt / 2. In the tank of 1 m that surges by 0.125 m (30 x 30 cells) the volume
  // changes by
  //   one solution     -3.3e-4 in 8 s at a Courant number of 0.25; four pressure corrections or a
  //                    residual of 1e-11 give -5.3e-4 and -2.9e-4
  //   two solutions    +2.5e-4 in 20 s at 0.25, +9.1e-4 at 0.5
  //   three solutions  -0.6e-4 in 20 s and -1.9e-4 in 40 s at 0.5
  int outer_corrections = 1;
  bool no_slip = false;  // at all walls, those of obstacles too; it needs a viscous liquid
  // [m], of the cells beside the walls, from where they grow to uniform ones in the middle
  // (geometry/cell_faces.hpp). Without it all cells are uniform. It excludes obstacles and an
  // outline.
  std::optional<double> wall_cell = {};
  // Without it the case is one in two dimensions. It needs no_slip and excludes gap_friction,
  // obstacles and an outline.
  std::optional<Gap> gap = {};
  Program program = Program::inter_foam;
};

// The name of the program that solves the case. Its output is in log.<program>.
inline const char* program_of(const SloshingTank& tank) {
  switch (tank.program) {
    case Program::inter_iso_foam:
      return "interIsoFoam";
    case Program::compressible_inter_foam:
      return "compressibleInterFoam";
    case Program::inter_foam:
      break;
  }
  return "interFoam";
}

inline bool is_compressible(const SloshingTank& tank) {
  return tank.program == Program::compressible_inter_foam;
}

// Whether a pressure is wanted, which is one above that of the gas.
inline bool reads_gas_pressure(const SloshingTank& tank) {
  return !tank.pressure_gauges.empty() || !tank.probes.empty() || !tank.loaded_walls.empty();
}

}  // namespace slosh::openfoam
