// What is doubtful about the readings of two series that are compared (sensor_limits.hpp), in
// sentences. A flat is no doubt where the other series rests at the same value, as at the bottom or
// the roof, and neither is one at zero of a pressure or a load, which a place has that falls dry.
#pragma once

#include <string>
#include <vector>

#include "verification/series/sensor_limits.hpp"

namespace slosh {

struct SensorReadings {
  std::string role;  // "candidate", "reference"
  std::string unit;
  SensorLimits limits;
};

// "the candidate's values lie 0.01 m apart, on 3 levels: each may be off by half of that"; empty
// where nothing is doubtful.
std::vector<std::string> reading_doubts(const SensorReadings& of, const SensorReadings& other);
// Of a series alone, of which the highest value is judged.
std::vector<std::string> reading_doubts(const SensorReadings& of);

}  // namespace slosh
