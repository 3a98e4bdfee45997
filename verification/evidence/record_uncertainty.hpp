// The uncertainty of a metric that follows from the declared uncertainty u of a record's values
// (the half width of their 95 % interval, in the series' unit). Let A be the amplitude of the
// record's mode, omega its angular frequency and T the window's length. The record's error is
// assumed to have the shape of the mode, in phase or in quadrature, constant or growing from one
// end of the window to the other. With s = u / A the phase is off by
//   phase_lag        asin(s)
// and the record's own value, of which the metric's error E is a share, may be less by the share d:
//   amplitude_error  d = s                         frequency_error  d = 2 asin(s) / (omega T)
//   decay_error      d = 2 artanh(s) / (T decay rate)
// E then changes by (1 + E) d / (1 - d), which is infinite from d = 1 on.
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
