// The findings on pressures: against a record, between runs, at impacts, and of the two ways to
// make walls of boundary particles.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "verification/assessment/across_runs/impact_samples.hpp"
#include "verification/assessment/pressure_noise.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/gate/field_metrics.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/papers/claim_evidence.hpp"
#include "verification/papers/findings.hpp"
#include "verification/series/low_pass_filter.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

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

// Whether a run of a study finished. Throws where it was not started.
bool finished(const CaseAssessment& assessment, const std::string& run) {
  const auto status = assessment.runs.status.find(run);
  if (status != assessment.runs.status.end() && status->second.state == RunState::failed)
    return false;
  standing_result(assessment, run);
  return true;
}

struct StabilityOfWays {
  std::array<int, 2> finished{};
  std::array<double, 2> log_noise{}, crossings{};  // over the runs that finished both ways
  int pairs = 0;
};

StabilityOfWays stability(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  StabilityOfWays found;
  for (std::size_t pair = 0; pair + 1 < row.runs.size(); pair += 2) {
    std::array<bool, 2> done{};
    for (const std::size_t w : {0u, 1u}) {
      done[w] = finished(assessment, row.runs[pair + w]);
      found.finished[w] += done[w];
    }
    if (!done[0] || !done[1]) continue;
    ++found.pairs;
    for (const std::size_t w : {0u, 1u}) {
      const std::string& run = row.runs[pair + w];
      found.log_noise[w] +=
          std::log(plateau_noise(impact_pressure(cases, row, run), assessment.definition));
      found.crossings[w] += diagnostic_of(assessment, run, "wall_crossings");
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

// Of each impact log(peak) and time over period, by member; NaN where it does not occur.
struct ImpactsOfMembers {
  std::vector<std::vector<double>> log_peaks, times;
};

ImpactsOfMembers impacts_of_members(const Cases& cases, const FindingRow& row,
                                    const std::string& run) {
  const CaseDefinition& definition = case_named(cases, row.cases.at(0)).definition;
  const auto members = members_of(definition, run);
  if (members.size() < 2)
    throw std::runtime_error(run + " needs repeats, as each history is chaotic");
  ImpactsOfMembers found;
  for (const std::string& member : members) {
    const auto peaks = impacts_in(impact_pressure(cases, row, member), definition);
    found.log_peaks.resize(peaks.size());
    found.times.resize(peaks.size());
    for (std::size_t n = 0; n < peaks.size(); ++n) {
      found.log_peaks[n].push_back(peaks[n] ? std::log(peaks[n]->pressure) : not_a_number);
      found.times[n].push_back(peaks[n] ? peaks[n]->time / definition.impacts->period
                                        : not_a_number);
    }
  }
  return found;
}

// Returns sqrt(mean d_n^2) of the differences d_n of the means, and the half width that theirs
// give.
Estimate rms_change(const std::vector<std::vector<double>>& coarse,
                    const std::vector<std::vector<double>>& fine) {
  double squares = 0, spread = 0;
  for (std::size_t n = 0; n < coarse.size(); ++n) {
    const Estimate change = difference_of_members(coarse[n], fine[n], SingleSide::one_of_many);
    squares += change.value * change.value;
    spread += std::pow(change.value * change.half_width, 2);
  }
  const auto count = static_cast<double>(coarse.size());
  const double value = std::sqrt(squares / count);
  return {value, std::sqrt(spread) / (count * value)};
}

Estimate quotient(const Estimate& of, const Estimate& over) {
  const double value = of.value / over.value;
  return {value, value * std::hypot(of.half_width / of.value, over.half_width / over.value)};
}

// The mean over the case's moments of a number of the fields of a run against those of a mesh.
template <class Number>
double mean_over_moments(const CaseAssessment& assessment, const std::string& run,
                         const std::string& mesh, const Number& number) {
  const FieldComparison found = compare_fields(
      standing_result(assessment, run), standing_result(assessment, mesh), assessment.definition);
  double sum = 0;
  for (const FieldDifference& moment : found.moments) sum += number(moment);
  return sum / static_cast<double>(found.moments.size());
}

}  // namespace

namespace evidence {

Finding phase_against_record(const Cases& cases, const FindingRow& row) {
  const RecordedPressure found = recorded_pressure(cases, row);
  const ToneDifference tone = tone_difference(found.run, found.record, found.window,
                                              forcing_frequency(found.assessment.definition));
  Finding finding = judged({row.runs.at(0) + ": lag behind the record", 1, "deg"}, tone.lag_degrees,
                           row.thresholds.at(0));
  finding.text += fmt::format(", {:.2f} ± {:.2f} times its amplitude", tone.amplitude_ratio.value,
                              tone.amplitude_ratio.half_width);
  return finding;
}

Finding shape_against_record(const Cases& cases, const FindingRow& row) {
  const RecordedPressure found = recorded_pressure(cases, row);
  const HistoryDifference apart = difference(found.run, found.record, found.window);
  Finding finding = judged(
      {row.runs.at(0) + ": rms difference to the record, both freed of their means,", 100, "%"},
      {apart.without_means, 0}, row.thresholds.at(0));
  finding.text += fmt::format(", {:.0f} % as they are: the record lies {:+.0f} Pa off",
                              100 * apart.with_means, apart.offset);
  return finding;
}

Finding trend_against_record(const Cases& cases, const FindingRow& row) {
  const RecordedPressure found = recorded_pressure(cases, row);
  if (!found.assessment.definition.impacts)
    throw std::runtime_error("the case " + row.cases.at(0) + " has no [impacts]");
  const double cutoff = 10 / found.assessment.definition.impacts->period;
  const CommonSamples common = common_samples(
      low_pass(found.run, cutoff), cut_to_window(low_pass(found.record, cutoff), found.window));
  const auto one = without_mean(common.candidate), other = without_mean(common.reference);
  const double correlation = std::inner_product(one.begin(), one.end(), other.begin(), 0.0) /
                             (static_cast<double>(one.size()) * rms(one) * rms(other));
  return judged(
      {fmt::format("{}: correlation with the record below {:.2g} Hz", row.runs.at(0), cutoff), 1,
       ""},
      {correlation, 0}, row.thresholds.at(0));
}

Finding nearer_to_record(const Cases& cases, const FindingRow& row) {
  const auto distance = [&](const std::string& run) {
    FindingRow pair = row;
    pair.runs = {run, row.runs.at(2)};
    const RecordedPressure found = recorded_pressure(cases, pair);
    return difference(found.run, found.record, found.window).without_means;
  };
  return judged({fmt::format("difference to the record, both freed of their means, of {} over that "
                             "of {}",
                             row.runs.at(1), row.runs.at(0)),
                 1, ""},
                {distance(row.runs.at(1)) / distance(row.runs.at(0)), 0}, row.thresholds.at(0));
}

Finding difference_of_runs(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  const RunResult& one = standing_result(assessment, row.runs.at(0));
  const RunResult& other = standing_result(assessment, row.runs.at(1));
  const double cutoff = filtered_gauge(assessment.definition).second;
  const HistoryDifference apart =
      difference(low_pass(one.at(row.quantity), cutoff), low_pass(other.at(row.quantity), cutoff),
                 comparison_window(assessment.definition));
  return judged({fmt::format("{} against {}: rms difference of {}", row.runs.at(0), row.runs.at(1),
                             row.quantity + through_filter),
                 100, "%"},
                {apart.with_means, 0}, row.thresholds.at(0));
}

Finding difference_of_fields(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  const auto apart = [&](const std::string& run) {
    return mean_over_moments(assessment, run, row.runs.at(2),
                             [](const FieldDifference& one) { return one.pressure_rms; }) /
           pressure_under_depth(assessment.definition);
  };
  const double one = apart(row.runs.at(0)), other = apart(row.runs.at(1));
  const double least = std::abs(one - other), most = one + other;
  return judged({fmt::format("pressure fields of {} and {} by way of {}: rms difference over the "
                             "pressure under the depth",
                             row.runs.at(0), row.runs.at(1), row.runs.at(2)),
                 100, "%"},
                {(least + most) / 2, (most - least) / 2}, row.thresholds.at(0));
}

Finding surface_against_mesh(const Cases& cases, const FindingRow& row) {
  const CaseAssessment& assessment = case_named(cases, row.cases.at(0));
  const double share = mean_over_moments(
      assessment, row.runs.at(0), row.runs.at(1),
      [](const FieldDifference& one) { return one.uncovered_share + one.excess_share; });
  return judged({fmt::format("{}: cells that it or {} alone fills", row.runs.at(0), row.runs.at(1)),
                 100, "% of the liquid's"},
                {share, 0}, row.thresholds.at(0));
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
  return judged({row.runs.at(0) + ": plateau against the published one", 100, "%"},
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
    return static_cast<int>(row.runs.size() / 2) - found.finished[w];
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
      row.runs.size() / 2, found.finished[1], found.finished[0], found.pairs, noise,
      found.crossings[1], found.crossings[0]);
  if (better && worse) text += ": they contradict one another";
  if (!better && !worse) text += ": nothing tells the two apart";
  return {better == worse ? Held::undecided : better ? Held::yes : Held::no, text};
}

Finding fixed_changes_less(const Cases& cases, const FindingRow& row) {
  const auto of = [&](std::size_t i) { return impacts_of_members(cases, row, row.runs.at(i)); };
  const ImpactsOfMembers coarse[]{of(0), of(2)}, fine[]{of(1), of(3)};
  const auto ratio_of = [&](std::vector<std::vector<double>> ImpactsOfMembers::*what) {
    return quotient(rms_change(coarse[0].*what, fine[0].*what),
                    rms_change(coarse[1].*what, fine[1].*what));
  };
  const std::string name =
      fmt::format("change of the {{}} from {} to {} over that from {} to {}", row.runs.at(0),
                  row.runs.at(1), row.runs.at(2), row.runs.at(3));
  const auto part = [&](const char* what, const Estimate& estimate) {
    return judged({fmt::format(fmt::runtime(name), what), 1, ""}, estimate, row.thresholds.at(0));
  };
  const Finding peaks = part("peaks", ratio_of(&ImpactsOfMembers::log_peaks)),
                times = part("times", ratio_of(&ImpactsOfMembers::times));
  return {both(peaks.held, times.held), peaks.text + "; " + times.text};
}

}  // namespace evidence
}  // namespace slosh
