// The noise of a wall pressure: the part of its power above the frequencies of the liquid's motion,
//   noise = (mean square of the part above f_n) / (mean square of the pressure, its mean included),
//   f_n = the larger of 5 Hz and three times the third natural mode that surge excites.
// The part above comes from the power spectrum of spectrum.hpp (Hann window, padding by four, whose
// bins add up to six times a noise's mean square). The mean belongs to the signal, so that the
// measure exists for a still tank, whose pressure does not vary. Impacts have power far above f_n:
// in a case with impacts, plateau_noise() measures the plateaus after them instead.
#pragma once

#include "verification/case/case_definition.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

double noise_band(const CaseDefinition& definition);  // f_n [Hz]

// Throws ComparisonError as power_spectrum() does, and where the sampling does not resolve twice
// the frequency f_n (`band`).
double pressure_noise(const TimeSeries& pressure, TimeWindow window, double band);

// The rms of the pressure about its least-squares line on the plateau after each impact, over the
// published plateau. The first plateau has the published times; those of the other impacts come as
// long after it as the published impacts do, and count where they lie within the run. Throws
// ComparisonError as cut_to_window() does, and where the case has no [impacts].
double plateau_noise(const TimeSeries& pressure, const CaseDefinition& definition);

}  // namespace slosh
