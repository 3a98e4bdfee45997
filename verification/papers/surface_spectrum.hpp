// The spectrum of the highest surface elevation at a surging tank's first gauge, as in Li et al.
// 2010: its peaks at the excitation frequency and at twice that. The power is that of spectrum.hpp,
// over the comparison window.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/papers/paper_figures.hpp"

namespace slosh {

struct SurfaceSpectrum {
  double excitation;                 // [Hz]
  std::array<SpectralPeak, 2> peak;  // nearest to one and two times that; NaN where there is none
  bool highest;                      // whether these are the two highest peaks of the spectrum

  double ratio() const { return peak[0].power / peak[1].power; }
};

// Throws std::runtime_error where the run left no result or no such series, ComparisonError as
// power_spectrum() does.
SurfaceSpectrum surface_spectrum(const CaseAssessment& assessment, const std::string& run);

// The spectrum of each member of the ensemble that the run begins; one of a single run. Throws as
// surface_spectrum() does.
std::vector<SurfaceSpectrum> surface_spectra(const CaseAssessment& assessment,
                                             const std::string& run);

// One number of each spectrum: the power of a peak [m2], the first's over the second's [1].
std::vector<double> powers(const std::vector<SurfaceSpectrum>& members, std::size_t peak);
std::vector<double> ratios(const std::vector<SurfaceSpectrum>& members);

// The mean frequency of a peak with its interval [Hz] (mean_of_members()), or "none in 2 of 8"
// where members have no such peak.
std::string frequency_text(const std::vector<SurfaceSpectrum>& members, std::size_t peak);

// A mean over members with its interval, or "unknown" where a member has no such number.
std::string mean_text(const Estimate& mean);

// The spectra of every run of a solver that the two cases share, of an ensemble the means over its
// members, and the printed numbers. Its rows link to the panel of figure 7.
reports::Table surface_spectrum_table(const CaseAssessment& smaller, const CaseAssessment& larger,
                                      const RedrawnFigures& redrawn);

}  // namespace slosh
