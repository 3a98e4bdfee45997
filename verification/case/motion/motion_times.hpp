// At which times a motion by a table is read, so that every solver sees the same motion. The cubic
// spline through a table (motion.hpp) has an acceleration that is linear between the table's times.
// Straight lines between these times are therefore exact, and so is an integral over them. Read at
// other times the acceleration is aliased: the spline turns an error s of the positions into
// 6 s / dt^2, most of it at the highest frequencies that the table has.
#pragma once

#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// [s] Solvers read a motion at their own steps. A point of a table at less than this from the last
// one is left out, so that every solver resolves the rest.
inline constexpr double shortest_table_step = 2e-3;

// Returns the table from the time 0 on without the points that follow another by less than `step`
// [s]; all of it where fewer points were left than a spline needs. It must reach from 0 or before
// to after 0.
TableMotion thinned(const TableMotion& table, double step);

// Returns the times of a table between 0 and the duration, and these two; none for sines.
std::vector<double> motion_knots(const MotionHistory& history, double duration);

// Returns times from 0 to the case's duration, `step` or less apart, with the knots of its motion.
// Knots that differ by rounding, as those of two tables may, are one.
std::vector<double> motion_times(const CaseDefinition& definition, double step);

// Returns the case with its motions by tables read at 0, step, 2 step, ...: the positions there
// stay, and second differences of positions are means of the acceleration.
CaseDefinition with_tables_at(CaseDefinition definition, double step);

}  // namespace slosh
