// The numbers that claims of growth and of shape are made of: one for each member of an ensemble.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// Over periods: the window holds n whole periods T of the forcing from its beginning, n >= 1.
enum class Measure {
  mean,
  fluctuation,     // the rms about the mean of each period, which a slow drift does not change
  crest,           // the mean over periods of the highest value
  trough,          // the mean over periods of the lowest value, its magnitude
  largest,         // the highest value
  noise,           // the rms of what the case's filter of pressure takes out
  main_frequency,  // of the highest peak of the spectrum [Hz]
  // Of the peaks of the highest surface's spectrum at one and at two times the excitation
  // (surface_spectrum.hpp), whatever the quantity: frequencies [Hz], powers [m2], and the first
  // power over the second.
  first_frequency,
  second_frequency,
  first_power,
  second_power,
  power_ratio,
  // Of the case's impacts, whatever the quantity, the mean over the impacts of
  // |log(peak / published mean)|, and of |time - published time| over the period.
  peak_distance,
  time_distance
};

enum class Stage {
  steady,            // the comparison window
  late,              // its second half
  first,             // from the start to the window
  first_over_steady  // the measure of the first stage over that of the steady one
};

// A quantity is the name of a series; "elevation" and "highest_surface" are those at the first
// gauge, "wall_pressure" the one that the case filters. "momentum" is a magnitude, which Li et al.
// do not define. Two are recorded, by the momentum P and the kinetic energy K of a liquid of mass
// M, and they bound sum m |v| at each time by the triangle inequality and that of Cauchy and
// Schwarz [kg/s]:
//   |P| <= sum m |v| <= sqrt(2 M K)
struct Measured {
  std::string quantity;
  Measure measure = Measure::mean;
  Stage stage = Stage::steady;
};

// By the smaller and by the larger of two magnitudes; equal where there is one.
struct Readings {
  double small, large;
};

// One for each member of the ensemble that the run begins. NaN where an impact or a peak of the
// spectrum does not exist. Throws std::runtime_error where a run, a series or a window is missing.
std::vector<Readings> measured(const CaseAssessment& assessment, const std::string& run,
                               const Measured& what);

// |P| and sqrt(2 M K) [kg/s]. Throws ResultError where the result lacks a momentum
// or the energy, and std::runtime_error where their times differ.
std::pair<TimeSeries, TimeSeries> momentum_magnitudes(const RunResult& result,
                                                      const CaseDefinition& definition);

}  // namespace slosh
