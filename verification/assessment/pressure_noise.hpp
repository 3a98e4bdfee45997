// How noisy a wall pressure is: what of its power lies above the frequencies that the liquid's
// motion has,
//   noise = (mean square of the part above f_n) / (mean square of the pressure, its mean included),
//   f_n = the larger of 5 Hz and three times the third natural mode that surge excites.
// The part above comes from the power spectrum of spectrum.hpp (Hann window, padding by four, whose
// bins add up to six times a noise's mean square). The mean belongs to the signal, so that a still
// tank, whose pressure does not vary, has a measure too. Impacts reach far above f_n and drown all
// else: of a case with impacts take the plateaus behind them.
#pragma once

#include "verification/case/case_definition.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

double noise_band(const CaseDefinition& definition);  // f_n [Hz]

// Throws ComparisonError as power_spectrum() does, and where the sampling reaches no frequency
// above twice the band.
double pressure_noise(const TimeSeries& pressure, TimeWindow window, double band);

// Rms of the pressure about its least-squares line on the plateau behind each impact, over the
// published plateau: the plateau that is published, and as long after each other published impact
// those that lie within the run. Throws ComparisonError as cut_to_window() does, and where the case
// says nothing of impacts.
double plateau_noise(const TimeSeries& pressure, const CaseDefinition& definition);

}  // namespace slosh
