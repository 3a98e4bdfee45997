// A tank whose liquid hits its left wall four times, and the pressure of a run that does as the
// experiment: a peak of 4 ms at each published time, then a plateau that fades.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

inline const std::string impact_pressure = "wall_pressure@B";

// Published as SPHERIC benchmark 10, but for repeats made by hand: 40 peaks from 0.5 to 1.5 of the
// mean.
inline CaseDefinition impact_case() {
  CaseDefinition definition{};
  definition.name = "impacts";
  definition.title = "Impacts";
  definition.source = "none";
  definition.gravity = 9.81;
  definition.tank = {0.9, 0.508};
  definition.liquid = {0.093, 998, 9e-7};
  definition.gas = {1.2, 1.5e-5};
  definition.motion.roll = RollDefinition{SineMotion{0.07, 3.85}, 0.45, 0};
  definition.start = Start::tank;
  definition.duration = 8;
  definition.sample_interval = 0.001;
  definition.pressure_gauges = {{.name = "B", .wall = Wall::left, .position = 0.093}};
  definition.window_begin = 1;
  definition.window_end = 8;
  ImpactsDefinition impacts{.gauge = "B",
                            .times = {2.375, 4.073, 5.718, 7.303},
                            .period = 1.633,
                            .peak_means = {3710, 4816, 4691, 4643},
                            .peak_deviations = {732, 1501, 1706, 1323},
                            .plateau_begin = 2.45,
                            .plateau_end = 2.65,
                            .plateau = 670,
                            .peak_table = "peaks.txt",
                            .repeats = {},
                            .source = "a paper"};
  for (const double mean : impacts.peak_means) {
    impacts.repeats.emplace_back();
    for (int i = 0; i < 40; ++i) impacts.repeats.back().push_back(mean * (0.5 + i / 39.0));
  }
  definition.impacts = impacts;
  return definition;
}

struct ImpactRun {
  double late = 0;         // [s]
  double scale = 1;        // of peaks and plateau
  int impacts = 4;         // that come
  double until = 8;        // [s]
  double sampling = 1e-3;  // [s]
  std::string name = impact_pressure;
};

inline TimeSeries pressure_of(const ImpactRun& run) {
  const ImpactsDefinition published = *impact_case().impacts;
  TimeSeries series{run.name, "Pa", {}, {}};
  for (int i = 0; i * run.sampling <= run.until * (1 + 1e-12); ++i) {
    const double t = i * run.sampling;
    double pressure = 0;
    for (int n = 0; n < run.impacts; ++n) {
      const auto k = static_cast<std::size_t>(n);
      const double after = t - published.times[k] - run.late;
      const double plateau = after < -1e-9 ? 0
                             : after < 0.3 ? 670
                                           : 670 * std::exp(-(after - 0.3) / 0.05);
      pressure += plateau + (published.peak_means[k] - 670) * std::exp(-after * after / 8e-6);
    }
    series.time.push_back(t);
    series.value.push_back(run.scale * pressure);
  }
  return series;
}

}  // namespace slosh
