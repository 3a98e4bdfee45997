#include "verification/gate/measured_value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "verification/case/metric_table.hpp"
#include "verification/case/quantities.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/metrics/ensemble_mean.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

const ModeComparison& mode_of(const Comparison& comparison, const std::string& mode) {
  const auto found = std::find_if(comparison.modes.begin(), comparison.modes.end(),
                                  [&](const ModeComparison& one) { return one.mode == mode; });
  if (found == comparison.modes.end())
    throw ComparisonError("the mode " + mode + " was not fitted");
  for (const Tone* tone : {&found->candidate, &found->reference})
    if (!tone->resolved)
      throw ComparisonError(
          fmt::format("the {}'s mode {} cannot be resolved; expected a longer window, or "
                      "natural_modes = 0",
                      tone == &found->candidate ? "candidate" : "reference", mode));
  if (found->beside)
    throw ComparisonError(
        fmt::format("the window of {:.4g} s cannot separate the mode {} from a component at {:.4g} "
                    "Hz; expected a longer window, or natural_modes = 0",
                    comparison.window.end - comparison.window.begin, mode,
                    *found->beside / (2 * std::numbers::pi)));
  return *found;
}

// A reference that does not decay, such as potential flow, has no decay rate to divide by.
Estimate decay_error_of(const ModeComparison& mode) {
  if (!(mode.reference.decay_rate.value > mode.reference.decay_rate.half_width))
    throw ComparisonError("the reference's mode " + mode.mode +
                          " does not decay; expected a viscous one, or the metric decay_rate");
  return mode.decay_error;
}

// Which of peaks of nearly the same power is the highest is chance: the interval holds them all.
// Nine tenths are a convention.
Estimate spectral_peak_error(const Comparison& comparison) {
  constexpr double nearly = 0.9;
  const std::vector<SpectralPeak>&candidates = comparison.candidate_peaks,
        &references = comparison.reference_peaks;
  if (candidates.empty() || references.empty())
    throw ComparisonError("one of the spectra has no peak");
  Estimate error{candidates.front().frequency / references.front().frequency - 1, 0};
  for (const SpectralPeak& one : candidates)
    for (const SpectralPeak& other : references)
      if (one.power >= nearly * candidates.front().power &&
          other.power >= nearly * references.front().power)
        error.half_width =
            std::max(error.half_width, std::abs(one.frequency / other.frequency - 1 - error.value));
  return error;
}

// The metric holds for the window alone, like normalised_rms.
Estimate band_value(const Comparison& comparison) {
  if (!comparison.margin)
    throw ComparisonError(
        fmt::format("{} has no band for {}; expected a record with lower_column "
                    "and upper_column",
                    comparison.reference, comparison.quantity));
  return {share_outside(*comparison.margin, comparison.window), 0};
}

Estimate metric_value(Metric metric, const std::string& mode, const Comparison& comparison) {
  if (comparison.reference_is_constant && metric != Metric::mean_offset)
    throw ComparisonError(fmt::format(
        "the reference {} is constant from {} s to {} s; {} needs one that varies",
        comparison.reference, comparison.window.begin, comparison.window.end, metric_name(metric)));
  switch (metric) {
    case Metric::amplitude_error:
      return mode_of(comparison, mode).amplitude_error;
    case Metric::phase_lag:
      return mode_of(comparison, mode).phase_lag_degrees;
    case Metric::frequency_error:
      return mode_of(comparison, mode).frequency_error;
    case Metric::decay_rate:
      return mode_of(comparison, mode).decay_rate;
    case Metric::decay_error:
      return decay_error_of(mode_of(comparison, mode));
    case Metric::normalised_rms:
      // The gate judges the declared window, all of whose samples are known; the interval would
      // describe other windows.
      return {comparison.normalised_rms.value, 0};
    case Metric::aligned_rms:
      return {comparison.alignment.normalised_rms, 0};
    case Metric::cross_correlation_lag:
      return {comparison.cross_correlation_lag_degrees, 0};
    case Metric::spectral_peak_error:
      return spectral_peak_error(comparison);
    case Metric::rms_error:
      return {comparison.candidate_wave.deviation / comparison.reference_wave.deviation - 1, 0};
    case Metric::mean_offset:
      return {comparison.candidate_wave.mean - comparison.reference_wave.mean, 0};
    case Metric::largest_magnitude:
    case Metric::noise_share:
    case Metric::initial_value:
    case Metric::frequency:
    case Metric::plateau_error:
    case Metric::impact_arrival:
    case Metric::impact_peak_error:
    case Metric::impulse_error:
    case Metric::peak_mean_p_value:
    case Metric::peak_ks_p_value:
    case Metric::peak_ad_p_value:
    case Metric::peak_median_error:
    case Metric::outside_band:
    case Metric::pressure_field_rms:
    case Metric::pressure_field_tension:
    case Metric::cost_to_reach:
      break;  // measured_once() measures these without a comparison
  }
  throw std::logic_error("a comparison has no value of " + metric_name(metric));
}

