// The findings on waves: against linear theory, at the highest crests, and of their spectrum.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "verification/papers/claim_evidence.hpp"
#include "verification/papers/findings.hpp"
#include "verification/papers/surface_spectrum.hpp"
#include "verification/series/time_series.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

using Cases = std::vector<CaseAssessment>;

// Returns the comparison of runs[0] with theory, runs[1], at the first gauge. Throws where there is
// none that counts.
const Comparison& against_theory(const CaseAssessment& assessment, const FindingRow& row) {
  const std::string &run = row.runs.at(0), &theory = row.runs.at(1);
  standing_result(assessment, run);
  standing_result(assessment, theory);
  if (assessment.runs.status.at(theory).state == RunState::out_of_range)
    throw std::runtime_error(theory + " of " + assessment.definition.name + ": out of range");
  const std::string quantity = at_first_gauge(assessment.definition, "elevation");
  for (const Comparison& one : assessment.comparisons)
    if (one.candidate == run && one.reference == theory && one.quantity == quantity) return one;
  throw std::runtime_error(run + " could not be compared with " + theory);
}

const ModeComparison& mode_named(const Comparison& comparison, const std::string& name) {
  for (const ModeComparison& mode : comparison.modes)
    if (mode.mode == name) {
      if (mode.resolved()) return mode;
      throw std::runtime_error(
          fmt::format("{} of {} cannot be resolved", name, comparison.candidate));
    }
  throw std::runtime_error(name + " was not fitted");
}

Finding mode_error(const Cases& cases, const FindingRow& row, Estimate ModeComparison::*error) {
  const Comparison& comparison = against_theory(case_named(cases, row.cases.at(0)), row);
  return within({row.runs.at(0) + ": " + row.name, 100, "%"},
                mode_named(comparison, row.quantity).*error, row.thresholds.at(0));
}

struct BothSpectra {
  SurfaceSpectrum smaller, larger;

  double growth(std::size_t k) const { return larger.peak[k].power / smaller.peak[k].power; }
};

BothSpectra both_spectra(const Cases& cases, const FindingRow& row) {
  return {surface_spectrum(case_named(cases, row.cases.at(0)), row.runs.at(0)),
          surface_spectrum(case_named(cases, row.cases.at(1)), row.runs.at(0))};
}

// A missing peak, of NaN, speaks against two peaks.
bool at_multiples(const SurfaceSpectrum& spectrum, const Threshold& range) {
  const auto at = [&](std::size_t k) {
    const double expected = static_cast<double>(k + 1) * spectrum.excitation;
    return compare(spectrum.peak[k].frequency / expected - 1, range) == Held::yes;
  };
  return spectrum.highest && at(0) && at(1);
}

}  // namespace

namespace evidence {

Finding frequency_against_theory(const Cases& cases, const FindingRow& row) {
  return mode_error(cases, row, &ModeComparison::frequency_error);
}

Finding amplitude_against_theory(const Cases& cases, const FindingRow& row) {
  return mode_error(cases, row, &ModeComparison::amplitude_error);
}

Finding flattened_crests(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  against_theory(assessment, row);
  const std::string quantity = at_first_gauge(assessment.definition, "elevation");
  const TimeWindow window = comparison_window(assessment.definition);
  const double ours = skewness(standing_result(assessment, row.runs.at(0)).at(quantity), window);
  const double theory = skewness(standing_result(assessment, row.runs.at(1)).at(quantity), window);
  return {compare(theory - ours, row.thresholds.at(0)),
          fmt::format("{}: skewness of the elevation {:+.3f} against theory's {:+.3f} (at least "
                      "{:.2g} less)",
                      row.runs.at(0), ours, theory, row.thresholds.at(0).upper)};
}

Finding violent_motion(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  const CaseDefinition& definition = assessment.definition;
  const TimeSeries elevation = cut_to_window(
      standing_result(assessment, row.runs.at(0)).at(at_first_gauge(definition, "elevation")),
      comparison_window(definition));
  const auto [lowest, highest] =
      std::minmax_element(elevation.value.begin(), elevation.value.end());
  const double over_depth = *highest / definition.liquid.fill_depth;
  // A surface that never falls has no trough to compare with.
  const double ratio = *lowest < 0 ? *highest / -*lowest : not_a_number;
  return {
      both(compare(over_depth, row.thresholds.at(0)), compare(ratio, row.thresholds.at(1))),
      fmt::format("{} of {}: highest elevation {:.2f} depths (at least {:.2g}), {:.2f} times as "
                  "high as the lowest is deep (at least {:.3g})",
                  row.runs.at(0), definition.name, over_depth, row.thresholds.at(0).upper, ratio,
                  row.thresholds.at(1).upper)};
}

Finding peaks_at_multiples(const Cases& cases, const FindingRow& row) {
  const BothSpectra found = both_spectra(cases, row);
  const Threshold &at_frequency = row.thresholds.at(0), &grows = row.thresholds.at(1);
  const bool placed =
      at_multiples(found.smaller, at_frequency) && at_multiples(found.larger, at_frequency);
  const auto text = [](const SurfaceSpectrum& one) {
    return fmt::format("{:.3f} and {:.3f} Hz{}", one.peak[0].frequency, one.peak[1].frequency,
                       one.highest ? "" : " (not the two highest)");
  };
  const Held grown = both(compare(found.growth(0), grows), compare(found.growth(1), grows));
  return {placed ? grown : Held::no,
          fmt::format("{}: peaks at {}, then {} (within {:.2g} % of {:.3f} and {:.3f} Hz); powers "
                      "grow {:.3g} and {:.3g} times (at least {})",
                      row.runs.at(0), text(found.smaller), text(found.larger),
                      100 * at_frequency.upper, found.smaller.excitation,
                      2 * found.smaller.excitation, found.growth(0), found.growth(1), grows.upper)};
}

Finding growth_of_peak_ratio(const Cases& cases, const FindingRow& row) {
  const BothSpectra found = both_spectra(cases, row);
  const Threshold &grows = row.thresholds.at(0), &near_printed = row.thresholds.at(1);
  const double smaller = found.smaller.ratio(), larger = found.larger.ratio();
  return {both(compare(larger / smaller, grows),
               both(compare(smaller / row.printed.at(0), near_printed),
                    compare(larger / row.printed.at(1), near_printed))),
          fmt::format("{}: first over second from {:.3g} to {:.3g} (printed: {:.2f} to {:.3f}; met "
                      "within a factor of {})",
                      row.runs.at(0), smaller, larger, row.printed.at(0), row.printed.at(1),
                      near_printed.upper)};
}

}  // namespace evidence
}  // namespace slosh
