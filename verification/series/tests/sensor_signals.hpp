// Waves that a sensor reads.
#pragma once

#include <cmath>

#include "verification/series/readings/sensor_limits.hpp"
#include "verification/tests/synthetic_series.hpp"

namespace slosh {

inline SensorLimits limits_of_all(const TimeSeries& series) {
  return sensor_limits(series, {series.time.front(), series.time.back()});
}

namespace sensor_readings {

constexpr double period = 1.37;

inline double wave(double t) { return std::sin(two_pi / period * t + 0.4); }

inline double in_steps(double value, double step) { return std::round(value / step) * step; }

}  // namespace sensor_readings
}  // namespace slosh
