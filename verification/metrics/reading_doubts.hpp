// What is doubtful about the readings of a series (sensor_limits.hpp), in sentences. A flat is no
// doubt where the quantity rests: at the bottom or the roof, or at the zero of a pressure or of a
// wall's load that falls dry. A pressure rests at its lowest value alone: a crest that reads 0 is
// cut off.
#pragma once

#include <string>
#include <vector>

#include "verification/series/readings/sensor_limits.hpp"

namespace slosh {

struct SensorReadings {
  std::string role;  // "candidate", "reference"
  std::string unit;
  SensorLimits limits;
  std::vector<double> rests = {};  // the values at which it may stay, in the unit
};

// Whether the quantity is a load or a pressure, which impacts interrupt.
bool has_impacts(const std::string& unit);

// "the candidate stays at its highest value, 0.01 m, from 1.2 to 1.4 s, which cuts off some 0.002
// m", that it holds each reading or follows straight lines between them, that samples leave
// their neighbours alone, which an impact does too: not of a load, nor of a pressure that rises,
// and that stretches are lost; empty where nothing is doubtful. Steps are told apart (step_doubt).
std::vector<std::string> doubts_of_readings(const SensorReadings& of);

// "the values of the candidate lie 0.01 m apart, 20 steps from the lowest to the highest: each may
// be off by half a step". Requires a step.
std::string step_doubt(const SensorReadings& of);

}  // namespace slosh
