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
#include "verification/papers/claims.hpp"
#include "verification/papers/measured_values.hpp"
#include "verification/series/low_pass_filter.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

// Of a run the series that the record is of, filtered where the run has it filtered, as the record
// is smooth; and the part of the comparison window that the record covers.
struct RecordedPressure {
  const TimeSeries &record, &run;
  TimeWindow window;
};

RecordedPressure recorded_pressure(const Question& on, std::size_t run, std::size_t record_run) {
  const RunResult &measured = on.result(record_run), &result = on.result(run);
  const auto& definition =
      std::get<RecordRun>(run_named(on.definition(), on.run(record_run)).solver);
  const TimeSeries& record = measured.at(definition.quantity);
  const auto filtered =
      std::find_if(result.series.begin(), result.series.end(), [&](const TimeSeries& series) {
        return series.name == definition.quantity + through_filter;
      });
  const TimeWindow window = comparison_window(on.definition());
  return {record,
          filtered != result.series.end() ? *filtered : result.at(definition.quantity),
          {std::max(window.begin, record.time.front()), std::min(window.end, record.time.back())}};
}

// The three that follow: the pressure of the first run against the record, the second one. The lag
// of the forced tone. Threshold: range of the lag [deg].
Finding phase_against_record(const Question& on) {
  const auto [record, run, window] = recorded_pressure(on, 0, 1);
  const ToneDifference tone =
      tone_difference(run, record, window, forcing_frequency(on.definition()));
  Finding finding = on.judge("{0}: lag behind the record", 1, "deg", tone.lag_degrees);
  finding.text += fmt::format(", {:.2f} ± {:.2f} times its amplitude", tone.amplitude_ratio.value,
                              tone.amplitude_ratio.half_width);
  return finding;
}

// The rms difference of the two without their means. Threshold: range of the difference.
Finding shape_against_record(const Question& on) {
  const auto [record, run, window] = recorded_pressure(on, 0, 1);
  const HistoryDifference apart = difference(run, record, window);
  Finding finding = on.judge("{0}: rms difference to the record, both freed of their means,", 100,
                             "%", {apart.without_means, 0});
  finding.text += fmt::format(", {:.0f} % as they are: the record lies {:+.0f} Pa off",
                              100 * apart.with_means, apart.offset);
  return finding;
}

const ImpactsDefinition& impacts_of(const CaseDefinition& definition) {
  if (!definition.impacts)
    throw std::runtime_error("the case " + definition.name + " has no [impacts]");
  return *definition.impacts;
}

// The correlation of what is slower than a tenth of the impacts' period. Threshold: that of it.
Finding trend_against_record(const Question& on) {
  const auto [record, run, window] = recorded_pressure(on, 0, 1);
  const double cutoff = 10 / impacts_of(on.definition()).period;
  const CommonSamples common =
      common_samples(low_pass(run, cutoff), cut_to_window(low_pass(record, cutoff), window));
  const auto one = without_mean(common.candidate), other = without_mean(common.reference);
  const double correlation = std::inner_product(one.begin(), one.end(), other.begin(), 0.0) /
                             (static_cast<double>(one.size()) * rms(one) * rms(other));
  return on.judge(fmt::format("{{0}}: correlation with the record below {:.2g} Hz", cutoff), 1, "",
                  {correlation, 0});
}

// The difference of shape to the record, the third run, of the second run over that of the first.
// Threshold: that of the quotient.
Finding nearer_to_record(const Question& on) {
  const auto distance = [&](std::size_t i) {
    const auto [record, run, window] = recorded_pressure(on, i, 2);
    return difference(run, record, window).without_means;
  };
  return on.judge("difference to the record, both freed of their means, of {1} over that of {0}", 1,
                  "", {distance(1) / distance(0), 0});
}

// The rms difference of `quantity` between two runs, filtered as the case's pressure. Threshold:
// range of the difference.
Finding difference_of_runs(const Question& on) {
  const double cutoff = filtered_gauge(on.definition()).second;
  const auto filtered = [&](std::size_t i) {
    return low_pass(on.result(i).at(on.row.quantity), cutoff);
  };
  const TimeSeries one = filtered(0), other = filtered(1);
  return on.judge("{0} against {1}: rms difference of " + on.row.quantity + through_filter, 100,
                  "%", {difference(one, other, comparison_window(on.definition())).with_means, 0});
}

// The mean over the case's moments of a number of the fields of a run against those of a mesh.
template <class Number>
double mean_over_moments(const Question& on, std::size_t run, std::size_t mesh,
                         const Number& number) {
  const FieldComparison found = compare_fields(on.result(run), on.result(mesh), on.definition());
  double sum = 0;
  for (const FieldDifference& moment : found.moments) sum += number(moment);
  return sum / static_cast<double>(found.moments.size());
}

