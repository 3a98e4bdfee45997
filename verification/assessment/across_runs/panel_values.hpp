// The numbers of a panel's members: what each run has by itself, without a reference.
//   impact_peak     the highest pressure near the published time of the impact (impact_peaks.hpp)
//   impact_arrival  when the pressure first reaches the published share of the published peak
//   impulse         the integral of the pressure over the panel's time from the arrival on
//   plateau         the mean of the pressure over the time of the published plateau
//   rms             the root mean square about the mean over the comparison's window
//   lag             by which the member is late against the mean of the solvers' mean histories, in
//                   the window: of highest cross-correlation, or for a quantity without modes that
//                   of the best alignment (time_alignment.hpp)
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// The mean of the solvers' mean histories over the window; each solver has one vote, whatever the
// number of its members. Throws ComparisonError where there is none or their histories have no time
// in common. All series must have passed cut_to_window().
TimeSeries mean_history(const std::vector<std::vector<TimeSeries>>& solvers);

// What a member's value is measured with.
struct PanelQuestion {
  const CaseDefinition& definition;
  const PanelDefinition& panel;
  PanelMetric metric;
  std::string mode;
  const TimeSeries* history = nullptr;  // mean_history(), for the metric lag
};

// Returns NaN where the impact never comes. Throws ComparisonError for a series that is unusable.
double panel_value(const PanelQuestion& question, const TimeSeries& series);

}  // namespace slosh
