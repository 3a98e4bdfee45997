// The findings on pressures: against a record, between runs, at impacts, and of the two ways to
// make walls of boundary particles.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "verification/assessment/across_runs/impact_samples.hpp"
#include "verification/assessment/pressure_noise.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/papers/claim_evidence.hpp"
#include "verification/papers/findings.hpp"
#include "verification/series/low_pass_filter.hpp"

namespace slosh {
namespace {

using Cases = std::vector<CaseAssessment>;

// Returns the series that the record is of, filtered where the run has it filtered, as the record
// is smooth.
const TimeSeries& like_the_record(const RunResult& result, const std::string& quantity) {
  for (const TimeSeries& series : result.series)
    if (series.name == quantity + through_filter) return series;
  return result.at(quantity);
}

struct RecordedPressure {
  const CaseAssessment& assessment;
  const TimeSeries& record;
  const TimeSeries& run;
  TimeWindow window;  // the part of the comparison window that the record covers
};

RecordedPressure recorded_pressure(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  const std::string& record_run = row.runs.at(1);
  const RunResult& measured = standing_result(assessment, record_run);
  const auto& definition = std::get<RecordRun>(run_named(assessment.definition, record_run).solver);
  TimeWindow window = comparison_window(assessment.definition);
  const TimeSeries& record = measured.at(definition.quantity);
  window.begin = std::max(window.begin, record.time.front());
  window.end = std::min(window.end, record.time.back());
  return {assessment, record,
          like_the_record(standing_result(assessment, row.runs.at(0)), definition.quantity),
          window};
}

// Returns any series of the run, through the filter of the case's pressure gauge.
TimeSeries filtered(const RunResult& result, const std::string& quantity, double cutoff) {
  return is_filtered(quantity) ? result.at(quantity) : low_pass(result.at(quantity), cutoff);
}

const TimeSeries& impact_pressure(const Cases& cases, const FindingRow& row,
                                  const std::string& run) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  const RunResult& result = standing_result(assessment, run);
  if (!assessment.definition.impacts)
    throw std::runtime_error("the case " + row.cases.at(0) + " has no [impacts]");
  return result.at(wall_pressure(assessment.definition.impacts->gauge));
}

bool is_among_repeats(const CaseDefinition& definition, std::size_t impact, double peak,
                      const FindingRow& row) {
  const ImpactsDefinition& published = *definition.impacts;
  if (published.repeats.empty())
    return std::abs(peak - published.peak_means[impact]) <=
           row.thresholds.at(1).upper * published.peak_deviations[impact];
  return compare(repeated_peaks(definition, impact).percentile(peak), row.thresholds.at(0)) ==
         Held::yes;
}

const std::array<std::string, 2> ways{"moving", "fixed"};

// Whether a run of a study finished. Throws where it was not started.
bool finished(const CaseAssessment& assessment, const std::string& run) {
  const auto status = assessment.runs.status.find(run);
  if (status != assessment.runs.status.end() && status->second.state == RunState::failed)
    return false;
  standing_result(assessment, run);
  return true;
}

double crossings(const CaseAssessment& assessment, const std::string& run) {
  const RunResult& result = standing_result(assessment, run);
  const auto found = result.diagnostics.find("wall_crossings");
  if (found == result.diagnostics.end() || !std::isfinite(found->second))
    throw std::runtime_error(run + " of " + assessment.definition.name +
                             " counted no wall crossings");
  return found->second;
}

struct StabilityOfWays {
  std::array<int, 2> finished{};
  std::array<double, 2> log_noise{}, crossings{};  // over the runs that finished both ways
  int pairs = 0;
};

StabilityOfWays stability(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  StabilityOfWays found;
  for (const std::string& study : row.runs) {
    std::array<bool, 2> done{};
    for (const std::size_t w : {0u, 1u}) {
      done[w] = finished(assessment, ways[w] + "_" + study);
      found.finished[w] += done[w];
    }
    if (!done[0] || !done[1]) continue;
    ++found.pairs;
    for (const std::size_t w : {0u, 1u}) {
      const std::string run = ways[w] + "_" + study;
      found.log_noise[w] +=
          std::log(plateau_noise(impact_pressure(cases, row, run), assessment.definition));
      found.crossings[w] += crossings(assessment, run);
    }
  }
  return found;
}

// Refuted where the others are clearly smaller; undecided in between.
Held clearly_smaller(double ours, double others, const Threshold& ratio) {
  if (ours <= ratio.upper * others && ours < others) return Held::yes;
  return others <= ratio.upper * ours && others < ours ? Held::no : Held::undecided;
}

// Counts also scatter, at least as those of independent events do: the standard deviation of the
// difference of two Poisson counts is the root of their sum. With the correction for whole numbers
// the rule agrees with the exact binomial test for few events: 5 against 0 is chance, 6 is not.
Held clearly_fewer(double ours, double others, const Threshold& ratio) {
  const bool is_scatter = std::abs(ours - others) - 1 <= 1.96 * std::sqrt(ours + others);
  return is_scatter ? Held::undecided : clearly_smaller(ours, others, ratio);
}

// Returns the mean rms difference of the coarser runs made in one way to the last, finest one.
double spread(const CaseAssessment& assessment, const std::string& way, const FindingRow& row) {
  const std::string quantity = filtered_gauge(assessment.definition).first;
  const std::string finest_run = way + "_" + row.runs.back();
  const TimeSeries& best = standing_result(assessment, finest_run).at(quantity);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < row.runs.size(); ++i)
    sum += difference(standing_result(assessment, way + "_" + row.runs.at(i)).at(quantity), best,
                      comparison_window(assessment.definition))
               .with_means;
  return sum / static_cast<double>(row.runs.size() - 1);
}

}  // namespace