// The pressure fields of two runs by their rms differences a and b to the finest interFoam run, the
// third one, which is not the truth here, only a common mesh: their own difference is between
// |a - b| and a + b. In units of density g depth, the mean over the snapshot times. Threshold: that
// of the difference.
Finding difference_of_fields(const Question& on) {
  const auto apart = [&](std::size_t run) {
    return mean_over_moments(on, run, 2,
                             [](const FieldDifference& one) { return one.pressure_rms; }) /
           pressure_under_depth(on.definition());
  };
  const double one = apart(0), other = apart(1);
  const double least = std::abs(one - other), most = one + other;
  return on.judge(
      "pressure fields of {0} and {1} by way of {2}: rms difference over the pressure under the "
      "depth",
      100, "%", {(least + most) / 2, (most - least) / 2});
}

// The cells at the snapshot times that only one of the runs fills, the first and the interFoam run,
// the second, over the liquid's cells. Threshold: that of the share.
Finding surface_against_mesh(const Question& on) {
  const double share = mean_over_moments(
      on, 0, 1, [](const FieldDifference& one) { return one.uncovered_share + one.excess_share; });
  return on.judge("{0}: cells that it or {1} alone fills", 100, "% of the liquid's", {share, 0});
}

const TimeSeries& impact_pressure(const Question& on, const std::string& run) {
  return standing_result(on.first, run).at(wall_pressure(impacts_of(on.definition()).gauge));
}

// The three that follow: the impacts of the first run against the published ones. Threshold:
// largest delay over the period.
Finding impact_times(const Question& on) {
  const auto peaks = impacts_in(impact_pressure(on, on.run(0)), on.definition());
  const ImpactsDefinition& published = *on.definition().impacts;
  const double allowed = on.threshold().upper * published.period;
  std::vector<std::string> texts;
  bool all = true;
  for (std::size_t n = 0; n < peaks.size(); ++n) {
    const double late = peaks[n] ? peaks[n]->time - published.times[n] : NAN;
    texts.push_back(peaks[n] ? fmt::format("{:+.3f}", late) : "none");
    all = all && std::abs(late) <= allowed;
  }
  return {all ? Held::yes : Held::no, fmt::format("{}: impacts late by {} s (at most {:.3f})",
                                                  on.run(0), fmt::join(texts, ", "), allowed)};
}

// Threshold: range of the plateau's relative error.
Finding plateau_against_published(const Question& on) {
  return on.judge("{0}: plateau against the published one", 100, "%",
                  {plateau_error(impact_pressure(on, on.run(0)), on.definition()), 0});
}

// Thresholds: range of a peak's percentile among the repeats [%], its range in their standard
// deviations where the table of the repeats is not supplied, largest number of peaks outside.
Finding peaks_among_repeats(const Question& on) {
  const auto peaks = impacts_in(impact_pressure(on, on.run(0)), on.definition());
  const ImpactsDefinition& published = *on.definition().impacts;
  const Threshold &percentiles = on.threshold(0), &deviations = on.threshold(1),
                  &outside = on.threshold(2);
  const auto is_among = [&](std::size_t n, double peak) {
    return published.repeats.empty() ? std::abs(peak - published.peak_means[n]) <=
                                           deviations.upper * published.peak_deviations[n]
                                     : compare(repeated_peaks(on.definition(), n).percentile(peak),
                                               percentiles) == Held::yes;
  };
  std::vector<std::string> texts;
  int missed = 0;
  for (std::size_t n = 0; n < peaks.size(); ++n) {
    texts.push_back(peaks[n] ? place_among_repeats(on.definition(), n, peaks[n]->pressure)
                             : "none");
    missed += !(peaks[n] && is_among(n, peaks[n]->pressure));
  }
  return {compare(missed, outside),
          fmt::format("{}: peaks at {} of the repeats ({} to {} % or within {} sd; all but {})",
                      on.run(0), fmt::join(texts, ", "), percentiles.lower, percentiles.upper,
                      deviations.upper, outside.upper)};
}

