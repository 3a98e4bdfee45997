// What linear theory leaves out of a case's waves: the second and the third order of their
// steepness (reference/third_order_waves.hpp), as an estimate of its error. The waves are those of
// a rectangle as long as the still surface, of the fill depth or, for another section, of the depth
// that has the section's first natural frequency. A roll moves the liquid as the surge of the
// acceleration g theta - theta'' (fill depth - axis). The motion is scaled so that the linear waves
// have the height of linear theory at the right wall. Elevations in surges and
// standing waves are right to a twentieth of what nonlinear potential flow adds. Elsewhere the
// estimate is rather too large: in a roll and for pressures it has 0.7 to 6 times the size of the
// truth, for forces and moments up to 20 times (tests/beyond_linear_test.cpp).
#pragma once

#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

// Returns eta - eta_linear [place][time] at the case's sample times at places x [m] from the tank's
// left end. `at_right` is the elevation of linear theory at the right end of the still surface
// [m]; with a viscosity [m2/s] the waves decay. The estimate is not finite where the waves are too
// steep for it.
std::vector<std::vector<double>> beyond_linear(const CaseDefinition& definition,
                                               const std::vector<double>& at_right,
                                               const std::vector<double>& x,
                                               double kinematic_viscosity = 0);

// Returns straight lines between values that are an interval apart, from 0 s on, at times [s]; the
// last value after them. Requires two values.
std::vector<double> at_times(const std::vector<double>& value, double interval,
                             const std::vector<double>& times);

// Adds the series moved by scale times `rise`, with the suffix `nonlinear`, to the result where all
// of it is finite.
void add_moved(TimeSeries series, const std::vector<double>& rise, double scale, RunResult& result);

}  // namespace slosh
