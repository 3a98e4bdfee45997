// The findings on waves: their growth, against linear theory, between runs, and of their spectrum.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "verification/case/ensemble.hpp"
#include "verification/case/motion.hpp"
#include "verification/papers/claim_evidence.hpp"
#include "verification/papers/findings.hpp"
#include "verification/papers/measured_values.hpp"
#include "verification/papers/surface_spectrum.hpp"
#include "verification/series/sample_moments.hpp"
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
  return judged({row.runs.at(0) + ": " + row.name, 100, "%"},
                mode_named(comparison, row.quantity).*error, row.thresholds.at(0));
}

std::vector<double> numbers(const std::vector<Readings>& members, double Readings::*which) {
  std::vector<double> found;
  for (const Readings& one : members) found.push_back(one.*which);
  return found;
}

// Judges a ratio by both readings, and leaves it open where they disagree.
template <class Ratio>
Finding judged_ratio(const FindingRow& row, const std::string& of, const Ratio& ratio) {
  const auto by = [&](double Readings::*which, const std::string& reading) {
    return judged({fmt::format("{}: {}{}", of, row.name, reading), 1, ""}, ratio(which),
                  row.thresholds.at(0));
  };
  if (row.of.quantity != "momentum") return by(&Readings::small, "");
  const Finding small = by(&Readings::small, " by |P|"),
                large = by(&Readings::large, " by sqrt(2 M K)");
  return {small.held == large.held ? small.held : Held::undecided, small.text + "; " + large.text};
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
  Finding finding =
      judged({row.runs.at(0) + ": skewness of theory's elevation less its own", 1, ""},
             {theory - ours, 0}, row.thresholds.at(0));
  finding.text += fmt::format(", which is {:+.3f}", ours);
  return finding;
}

Finding ratio(const Cases& cases, const FindingRow& row) {
  const CaseAssessment &above = case_named(cases, row.cases.back()),
                       &below = case_named(cases, row.cases.front());
  const auto over = measured(below, row.runs.back(), row.over.value_or(row.of));
  const auto of = measured(above, row.runs.front(), row.of);
  const std::string names =
      fmt::format("{}{}", name_of_members(above, row.runs.front()),
                  row.runs.size() > 1 ? " over " + name_of_members(below, row.runs.back()) : "");
  if (row.by_repeats && std::min(of.size(), over.size()) < 2)
    return {Held::undecided, fmt::format("{}: {} needs repeats of both, as each history is chaotic",
                                         names, row.name)};
  return judged_ratio(row, names, [&](double Readings::*which) {
    const Estimate found =
        ratio_of_members(numbers(of, which), numbers(over, which), SingleSide::one_of_many);
    const double printed = row.printed.value_or(1);
    return Estimate{found.value / printed, found.half_width / printed};
  });
}

Finding against_printed(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  const auto of = measured(assessment, row.runs.at(0), row.of);
  return judged_ratio(row,
                      fmt::format("{} of {}", name_of_members(assessment, row.runs.at(0)),
                                  assessment.definition.name),
                      [&](double Readings::*which) {
                        return ratio_of_members(numbers(of, which), {row.printed.value()});
                      });
}

Finding lag_of_runs(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  const CaseDefinition& definition = assessment.definition;
  const std::string quantity = at_first_gauge(definition, "elevation");
  std::vector<std::vector<Estimate>> pairs;
  for (const std::string& one : members_of(definition, row.runs.at(0))) {
    pairs.emplace_back();
    for (const std::string& other : members_of(definition, row.runs.at(1)))
      pairs.back().push_back(tone_difference(standing_result(assessment, one).at(quantity),
                                             standing_result(assessment, other).at(quantity),
                                             comparison_window(definition),
                                             forcing_frequency(definition))
                                 .lag_degrees);
  }
  const bool is_single = pairs.size() == 1 && pairs.front().size() == 1;
  return judged({fmt::format("{} of {}: lag behind {}", name_of_members(assessment, row.runs.at(0)),
                             definition.name, name_of_members(assessment, row.runs.at(1))),
                 1, "deg"},
                is_single ? pairs.front().front() : ensemble_mean(pairs, SingleSide::one_of_many),
                row.thresholds.at(0));
}

Finding violent_motion(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  const CaseDefinition& definition = assessment.definition;
  const double depth = definition.liquid.fill_depth;
  std::vector<double> heights, jets, speeds;
  for (const std::string& member : members_of(definition, row.runs.at(0))) {
    const RunResult& result = standing_result(assessment, member);
    const auto in_window = [&](const std::string& name) {
      return cut_to_window(result.at(name), comparison_window(definition));
    };
    const auto largest = [](const std::vector<double>& values) {
      return *std::max_element(values.begin(), values.end());
    };
    const CommonSamples surface =
        common_samples(in_window(at_first_gauge(definition, "highest_surface")),
                       in_window(at_first_gauge(definition, "elevation")));
    heights.push_back(largest(surface.reference) / depth);
    jets.push_back(largest(minus(surface.candidate, surface.reference)) / depth);
    speeds.push_back(largest(in_window("mach_number").value) *
                     diagnostic_of(assessment, member, "speed_of_sound_m_s") /
                     std::sqrt(definition.gravity * depth));
  }
  const Finding parts[]{
      judged({"highest elevation over the depth", 1, ""}, mean_of_members(heights),
             row.thresholds.at(0)),
      judged({"highest wet point above the liquid's own depth there, over the depth,", 1, ""},
             mean_of_members(jets), row.thresholds.at(1)),
      judged({"largest speed over sqrt(g depth)", 1, ""}, mean_of_members(speeds),
             row.thresholds.at(2))};
  return {both(parts[0].held, both(parts[1].held, parts[2].held)),
          fmt::format("{} of {}: {}, {}, {}", name_of_members(assessment, row.runs.at(0)),
                      definition.name, parts[0].text, parts[1].text, parts[2].text)};
}

Finding peaks_at_multiples(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  const auto members = surface_spectra(assessment, row.runs.at(0));
  const Threshold& at_frequency = row.thresholds.at(0);
  const auto count = std::count_if(members.begin(), members.end(), [&](const SurfaceSpectrum& one) {
    return is_at_multiples(one, at_frequency);
  });
  const double excitation = members.front().excitation;
  return {are_at_multiples(members, at_frequency),
          fmt::format("{} of {}: peaks [Hz] at {} and {} (in {} of {} these are the two highest "
                      "and within {:.2g} % of {:.3f} and {:.3f})",
                      name_of_members(assessment, row.runs.at(0)), assessment.definition.name,
                      frequency_text(members, 0), frequency_text(members, 1), count, members.size(),
                      100 * at_frequency.upper, excitation, 2 * excitation)};
}

}  // namespace evidence
}  // namespace slosh