// The interval is symmetric in the logarithm; its upper, wider half counts. The errors' intervals
// do not, as they describe other windows than the declared one.
Estimate cost_value(const CostAtError& found) {
  if (found.reach == Reach::not_at_all) return no_value;
  return {found.cost, found.cost * std::expm1(found.cost_spread)};
}

// Whether the largest sample is more than twice one of its neighbours: such a peak lasts for about
// a sample, and none of them need be at its top.
bool is_sharp(const std::vector<double>& value) {
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto i = std::max_element(value.begin(), value.end(), larger) - value.begin();
  if (i == 0 || i + 1 == std::ssize(value)) return false;
  const auto at = [&](std::ptrdiff_t k) { return std::abs(value[static_cast<std::size_t>(k)]); };
  return std::min(at(i - 1), at(i + 1)) < at(i) / 2;
}

// Returns by how much the crest may exceed the largest sample: a parabola through this sample and
// its neighbours exceeds it by no more than an eighth of their second difference.
double above_largest(const std::vector<double>& value) {
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto i = static_cast<std::size_t>(std::max_element(value.begin(), value.end(), larger) -
                                          value.begin());
  return i == 0 || i + 1 >= value.size() ? 0
                                         : std::abs(value[i - 1] - 2 * value[i] + value[i + 1]) / 8;
}

// Throws ComparisonError where no sample lies within an interval of the start.
double initial_value(const TimeSeries& series, double interval) {
  const auto nearest =
      std::min_element(series.time.begin(), series.time.end(),
                       [](double a, double b) { return std::abs(a) < std::abs(b); });
  const double at = nearest == series.time.end() ? no_value.value : *nearest;
  if (!(std::abs(at) <= 1.001 * interval))
    throw ComparisonError(fmt::format(
        "the sample of {} nearest to the start is at {:.4g} s; expected one within {:g} s "
        "of 0 s, where initial_value is measured",
        series.name, at, interval));
  return series.value.at(static_cast<std::size_t>(nearest - series.time.begin()));
}

void require_unit(const GateRow& row, const std::string& quantity_unit) {
  const std::string unit = metric_unit(row.metric, quantity_unit);
  if (unit == row.unit) return;
  throw ComparisonError(
      fmt::format("{} is in {}, the row's limit in {}", metric_name(row.metric), unit, row.unit));
}

// A run that is compared with itself has its own modes.
Estimate frequency(const GateRow& row, const GateEvidence& evidence) {
  require_unit(row, "");
  const Comparison& itself = evidence.comparison(row.candidate, row.candidate, row.quantity);
  constexpr double turn = 2 * std::numbers::pi;
  const Estimate& found = mode_of(itself, row.mode).candidate.angular_frequency;
  return {found.value / turn, found.half_width / turn};
}

// The series over the window is requested first in any case: a series that is unusable there is
// refused for initial_value too.
double candidate_alone(const GateRow& row, const GateEvidence& evidence) {
  const TimeSeries series = evidence.series(row.candidate, row.quantity);
  require_unit(row, series.unit);
  if (row.metric == Metric::noise_share) return noise_share(series);
  if (row.metric == Metric::largest_magnitude) return largest_of(series).magnitude;
  if (row.metric == Metric::initial_value)
    return initial_value(evidence.history(row.candidate, row.quantity), evidence.sample_interval);
  throw std::logic_error("the candidate alone has no value of " + metric_name(row.metric));
}

