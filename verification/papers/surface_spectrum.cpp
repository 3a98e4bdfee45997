#include "verification/papers/surface_spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/case/ensemble.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/papers/claim_evidence.hpp"
#include "verification/series/interval_text.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

constexpr int sought_peaks = 8;
// Returns the peak nearest to a frequency, within the resolution of the window; NaN without one.
SpectralPeak nearest(const std::vector<SpectralPeak>& peaks, double frequency, double resolution) {
  SpectralPeak best{not_a_number, not_a_number};
  double distance = resolution;
  for (const SpectralPeak& peak : peaks) {
    if (!(std::abs(peak.frequency - frequency) < distance)) continue;
    best = peak;
    distance = std::abs(peak.frequency - frequency);
  }
  return best;
}

double amplitude(const CaseDefinition& definition) {
  const auto* sine =
      definition.motion.surge ? std::get_if<SineMotion>(&*definition.motion.surge) : nullptr;
  return sine ? sine->amplitude : not_a_number;
}

// Powers and their ratios are geometric means, as those of the growth.
std::vector<std::string> cells(const std::vector<SurfaceSpectrum>& members) {
  const auto mean_power = [&](std::size_t k) {
    return mean_text(ratio_of_members(powers(members, k), {1}));
  };
  return {frequency_text(members, 0), mean_power(0), frequency_text(members, 1), mean_power(1),
          mean_text(ratio_of_members(ratios(members), {1}))};
}

// Adds the two rows of a run; the second has the growth.
void add_rows(const CaseAssessment& smaller, const CaseAssessment& larger, const std::string& run,
              reports::Table& table) {
  const auto row_of = [&](const CaseAssessment& assessment) {
    std::vector<std::string> row{name_of_members(assessment, run),
                                 fmt::format("{}", amplitude(assessment.definition))};
    try {
      const auto found = cells(surface_spectra(assessment, run));
      row.insert(row.end(), found.begin(), found.end());
    } catch (const std::runtime_error& error) {
      row.push_back(error.what());
    }
    row.resize(table.header.size());
    return row;
  };
  table.rows.push_back(row_of(smaller));
  auto last = row_of(larger);
  try {
    const auto less = surface_spectra(smaller, run), more = surface_spectra(larger, run);
    for (const std::size_t k : {0u, 1u})
      last[7 + k] = mean_text(ratio_of_members(powers(more, k), powers(less, k)));
  } catch (const std::runtime_error&) {
    // The row says what is missing.
  }
  table.rows.push_back(std::move(last));
}

}  // namespace

SurfaceSpectrum surface_spectrum(const CaseAssessment& assessment, const std::string& run) {
  const CaseDefinition& definition = assessment.definition;
  const TimeSeries& surface =
      standing_result(assessment, run).at(at_first_gauge(definition, "highest_surface"));
  const Spectrum spectrum = power_spectrum(surface, comparison_window(definition));
  const auto peaks = spectral_peaks(spectrum, sought_peaks);
  SurfaceSpectrum found{.excitation = forcing_frequency(definition) / (2 * std::numbers::pi),
                        .peak = {},
                        .highest = false};
  for (const std::size_t k : {0u, 1u})
    found.peak[k] =
        nearest(peaks, static_cast<double>(k + 1) * found.excitation, spectrum.resolution);
  const auto is_highest = [&](const SpectralPeak& peak) {
    return peaks.size() >= 2 && (peak.power == peaks[0].power || peak.power == peaks[1].power);
  };
  found.highest = is_highest(found.peak[0]) && is_highest(found.peak[1]);
  return found;
}

std::vector<SurfaceSpectrum> surface_spectra(const CaseAssessment& assessment,
                                             const std::string& run) {
  std::vector<SurfaceSpectrum> members;
  for (const std::string& member : members_of(assessment.definition, run))
    members.push_back(surface_spectrum(assessment, member));
  return members;
}

std::vector<double> powers(const std::vector<SurfaceSpectrum>& members, std::size_t peak) {
  std::vector<double> found;
  for (const SurfaceSpectrum& one : members) found.push_back(one.peak[peak].power);
  return found;
}

std::vector<double> ratios(const std::vector<SurfaceSpectrum>& members) {
  std::vector<double> found;
  for (const SurfaceSpectrum& one : members) found.push_back(one.ratio());
  return found;
}

std::string frequency_text(const std::vector<SurfaceSpectrum>& members, std::size_t peak) {
  std::vector<double> found;
  for (const SurfaceSpectrum& one : members) found.push_back(one.peak[peak].frequency);
  const auto missing =
      std::count_if(found.begin(), found.end(), [](double one) { return std::isnan(one); });
  if (missing > 0) return fmt::format("none in {} of {}", missing, found.size());
  return interval_text(mean_of_members(found));
}

std::string mean_text(const Estimate& mean) {
  return std::isfinite(mean.value) ? interval_text(mean) : "unknown";
}

reports::Table surface_spectrum_table(const CaseAssessment& smaller, const CaseAssessment& larger,
                                      const RedrawnFigures& redrawn) {
  reports::Table table{
      "li2010-spectrum",
      "Spectrum of the highest surface elevation",
      fmt::format(
          "Peaks at the excitation frequency and at twice that, {} m from the left wall, from {} "
          "to {} s. Power: half the squared amplitude of a sine [m2], one-sided, Hann window. Of "
          "an ensemble they are means over its repeats, the powers geometric ones. The unit of the "
          "printed power is unknown, so only ratios can be compared. Growth: from the "
          "smaller to the larger amplitude b.",
          smaller.definition.gauges.empty() ? not_a_number : smaller.definition.gauges.front().x,
          smaller.definition.window_begin, smaller.definition.window_end),
      {"run", "b [m]", "first peak [Hz]", "its power", "second peak [Hz]", "its power",
       "first / second", "growth of the first", "growth of the second"},
      {{"printed", "0.075", "0.77", "0.048", "1.54", "0.024", "2.00", "", ""},
       {"printed", "0.125", "0.77", "0.2423", "1.54", "0.0493", "4.915",
        fmt::format("{:.3g}", 0.2423 / 0.048), fmt::format("{:.3g}", 0.0493 / 0.024)}}};
  for (const RunDefinition& run : smaller.definition.runs) {
    if (solver_kind(run).solves_flow && !is_later_member(run) &&
        larger.runs.status.contains(run.name))
      add_rows(smaller, larger, run.name, table);
  }
  table.links.assign(table.rows.size(), std::vector<std::string>(table.header.size()));
  for (std::vector<std::string>& row : table.links) row.front() = anchor_of(redrawn, "7");
  return table;
}

}  // namespace slosh
