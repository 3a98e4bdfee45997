// The findings on waves: against linear theory, at the highest crests, and of their spectrum.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "verification/case/ensemble.hpp"
#include "verification/papers/claim_evidence.hpp"
#include "verification/papers/findings.hpp"
#include "verification/papers/surface_spectrum.hpp"
#include "verification/series/interval_text.hpp"
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

// The spectra of runs[0], one of each member, in the case of the smaller and of the larger
// amplitude.
struct BothSpectra {
  std::vector<SurfaceSpectrum> smaller, larger;

  Estimate growth(std::size_t k) const {
    return ratio_of_members(powers(larger, k), powers(smaller, k));
  }
};

BothSpectra both_spectra(const Cases& cases, const FindingRow& row) {
  return {surface_spectra(case_named(cases, row.cases.at(0)), row.runs.at(0)),
          surface_spectra(case_named(cases, row.cases.at(1)), row.runs.at(0))};
}

// A missing peak, of NaN, speaks against two peaks.
bool is_at_multiples(const SurfaceSpectrum& spectrum, const Threshold& range) {
  const auto at = [&](std::size_t k) {
    const double expected = static_cast<double>(k + 1) * spectrum.excitation;
    return compare(spectrum.peak[k].frequency / expected - 1, range) == Held::yes;
  };
  return spectrum.highest && at(0) && at(1);
}

// Confirmed where all members have the two peaks there, refuted where none has.
Held are_at_multiples(const std::vector<SurfaceSpectrum>& members, const Threshold& range) {
  const auto is_there = [&](const SurfaceSpectrum& one) { return is_at_multiples(one, range); };
  if (std::all_of(members.begin(), members.end(), is_there)) return Held::yes;
  return std::any_of(members.begin(), members.end(), is_there) ? Held::undecided : Held::no;
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
  std::vector<double> heights, ratios;
  for (const std::string& member : members_of(definition, row.runs.at(0))) {
    const TimeSeries elevation = cut_to_window(
        standing_result(assessment, member).at(at_first_gauge(definition, "elevation")),
        comparison_window(definition));
    const auto [lowest, highest] =
        std::minmax_element(elevation.value.begin(), elevation.value.end());
    heights.push_back(*highest / definition.liquid.fill_depth);
    // A surface that never falls has no trough to compare with.
    ratios.push_back(*lowest < 0 ? *highest / -*lowest : not_a_number);
  }
  const Estimate over_depth = mean_of_members(heights), ratio = mean_of_members(ratios);
  return {
      both(compare(over_depth, row.thresholds.at(0)), compare(ratio, row.thresholds.at(1))),
      fmt::format(
          "{} of {}: highest elevation {} depths (at least {:.2g}), {} times as high as the "
          "lowest is deep (at least {:.3g})",
          name_of_members(assessment, row.runs.at(0)), definition.name, interval_text(over_depth),
          row.thresholds.at(0).upper, interval_text(ratio), row.thresholds.at(1).upper)};
}

Finding peaks_at_multiples(const Cases& cases, const FindingRow& row) {
  const BothSpectra found = both_spectra(cases, row);
  const Threshold &at_frequency = row.thresholds.at(0), &grows = row.thresholds.at(1);
  const Held placed = both(are_at_multiples(found.smaller, at_frequency),
                           are_at_multiples(found.larger, at_frequency));
  const auto text = [&](const std::vector<SurfaceSpectrum>& members) {
    const auto count = std::count_if(
        members.begin(), members.end(),
        [&](const SurfaceSpectrum& one) { return is_at_multiples(one, at_frequency); });
    return fmt::format("{} and {} ({} of {})", frequency_text(members, 0),
                       frequency_text(members, 1), count, members.size());
  };
  const double excitation = found.smaller.front().excitation;
  const Held grown = both(compare(found.growth(0), grows), compare(found.growth(1), grows));
  return {both(placed, grown),
          fmt::format(
              "{}: peaks [Hz] at {}, then at {} (in so many of the repeats these are the two "
              "highest and within {:.2g} % of {:.3f} and {:.3f}); powers grow by the factors {} "
              "and {} (at least {})",
              name_of_members(case_named(cases, row.cases.at(1)), row.runs.at(0)),
              text(found.smaller), text(found.larger), 100 * at_frequency.upper, excitation,
              2 * excitation, mean_text(found.growth(0)), mean_text(found.growth(1)), grows.upper)};
}

Finding growth_of_peak_ratio(const Cases& cases, const FindingRow& row) {
  const BothSpectra found = both_spectra(cases, row);
  const Threshold &grows = row.thresholds.at(0), &near_printed = row.thresholds.at(1);
  const std::vector<double> smaller = ratios(found.smaller), larger = ratios(found.larger);
  const auto over = [](const std::vector<double>& numbers, double printed) {
    return ratio_of_members(numbers, {printed});
  };
  return {both(compare(ratio_of_members(larger, smaller), grows),
               both(compare(over(smaller, row.printed.at(0)), near_printed),
                    compare(over(larger, row.printed.at(1)), near_printed))),
          fmt::format(
              "{}: first over second from {} to {} (printed: {:.2f} and {:.3f}; each must be met "
              "within a factor of {})",
              name_of_members(case_named(cases, row.cases.at(1)), row.runs.at(0)),
              mean_text(over(smaller, 1)), mean_text(over(larger, 1)), row.printed.at(0),
              row.printed.at(1), near_printed.upper)};
}

}  // namespace evidence
}  // namespace slosh