Estimate measured_once(const GateRow& row, const GateEvidence& evidence) {
  if (row.metric == Metric::frequency) return frequency(row, evidence);
  if (is_of_candidate_alone(row.metric)) return {candidate_alone(row, evidence), 0};
  if (is_of_impacts(row.metric)) {
    require_unit(row, "Pa");
    return {evidence.impacts(row.candidate, row), 0};
  }
  if (is_of_fields(row.metric)) {
    require_unit(row, "1");
    return {evidence.fields(row), 0};
  }
  if (is_cost(row.metric)) {
    require_unit(row, "s");
    return cost_value(evidence.cost(row));
  }
  const Comparison& comparison = evidence.comparison(row.candidate, row.reference, row.quantity);
  require_unit(row, comparison.unit);
  if (is_of_band(row.metric)) return band_value(comparison);
  return metric_value(row.metric, row.mode, comparison);
}

void add_doubt(const std::string& text, RowDoubts& found) {
  found.text += "; " + text;
  found.keep_from_passing = true;
}

// Throws ComparisonError below least_coverage.
void add_coverage(double covered, RowDoubts& found) {
  if (covered >= 1) return;
  if (covered < least_coverage)
    throw ComparisonError(
        fmt::format("the samples cover {:.2g} % of the window; expected half of it or more, or a "
                    "window of [comparison] in which they lie",
                    100 * covered));
  found.text += fmt::format("; over {} % of the window, which the samples cover",
                            three_digits(100 * covered));
}

void add_doubtful(const std::vector<std::string>& doubts, RowDoubts& found) {
  if (doubts.empty()) return;
  add_doubt(fmt::format("doubtful: {}", fmt::join(doubts, "; ")), found);
  found.is_doubtful = true;
}

// Of a row with bounds.
std::pair<double, double> bounds_of(const GateRow& row) {
  return row.limit ? std::pair{-*row.limit, *row.limit} : row.between.value();
}

// Whether the row's bounds are narrower than ten steps of the readings. Of a part of the wave a
// step counts over the reference's deviation.
bool are_coarse_for(const GateRow& row, const SensorReadings& of, double deviation) {
  if (row.improves_on) return true;
  const auto [lower, upper] = bounds_of(row);
  double width = (upper - lower) / 2;
  if (row.unit == "1")
    width *= deviation;
  else if (row.unit == "deg")
    width *= deviation * std::numbers::pi / 180;
  else if (row.unit != of.unit)
    return true;
  return !(width >= 10 * *of.limits.step);
}

std::vector<std::string> reading_doubts(const GateRow& row, const Comparison& pair) {
  std::vector<std::string> doubts = pair.doubts;
  for (const SensorReadings& one : pair.in_steps)
    if (are_coarse_for(row, one, pair.reference_wave.deviation)) doubts.push_back(step_doubt(one));
  return doubts;
}

// What stands still must not be within the row's bounds. Where the metric of nothing is one value,
// these never hold it (WidestBound). An offset of the largest departure is one of nothing that
// swings, and the share outside a band is that of zeros.
std::string met_by_nothing(const GateRow& row, const Comparison& pair) {
  if (row.improves_on) return "";
  const std::pair<double, double> bounds = bounds_of(row);
  const auto holds = [&](double value) { return bounds.first <= value && value <= bounds.second; };
  const double departure = pair.largest_departure;
  if (row.metric == Metric::mean_offset && !pair.reference_is_constant && departure > 0 &&
      (holds(departure) || holds(-departure)))
    return fmt::format(
        "the bounds hold {:.3g} {}, the reference's largest departure from its mean: a candidate "
        "that does not move meets them wherever it stays",
        departure, pair.unit);
  if (!pair.margin_of_nothing) return "";
  const double outside = share_outside(*pair.margin_of_nothing, pair.window);
  return row.metric == Metric::outside_band && holds(outside)
             ? fmt::format("the bounds hold {:.3g} %, the share of a candidate of zeros",
                           100 * outside)
             : "";
}