// Whether a run of a study finished. Throws where it was not started.
bool finished(const CaseAssessment& assessment, const std::string& run) {
  const auto status = assessment.runs.status.find(run);
  if (status != assessment.runs.status.end() && status->second.state == RunState::failed)
    return false;
  standing_result(assessment, run);
  return true;
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

// Fixed against moving boundary particles; runs are pairs, first the moving then the fixed: the
// runs that finish, and of those that finish both ways the noise on the plateau and the wall
// crossings. The fixed must be better in one of three and worse in none. Threshold: largest ratio
// of fixed to moving that counts as smaller.
Finding fixed_more_stable(const Question& on) {
  std::array<int, 2> failed{};
  std::array<double, 2> log_noise{}, crossings{};
  const int all = static_cast<int>(on.row.runs.size() / 2);
  int pairs = 0;
  for (std::size_t pair = 0; pair + 1 < on.row.runs.size(); pair += 2) {
    std::array<bool, 2> done{};
    for (const std::size_t w : {0u, 1u})
      failed[w] += !(done[w] = finished(on.first, on.run(pair + w)));
    if (!done[0] || !done[1]) continue;
    ++pairs;
    for (const std::size_t w : {0u, 1u}) {
      const std::string& run = on.run(pair + w);
      log_noise[w] += std::log(plateau_noise(impact_pressure(on, run), on.definition()));
      crossings[w] += diagnostic_of(on.first, run, "wall_crossings");
    }
  }
  const double noise = pairs ? std::exp((log_noise[1] - log_noise[0]) / pairs) : NAN;
  const Held parts[]{failed[1] < failed[0]   ? Held::yes
                     : failed[1] > failed[0] ? Held::no
                                             : Held::undecided,
                     clearly_smaller(noise, 1, on.threshold()),
                     clearly_fewer(crossings[1], crossings[0], on.threshold())};
  const bool better = std::count(std::begin(parts), std::end(parts), Held::yes) > 0;
  const bool worse = std::count(std::begin(parts), std::end(parts), Held::no) > 0;
  std::string text = fmt::format(
      "of {} runs each {} of the fixed and {} of the moving finished; over the {} that both "
      "finished the fixed have {:.3g} times the noise of the moving on the plateaus and {:.0f} "
      "wall crossings against {:.0f} (better in one, worse in none; a difference counts from a "
      "fifth on, and that of the crossings must also exceed their scatter)",
      all, all - failed[1], all - failed[0], pairs, noise, crossings[1], crossings[0]);
  if (better && worse) text += ": they contradict one another";
  if (!better && !worse) text += ": nothing tells the two apart";
  return {better == worse ? Held::undecided : better ? Held::yes : Held::no, text};
}

// Of each impact log(peak) and time over period, by member; NaN where it does not occur.
struct ImpactsOfMembers {
  std::vector<std::vector<double>> log_peaks, times;
};

ImpactsOfMembers impacts_of_members(const Question& on, const std::string& run) {
  const CaseDefinition& definition = on.definition();
  const auto members = members_of(definition, run);
  if (members.size() < 2)
    throw std::runtime_error(run + " needs repeats, as each history is chaotic");
  ImpactsOfMembers found;
  for (const std::string& member : members) {
    const auto peaks = impacts_in(impact_pressure(on, member), definition);
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

// The change of the impacts from a coarse to a fine spacing: the rms over the impacts of the
// difference of ensemble means of log(peak), and of the time over the period. Runs: moving coarse,
// moving fine, fixed coarse, fixed fine, each an ensemble. Threshold: that of the moving change
// over the fixed one, for peaks and for times alike.
Finding fixed_changes_less(const Question& on) {
  const auto of = [&](std::size_t i) { return impacts_of_members(on, on.run(i)); };
  const ImpactsOfMembers coarse[]{of(0), of(2)}, fine[]{of(1), of(3)};
  const auto part = [&](const char* what, auto member) {
    const Estimate moving = rms_change(coarse[0].*member, fine[0].*member),
                   fixed = rms_change(coarse[1].*member, fine[1].*member);
    const double value = moving.value / fixed.value;
    const double relative =
        std::hypot(moving.half_width / moving.value, fixed.half_width / fixed.value);
    return on.judge(
        fmt::format("change of the {} from {{0}} to {{1}} over that from {{2}} to {{3}}", what), 1,
        "", {value, value * relative});
  };
  const Finding peaks = part("peaks", &ImpactsOfMembers::log_peaks),
                times = part("times", &ImpactsOfMembers::times);
  return {both(peaks.held, times.held), peaks.text + "; " + times.text};
}

}  // namespace

const std::map<std::string, Evidence>& pressure_findings() {
  static const std::map<std::string, Evidence> all{
      {"phase_against_record", phase_against_record},
      {"shape_against_record", shape_against_record},
      {"trend_against_record", trend_against_record},
      {"nearer_to_record", nearer_to_record},
      {"difference_of_runs", difference_of_runs},
      {"difference_of_fields", difference_of_fields},
      {"surface_against_mesh", surface_against_mesh},
      {"impact_times", impact_times},
      {"plateau_against_published", plateau_against_published},
      {"peaks_among_repeats", peaks_among_repeats},
      {"fixed_more_stable", fixed_more_stable},
      {"fixed_changes_less", fixed_changes_less}};
  return all;
}

}  // namespace slosh
