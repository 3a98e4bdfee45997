// The uncertainty of a metric that follows from the declared uncertainty u of a record's values
// (the half width of their 95 % interval, in the series' unit). Let A be the amplitude of the
// record's mode, omega its angular frequency and T the window's length. The record's error is
// assumed to have the shape of the mode, in phase or in quadrature, constant or growing from one
// end of the window to the other. To first order:
//   amplitude_error  u / A                phase_lag    u / A [rad]
//   frequency_error  2 u / (A omega T)    decay_error  2 u / (A T) over the record's decay rate
// A metric of the whole window is measured again with the record raised and lowered by u, and with
// errors of that kind: the deviations from the mean over their largest one, and each of their
// components a quarter of its period later, constant and growing from -1 to 1, times u and -u. The
// largest change of the metric counts. Where u is as large as the amplitude or the largest
// deviation, the record may be of nothing: the uncertainty is infinite, but for a mean offset.
// Errors that are independent from sample to sample have a smaller effect on all of these.
#pragma once

#include <functional>
#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

// Returns the row's metric measured with `series` in the place of the series of the row's quantity
// that `run`, the row's candidate or reference, left. Throws what measured() throws.
using MeasureWithSeries =
    std::function<Estimate(const GateRow& row, const std::string& run, const TimeSeries& series)>;

// The uncertainty of a metric of one mode, in the metric's unit; zero for a metric that does not
// depend on the reference's fit.
double uncertainty_from_values(Metric metric, const std::string& mode, const Comparison& comparison,
                               double half_width);

// The uncertainty of the row's metric, whose reference is `record` with values of this half width.
// `comparison` is the comparison of the row's candidate with it. Throws what `measure_with` throws.
double record_uncertainty(const GateRow& row, const TimeSeries& record,
                          const Comparison& comparison, double half_width,
                          const MeasureWithSeries& measure_with);

}  // namespace slosh