// What one would look for first: a series in mm or kPa, or one of the other direction.
std::string mistaken_text(const Comparison& pair) {
  const double ratio = pair.candidate_wave.deviation / pair.reference_wave.deviation;
  if (!(ratio > 0) || std::isinf(ratio) || pair.residual.time.size() < 2) return "";
  const double apart = normalised_rms_without_offset(pair),
               correlation = (ratio * ratio + 1 - apart * apart) / (2 * ratio);
  std::string text;
  // Spikes, drifts and noise on still water are no wave in another unit.
  if (std::abs(correlation) > 0.5 && std::abs(std::abs(std::log10(ratio)) - 3) < 0.3)
    text = fmt::format("; unit? the candidate's swing is {:.3g} times the reference's", ratio);
  if (correlation < -0.9) text += "; sign? the candidate is the reference turned over";
  return text;
}

void add_doubts_of_pairs(const GateRow& row, const GateEvidence& evidence, RowDoubts& found) {
  const Comparison *unseen = nullptr, *barest = nullptr;
  std::string mistaken;
  std::vector<std::string> doubtful;
  for (const std::string& candidate : ensemble_of(row.candidate, evidence).members)
    for (const std::string& reference : reference_of(row, evidence).members) {
      const Comparison& pair = evidence.comparison(candidate, reference, row.quantity);
      if (pair.unseen && !(unseen && unseen->unseen->departure >= pair.unseen->departure))
        unseen = &pair;
      if (doubtful.empty()) doubtful = reading_doubts(row, pair);
      if (mistaken.empty()) mistaken = mistaken_text(pair);
      if (!barest || pair.covered < barest->covered) barest = &pair;
    }
  if (unseen && metric_entry(row.metric).fitted == FittedTones::none)
    add_doubt(unseen_text(*unseen->unseen, unseen->unit), found);
  if (const std::string met = met_by_nothing(row, *barest); !met.empty()) doubtful.push_back(met);
  add_doubtful(doubtful, found);
  found.text += mistaken;
  add_coverage(barest->covered, found);
}

// A sampled peak may be higher between its samples.
void add_doubts_of_peak(const GateRow& row, const TimeSeries& series,
                        std::vector<std::string>& doubts) {
  const double largest = largest_of(series).magnitude, above = above_largest(series.value);
  constexpr double known_to = 1.001;  // a row prints three digits
  const double upper = bounds_of(row).second;
  if (largest <= upper && largest + above > upper * known_to)
    doubts.push_back(fmt::format("between the samples of the candidate it may be {:.2g} {} more",
                                 above, series.unit));
  if (find_quantity(row.quantity) && is_sharp(series.value))
    doubts.push_back("the candidate's peak lasts for about a sample, and may be higher between");
}

// A peak may be cut off: the other crests, and a series that rests at its lowest value, as at zero,
// are none. What a flat hides is known to a factor of two.
void keep_flats_of_peaks(const GateRow& row, double largest, SensorLimits& limits) {
  const bool is_largest = row.metric == Metric::largest_magnitude;
  const auto matters = [&](const FlatExtreme& flat) {
    const double height = std::abs(flat.value);
    return height + flat.hidden > largest &&
           (row.improves_on || height + 2 * flat.hidden > bounds_of(row).second);
  };
  if (is_largest && limits.highest && !matters(*limits.highest)) limits.highest.reset();
  if (limits.lowest && (!is_largest || !matters(*limits.lowest))) limits.lowest.reset();
}

