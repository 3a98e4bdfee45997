// Samples of which many are low, as where echoes are weak, leave their neighbours by a share of the
// wave: by more at crests and in troughs than near the mean, where a sensor's noise is the same.
// The departures are sixth differences, scaled so that white noise keeps its deviation, in units of
// their mean in a wave (from up-crossing to up-crossing of the mean). They grow by F = min(crests,
// troughs) / near the mean: beyond 70 % of the wave's crest or trough, and within 30 %. They
// are told from F = 1.5 + 9 / sqrt(n) on, of n >= 320 samples, where the departures are
// - 2 % of the standard deviation or more in the median of crests and troughs, and rough there:
//   eighth differences are as large, from 0.65 to 1.12, as of no smooth crest,
// - all over the wave: at crests and in troughs 2.4 times as large as between at most,
// and where crests and troughs take most of the wave, of 24 samples or more in the median.
#pragma once

#include <optional>

#include "verification/series/time_series.hpp"

namespace slosh {

// F, where it is told. Requires finite values.
std::optional<double> growth_of_departures(const TimeSeries& series);

}  // namespace slosh
