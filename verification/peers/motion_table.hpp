// The tank's motion as a table, for codes that read no case file, and what it makes the liquid feel
// in the tank's frame.
#pragma once

#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// The surge X along the earth's horizontal, and the roll theta, positive counter-clockwise.
struct MotionPoint {
  double time;                                       // [s]
  double surge, surge_velocity, surge_acceleration;  // [m], [m/s], [m/s2]
  double angle, rate, angular_acceleration;          // [rad], [rad/s], [rad/s2]
};

// Returns the motion from 0 to the case's duration at ten steps a sample and at the points of its
// tables, between which straight lines are exact (motion_times.hpp).
std::vector<MotionPoint> motion_table(const CaseDefinition& definition);

// The uniform part of what acts on a unit of mass at rest in the tank's frame, along the tank's
// axes: gravity less the acceleration of the roll's axis [m/s2],
//     g_x = -X'' cos theta - g sin theta,   g_z = X'' sin theta - g cos theta.
// A roll adds, at the place (x, z) from its axis and the velocity (u, w) in the tank's frame,
//     theta'' z + theta'^2 x + 2 theta' w   and   -theta'' x + theta'^2 z - 2 theta' u.
struct TankGravity {
  double x, z;
};

TankGravity tank_gravity(const MotionPoint& motion, double gravity);

// The liquid's first velocity in the frame of the tank, which starts level [m/s]: -X'(0) of a
// start in the earth's frame.
double initial_velocity_x(const CaseDefinition& definition);

// Whether the liquid starts at rest in the earth's frame while the tank begins to roll at a rate:
// its velocity in the tank's frame is then not uniform.
bool starts_against_roll(const CaseDefinition& definition);

}  // namespace slosh
