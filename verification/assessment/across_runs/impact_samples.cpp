#include "verification/assessment/across_runs/impact_samples.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "verification/gate/distributions/permutation_test.hpp"
#include "verification/gate/impact_metrics.hpp"

namespace slosh {
namespace {

using Repeats = std::vector<const RunDefinition*>;

bool differ_in_seed_alone(const RunDefinition& one, const RunDefinition& other) {
  if (!one.ensemble.empty() && one.ensemble == other.ensemble) return true;
  const auto *first = std::get_if<SphRun>(&one.solver),
             *second = std::get_if<SphRun>(&other.solver);
  if (!first || !second || one.varies_inputs || other.varies_inputs) return false;
  SphRun alike = *second;
  alike.start_seed = first->start_seed;
  return *first == alike && first->start_seed != second->start_seed;
}

std::string ratio_text(const SampleFigure& error) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", 1 + error.value.value, 1 + error.interval.low,
                     1 + error.interval.high);
}

}  // namespace

std::string place_among_repeats(const CaseDefinition& definition, std::size_t impact, double peak) {
  const ImpactsDefinition& impacts = definition.impacts.value();
  if (!impacts.repeats.empty())
    return fmt::format("{:.0f} %", repeated_peaks(definition, impact).percentile(peak));
  if (impacts.peak_deviations.empty())
    return fmt::format("{:+.0f} %", 100 * (peak / impacts.peak_means[impact] - 1));
  return fmt::format("{:+.1f} sd",
                     (peak - impacts.peak_means[impact]) / impacts.peak_deviations[impact]);
}

std::vector<Repeats> repeated_runs(const CaseDefinition& definition) {
  std::vector<Repeats> groups;
  for (const RunDefinition& run : definition.runs) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const Repeats& one) {
      return differ_in_seed_alone(*one.front(), run);
    });
    if (group == groups.end())
      groups.push_back({&run});
    else
      group->push_back(&run);
  }
  std::erase_if(groups, [](const Repeats& group) { return group.size() < 2; });
  return groups;
}

PeakSample peak_sample(const CaseAssessment& assessment, const Repeats& repeats,
                       const std::string& pressure, std::size_t impact) {
  PeakSample sample;
  for (const RunDefinition* run : repeats) {
    try {
      const auto result = assessment.runs.results.find(run->name);
      if (result == assessment.runs.results.end())
        throw ResultError(state_name(assessment.runs.status.at(run->name).state));
      const auto peaks = impacts_in(result->second.at(pressure), assessment.definition);
      ++sample.usable;
      if (peaks[impact]) sample.peaks.push_back(peaks[impact]->pressure);
    } catch (const std::runtime_error& error) {  // ResultError and ComparisonError
      sample.left_out.push_back(fmt::format("{} ({})", run->name, error.what()));
    }
  }
  return sample;
}

std::optional<PeakComparison> against_experiment(const CaseDefinition& definition,
                                                 const PeakSample& sample, std::size_t impact) {
  if (definition.impacts->repeats.empty() || sample.peaks.size() < fewest_repeats)
    return std::nullopt;
  const Distribution experiment = repeated_peaks(definition, impact);
  if (experiment.sorted().size() < fewest_repeats) return std::nullopt;
  return compare_peaks(Distribution("peaks of repeated runs", sample.peaks), experiment);
}

std::string median_ratio_text(const PeakComparison& comparison) {
  return ratio_text(comparison.median_error);
}

// The tests by random divisions of the peaks tell no smaller p than that of one division in all
// that were drawn. Welch's test could, but is told alike.
std::string p_text(double p) {
  constexpr double smallest = 1.0 / (permutations.count + 1);
  return p <= smallest ? fmt::format("at most {:.2g}", smallest) : fmt::format("{:.2g}", p);
}

std::string comparison_text(const PeakComparison& comparison) {
  return fmt::format(
      "median {} times the experiment's, p {} of equal means by Welch, {} by "
      "Kolmogorov and Smirnov and {} by Anderson and Darling",
      median_ratio_text(comparison), p_text(comparison.mean_p.value), p_text(comparison.ks_p.value),
      p_text(comparison.ad_p.value));
}

}  // namespace slosh