namespace evidence {

Finding phase_against_record(const Cases& cases, const FindingRow& row) {
  const RecordedPressure found = recorded_pressure(cases, row);
  const ToneDifference tone = tone_difference(found.run, found.record, found.window,
                                              forcing_frequency(found.assessment.definition));
  Finding finding = within({row.runs.at(0) + ": lag behind the record", 1, "deg"}, tone.lag_degrees,
                           row.thresholds.at(0));
  finding.text += fmt::format(", {:.2f} ± {:.2f} times its amplitude", tone.amplitude_ratio.value,
                              tone.amplitude_ratio.half_width);
  return finding;
}

Finding shape_against_record(const Cases& cases, const FindingRow& row) {
  const RecordedPressure found = recorded_pressure(cases, row);
  const HistoryDifference apart = difference(found.run, found.record, found.window);
  Finding finding = within(
      {row.runs.at(0) + ": rms difference to the record, both freed of their means,", 100, "%"},
      {apart.without_means, 0}, row.thresholds.at(0));
  finding.text += fmt::format(", {:.0f} % as they are: the record lies {:+.0f} Pa off",
                              100 * apart.with_means, apart.offset);
  return finding;
}

Finding difference_of_runs(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  const RunResult& one = standing_result(assessment, row.runs.at(0));
  const RunResult& other = standing_result(assessment, row.runs.at(1));
  const auto [pressure, cutoff] = filtered_gauge(assessment.definition);
  const bool of_pressure = row.quantity == "wall_pressure";
  const std::string quantity = of_pressure ? pressure : row.quantity;
  const HistoryDifference apart =
      difference(filtered(one, quantity, cutoff), filtered(other, quantity, cutoff),
                 comparison_window(assessment.definition));
  return within({fmt::format("{} against {}: rms difference of {}", row.runs.at(0), row.runs.at(1),
                             of_pressure ? quantity : quantity + through_filter),
                 100, "%"},
                {apart.with_means, 0}, row.thresholds.at(0));
}

Finding impact_times(const Cases& cases, const FindingRow& row) {
  const TimeSeries& pressure = impact_pressure(cases, row, row.runs.at(0));
  const CaseDefinition& definition = case_named(cases, row.cases.at(0)).definition;
  const ImpactsDefinition& published = *definition.impacts;
  const auto peaks = impacts_in(pressure, definition);
  const double allowed = row.thresholds.at(0).upper * published.period;
  std::vector<std::string> texts;
  bool all = true;
  for (std::size_t n = 0; n < peaks.size(); ++n) {
    const double late = peaks[n] ? peaks[n]->time - published.times[n] : NAN;
    texts.push_back(peaks[n] ? fmt::format("{:+.3f}", late) : "none");
    all = all && std::abs(late) <= allowed;
  }
  return {all ? Held::yes : Held::no, fmt::format("{}: impacts late by {} s (at most {:.3f})",
                                                  row.runs.at(0), fmt::join(texts, ", "), allowed)};
}

Finding plateau_against_published(const Cases& cases, const FindingRow& row) {
  const TimeSeries& pressure = impact_pressure(cases, row, row.runs.at(0));
  return within({row.runs.at(0) + ": plateau against the published one", 100, "%"},
                {plateau_error(pressure, case_named(cases, row.cases.at(0)).definition), 0},
                row.thresholds.at(0));
}

Finding peaks_among_repeats(const Cases& cases, const FindingRow& row) {
  const TimeSeries& pressure = impact_pressure(cases, row, row.runs.at(0));
  const CaseDefinition& definition = case_named(cases, row.cases.at(0)).definition;
  const auto peaks = impacts_in(pressure, definition);
  std::vector<std::string> texts;
  int missed = 0;
  for (std::size_t n = 0; n < peaks.size(); ++n) {
    texts.push_back(peaks[n] ? place_among_repeats(definition, n, peaks[n]->pressure) : "none");
    missed += !(peaks[n] && is_among_repeats(definition, n, peaks[n]->pressure, row));
  }
  const Threshold &percentiles = row.thresholds.at(0), &deviations = row.thresholds.at(1),
                  &outside = row.thresholds.at(2);
  return {compare(missed, outside),
          fmt::format("{}: peaks at {} of the repeats ({} to {} % or within {} sd; all but {})",
                      row.runs.at(0), fmt::join(texts, ", "), percentiles.lower, percentiles.upper,
                      deviations.upper, outside.upper)};
}

// The fixed particles must be better in one of three measures and worse in none.
Finding fixed_more_stable(const Cases& cases, const FindingRow& row) {
  const StabilityOfWays found = stability(cases, row);
  const double noise =
      found.pairs ? std::exp((found.log_noise[1] - found.log_noise[0]) / found.pairs) : NAN;
  const auto failed = [&](std::size_t w) {
    return static_cast<int>(row.runs.size()) - found.finished[w];
  };
  std::vector<Held> parts{
      failed(1) < failed(0)   ? Held::yes
      : failed(1) > failed(0) ? Held::no
                              : Held::undecided,
      clearly_smaller(noise, 1, row.thresholds.at(0)),
      clearly_fewer(found.crossings[1], found.crossings[0], row.thresholds.at(0))};
  const bool better = std::count(parts.begin(), parts.end(), Held::yes) > 0;
  const bool worse = std::count(parts.begin(), parts.end(), Held::no) > 0;
  std::string text = fmt::format(
      "of {} runs each {} of the fixed and {} of the moving finished; over the {} that both "
      "finished the fixed have {:.3g} times the noise of the moving on the plateaus and {:.0f} "
      "wall crossings against {:.0f} (better in one, worse in none; a difference counts from a "
      "fifth on, and that of the crossings must also exceed their scatter)",
      row.runs.size(), found.finished[1], found.finished[0], found.pairs, noise, found.crossings[1],
      found.crossings[0]);
  if (better && worse) text += ": they contradict one another";
  if (!better && !worse) text += ": nothing tells the two apart";
  return {better == worse ? Held::undecided : better ? Held::yes : Held::no, text};
}

Finding fixed_converges_better(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  const double moving = spread(assessment, "moving", row);
  const double fixed = spread(assessment, "fixed", row);
  const Held held = clearly_smaller(fixed, moving, row.thresholds.at(0));
  return {held,
          fmt::format("{}: rms difference of the filtered pressure to {} {:.0f} % fixed, "
                      "{:.0f} % moving (at most {} times as much){}",
                      row.name, row.runs.back(), 100 * fixed, 100 * moving,
                      row.thresholds.at(0).upper, held == Held::undecided ? ": equal or NaN" : "")};
}

}  // namespace evidence
}  // namespace slosh
