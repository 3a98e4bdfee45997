// What the declared uncertainty u of a record's values (half width of their 95 % interval, in the
// series' unit) makes of a metric. To first order, with A the amplitude of the record's mode, omega
// its frequency and T the window's length, where the record's error has the mode's own shape, in
// phase or in quadrature, or grows so from one end of the window to the other:
//   amplitude_error  u / A                phase_lag    u / A [rad]
//   frequency_error  2 u / (A omega T)    decay_error  2 u / (A T) over the record's decay rate
// A metric of the whole window is measured again with the record a half width too high, too low,
// and with its deviations from its mean stretched and shrunk until the largest is off by one: the
// largest change counts. Errors that are independent from sample to sample change all of these
// less.
#pragma once

#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/gate/gate.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

// Of a metric of one mode, in the metric's unit; zero of any other.
double uncertainty_from_values(Metric metric, const std::string& mode, const Comparison& comparison,
                               double half_width);

// Of the row, whose reference is a record that has this half width. `comparison` is theirs. Throws
// as measured() does.
double record_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                          const GateRow& row, const Comparison& comparison, double half_width);

}  // namespace slosh