// What a run records beside the compared quantities need not be what a sensor reads.
void add_doubts_of_candidate(const GateRow& row, const GateEvidence& evidence, RowDoubts& found) {
  const FindHistory& find = is_of_impacts(row.metric) ? evidence.history : evidence.series;
  if (!find) return;
  const bool is_compared = find_quantity(row.quantity) != nullptr;
  const bool is_smoothed = evidence.readings && is_filtered(row.quantity);
  std::vector<std::string> doubts;
  double covered = 1;
  for (const std::string& run : ensemble_of(row.candidate, evidence).members) {
    const TimeSeries series = find(run, row.quantity);
    if (series.time.size() < 2) continue;  // refused by its metric
    const TimeSeries whole = evidence.history ? evidence.history(run, row.quantity) : series;
    TimeWindow window{series.time.front(), series.time.back()};
    if (evidence.judged.end > evidence.judged.begin && !is_of_impacts(row.metric))
      window = evidence.judged;
    covered = std::min(covered, covered_share(whole, window));
    if (!doubts.empty()) continue;
    const double recorded =
        is_compared ? evidence.sample_interval : std::numeric_limits<double>::infinity();
    if (const auto gap = longest_gap(whole, window, recorded))
      doubts.push_back(fmt::format("the candidate has no sample between {:.4g} and {:.4g} s",
                                   gap->begin, gap->end));
    if (row.metric == Metric::largest_magnitude && !row.improves_on)
      add_doubts_of_peak(row, series, doubts);
    if (!is_compared) continue;
    const TimeSeries read = is_smoothed ? evidence.readings(run, row.quantity) : whole;
    SensorReadings readings{"candidate", series.unit, sensor_limits(read, window),
                            evidence.rests ? evidence.rests(row.quantity) : std::vector<double>{}};
    const double largest = largest_of(is_smoothed ? cut_to_window(read, window) : series).magnitude;
    keep_flats_of_peaks(row, largest, readings.limits);
    std::ranges::move(doubts_of_readings(readings), std::back_inserter(doubts));
    if (readings.limits.step && are_coarse_for(row, readings, 0))
      doubts.push_back(step_doubt(readings));
  }
  add_doubtful(doubts, found);
  add_coverage(covered, found);
}

// Doubts a cost unless the smallest error of the runs that it rests on, and what the reference may
// be off by, are together within the error to reach.
void add_doubts_of_cost(const GateRow& row, const GateEvidence& evidence, RowDoubts& found) {
  const std::vector<std::string> runs = evidence.cost(row).rests_on;
  if (!evidence.uncertainty || runs.empty()) return;
  GateRow reached = row;
  reached.metric = Metric::normalised_rms;
  reached.mode = "whole";
  reached.unit = "1";
  reached.limit = row.error;
  reached.error.reset();
  double best = std::numeric_limits<double>::infinity();
  for (const std::string& run : runs)
    best =
        std::min(best, evidence.comparison(run, row.reference, row.quantity).normalised_rms.value);
  const Contribution off = evidence.uncertainty(reached).reference;
  if (!off.half_width)
    add_doubtful({off.basis}, found);
  else if (!(best + *off.half_width <= *row.error))
    add_doubtful({fmt::format("the error is {:.3g} %, and the reference may be off by {:.2g} %",
                              100 * best, 100 * *off.half_width)},
                 found);
  add_doubts_of_pairs(reached, evidence, found);
}

RowDoubts doubts_of_row(const GateRow& row, const GateEvidence& evidence) {
  RowDoubts found;
  if (is_cost(row.metric))
    add_doubts_of_cost(row, evidence, found);
  else if (is_of_a_pair(metric_entry(row.metric)))
    add_doubts_of_pairs(row, evidence, found);
  else if (is_of_impacts(row.metric) || is_of_candidate_alone(row.metric))
    add_doubts_of_candidate(row, evidence, found);
  return found;
}

}  // namespace

Peak largest_of(const TimeSeries& series) {
  Peak largest{series.value.empty() ? not_a_number : -1, not_a_number};
  for (std::size_t i = 0; i < series.value.size() && !std::isnan(largest.magnitude); ++i)
    if (const double magnitude = std::abs(series.value[i]); !(magnitude <= largest.magnitude))
      largest = {magnitude, series.time[i]};
  return largest;
}

std::string unseen_text(const UnseenInterval& unseen, const std::string& unit) {
  if (unseen.in_candidate)
    return fmt::format(
        "the candidate has no sample between {:.4g} and {:.4g} s, where the reference departs by "
        "up "
        "to {:.3g} {} from the curve across the gap",
        unseen.begin, unseen.end, unseen.departure, unit);
  return fmt::format(
      "the reference has no sample between {:.4g} and {:.4g} s, where the candidate departs by up "
      "to {:.3g} {} from what its values at the reference's times tell",
      unseen.begin, unseen.end, unseen.departure, unit);
}

RowDoubts doubts_of_samples(const GateRow& row, const GateEvidence& evidence) {
  RowDoubts found = doubts_of_row(row, evidence);
  if (!row.improves_on) return found;
  GateRow other = row;
  other.candidate = *row.improves_on;
  const RowDoubts others = doubts_of_row(other, evidence);
  if (others.text != found.text && !others.text.empty())  // what both say is of the reference
    found.text += fmt::format("; with {} as the candidate{}", other.candidate, others.text);
  found.keep_from_passing |= others.keep_from_passing;
  found.is_doubtful |= others.is_doubtful;
  return found;
}

double spread_of_series(const GateRow& row, const std::vector<std::string>& members,
                        const FindComparison& comparison) {
  if (row.metric != Metric::normalised_rms && row.metric != Metric::aligned_rms) return 0;
  double squares = 0;
  for (std::size_t i = 0; i < members.size(); ++i)
    for (std::size_t j = i + 1; j < members.size(); ++j) {
      const Comparison& pair = comparison(members[i], members[j], row.quantity);
      const double apart = row.metric == Metric::aligned_rms ? pair.alignment.normalised_rms
                                                             : pair.normalised_rms.value;
      squares += std::pow(apart * pair.reference_wave.deviation, 2);
    }
  if (squares == 0) return 0;
  const double n = static_cast<double>(members.size());
  // Any run of the row has the reference's deviation in its comparison.
  return std::sqrt(squares / (n * (n - 1))) /
         comparison(row.candidate, row.reference, row.quantity).reference_wave.deviation;
}

EnsembleOfRun ensemble_of(const std::string& run, const GateEvidence& evidence) {
  return evidence.ensemble ? evidence.ensemble(run) : EnsembleOfRun{{run}};
}

EnsembleOfRun reference_of(const GateRow& row, const GateEvidence& evidence) {
  return row.reference.empty() ? EnsembleOfRun{{""}, true} : ensemble_of(row.reference, evidence);
}

std::vector<std::vector<Estimate>> measured_pairs(const GateRow& row,
                                                  const GateEvidence& evidence) {
  std::vector<std::vector<Estimate>> pairs;
  for (const std::string& candidate : ensemble_of(row.candidate, evidence).members) {
    pairs.emplace_back();
    for (const std::string& reference : reference_of(row, evidence).members) {
      GateRow pair = row;
      pair.candidate = candidate;
      pair.reference = reference;
      pairs.back().push_back(measured_once(pair, evidence));
      // Each angle is taken within half a turn of the first one: without this, angles near half a
      // turn of either sign would have a mean near zero.
      double& value = pairs.back().back().value;
      constexpr double turn = 360;
      if (is_angle(row.metric))
        value -= turn * std::round((value - pairs.front().front().value) / turn);
    }
  }
  return pairs;
}

Estimate measured(const GateRow& row, const GateEvidence& evidence) {
  if (is_of_repeats(row.metric)) {
    require_unit(row, "1");
    return evidence.repeats(ensemble_of(row.candidate, evidence).members, row);
  }
  if (!is_of_ensembles(row, evidence)) return measured_once(row, evidence);
  if (is_of_impacts(row.metric)) {
    require_unit(row, "Pa");
    return evidence.repeats(ensemble_of(row.candidate, evidence).members, row);
  }
  const EnsembleOfRun candidate = ensemble_of(row.candidate, evidence);
  const EnsembleOfRun reference = reference_of(row, evidence);
  const auto is_one_of_many = [](const EnsembleOfRun& side) {
    return side.members.size() == 1 && !side.exact;
  };
  return ensemble_mean(measured_pairs(row, evidence),
                       is_one_of_many(candidate) || is_one_of_many(reference)
                           ? SingleSide::one_of_many
                           : SingleSide::exact,
                       {spread_of_series(row, candidate.members, evidence.comparison),
                        spread_of_series(row, reference.members, evidence.comparison)});
}

bool is_of_ensembles(const GateRow& row, const GateEvidence& evidence) {
  return !is_cost(row.metric) && !is_of_repeats(row.metric) &&
         ensemble_of(row.candidate, evidence).members.size() *
                 reference_of(row, evidence).members.size() >
             1;
}

}  // namespace slosh
