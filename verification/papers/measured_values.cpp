#include "verification/papers/measured_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/case/ensemble.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/fits/dense_algebra.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/series/interval_text.hpp"
#include "verification/series/low_pass_filter.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

using Values = std::vector<double>;

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

TimeWindow window_of(Stage stage, const CaseDefinition& definition) {
  const TimeWindow steady = comparison_window(definition);
  if (stage == Stage::first) return {0, steady.begin};
  if (stage == Stage::late) return {(steady.begin + steady.end) / 2, steady.end};
  return steady;
}

// The mean of a number of the values of each whole period of the forcing.
template <class Number>
double mean_over_periods(const TimeSeries& cut, const CaseDefinition& definition,
                         const Number& number) {
  const double period = 2 * std::numbers::pi / forcing_frequency(definition);
  Values found;
  auto from = cut.time.begin();
  for (double end = cut.time.front() + period; end <= cut.time.back(); end += period) {
    const auto to = std::lower_bound(from, cut.time.end(), end);
    const auto value = [&](auto at) { return cut.value.begin() + (at - cut.time.begin()); };
    if (from != to) found.push_back(number(Values(value(from), value(to))));
    from = to;
  }
  if (found.empty()) throw std::runtime_error(cut.name + " covers no period of the forcing");
  return mean(found);
}

double noise_of(const TimeSeries& series, const TimeSeries& cut, const CaseDefinition& definition,
                TimeWindow window) {
  const TimeSeries smooth = low_pass(series, filtered_gauge(definition).second);
  return rms(minus(cut.value, cut_to_window(smooth, window).value));
}

double value_of(const TimeSeries& series, const Measured& what, const CaseDefinition& definition) {
  const TimeWindow window = window_of(what.stage, definition);
  const TimeSeries cut = cut_to_window(series, window);
  const auto highest = [](const Values& values) {
    return *std::max_element(values.begin(), values.end());
  };
  const auto lowest = [](const Values& values) {
    return *std::min_element(values.begin(), values.end());
  };
  const auto variance = [](const Values& values) { return std::pow(rms(without_mean(values)), 2); };
  switch (what.measure) {
    case Measure::mean:
      return mean(cut.value);
    case Measure::fluctuation:
      return std::sqrt(mean_over_periods(cut, definition, variance));
    case Measure::crest:
      return mean_over_periods(cut, definition, highest);
    case Measure::trough:
      return std::abs(mean_over_periods(cut, definition, lowest));
    case Measure::largest:
      return highest(cut.value);
    case Measure::noise:
      return noise_of(series, cut, definition, window);
    case Measure::main_frequency: {
      const auto peaks = spectral_peaks(power_spectrum(series, window), 1);
      return peaks.empty() ? not_a_number : peaks.front().frequency;
    }
    default:
      throw std::logic_error("the measure is not one of a series");
  }
}

double value_of(const SurfaceSpectrum& spectrum, Measure measure) {
  switch (measure) {
    case Measure::first_frequency:
      return spectrum.peak[0].frequency;
    case Measure::second_frequency:
      return spectrum.peak[1].frequency;
    case Measure::first_power:
      return spectrum.peak[0].power;
    case Measure::second_power:
      return spectrum.peak[1].power;
    default:
      return spectrum.ratio();
  }
}

double distance_of_impacts(const CaseAssessment& assessment, const std::string& run,
                           Measure measure) {
  const CaseDefinition& definition = assessment.definition;
  if (!definition.impacts)
    throw std::runtime_error("the case " + definition.name + " has no [impacts]");
  const ImpactsDefinition& published = *definition.impacts;
  const auto peaks =
      impacts_in(standing_result(assessment, run).at(wall_pressure(published.gauge)), definition);
  Values distances;
  for (std::size_t n = 0; n < peaks.size(); ++n) {
    if (!peaks[n]) return not_a_number;
    distances.push_back(measure == Measure::peak_distance
                            ? std::abs(std::log(peaks[n]->pressure / published.peak_means[n]))
                            : std::abs(peaks[n]->time - published.times[n]) / published.period);
  }
  return mean(distances);
}

std::string series_of(const std::string& quantity, const CaseDefinition& definition) {
  if (quantity == "elevation" || quantity == "highest_surface")
    return at_first_gauge(definition, quantity);
  return quantity == "wall_pressure" ? filtered_gauge(definition).first : quantity;
}

Readings of_member(const CaseAssessment& assessment, const std::string& run, const Measured& what) {
  if (what.stage == Stage::first_over_steady) {
    const auto in = [&](Stage stage) {
      return of_member(assessment, run, {what.quantity, what.measure, stage});
    };
    const Readings first = in(Stage::first), steady = in(Stage::steady);
    return {first.small / steady.small, first.large / steady.large};
  }
  if (what.measure >= Measure::peak_distance) {
    const double distance = distance_of_impacts(assessment, run, what.measure);
    return {distance, distance};
  }
  if (what.measure >= Measure::first_frequency) {
    const double value = value_of(surface_spectrum(assessment, run), what.measure);
    return {value, value};
  }
  const CaseDefinition& definition = assessment.definition;
  const RunResult& result = standing_result(assessment, run);
  if (what.quantity != "momentum") {
    const double value =
        value_of(result.at(series_of(what.quantity, definition)), what, definition);
    return {value, value};
  }
  const auto [small, large] = momentum_magnitudes(result, definition);
  return {value_of(small, what, definition), value_of(large, what, definition)};
}

// Returns both at the other's times, the one as candidate; checks that both cover the window.
CommonSamples within_window(const TimeSeries& one, const TimeSeries& other, TimeWindow window) {
  const TimeSeries cut = cut_to_window(other, window);
  cut_to_window(one, {cut.time.front(), cut.time.back()});
  return common_samples(one, cut);
}

struct FittedTone {
  double amplitude, phase, amplitude_half_width;  // y = mean + amplitude cos(w t + phase)
};

FittedTone fit_tone(const Values& time, const Values& value, double omega) {
  const auto count = static_cast<Eigen::Index>(time.size());
  const Eigen::Map<const Eigen::ArrayXd> t(time.data(), count), y(value.data(), count);
  Eigen::MatrixXd basis(count, 3);
  basis << Eigen::ArrayXd::Ones(count), (omega * t).cos(), (omega * t).sin();
  const Eigen::VectorXd x = least_squares(basis, y.matrix());
  const double sum = (y.matrix() - basis * x).squaredNorm();
  // For samples spread over whole periods, the variance of each coefficient is 2 s^2 / n.
  const double n = static_cast<double>(count);
  const double half_width = 1.96 * std::sqrt(sum / (n - 3) * 2 / n);
  return {std::hypot(x[1], x[2]), std::atan2(-x[2], x[1]), half_width};
}

}  // namespace

const CaseAssessment* find_case(const std::vector<CaseAssessment>& cases, const std::string& name) {
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const CaseAssessment& one) {
    return one.definition.name == name;
  });
  return found == cases.end() ? nullptr : &*found;
}

const CaseAssessment& case_named(const std::vector<CaseAssessment>& cases,
                                 const std::string& name) {
  if (const CaseAssessment* found = find_case(cases, name)) return *found;
  throw std::runtime_error("the case " + name + " is not part of this campaign");
}

const RunResult& standing_result(const CaseAssessment& assessment, const std::string& run) {
  const auto result = assessment.runs.results.find(run);
  if (result != assessment.runs.results.end()) return result->second;
  const auto status = assessment.runs.status.find(run);
  const std::string place = fmt::format("{} of {}", run, assessment.definition.name);
  if (status == assessment.runs.status.end()) throw std::runtime_error(place + " is not declared");
  const std::string& message = status->second.message;
  throw std::runtime_error(fmt::format("{}: {}{}", place, state_name(status->second.state),
                                       message.empty() ? "" : " (" + message + ")"));
}

double diagnostic_of(const CaseAssessment& assessment, const std::string& run,
                     const std::string& name) {
  const RunResult& result = standing_result(assessment, run);
  const auto found = result.diagnostics.find(name);
  if (found == result.diagnostics.end() || !std::isfinite(found->second))
    throw std::runtime_error(
        fmt::format("{} of {} left no {}", run, assessment.definition.name, name));
  return found->second;
}

Estimate difference_of_members(const std::vector<double>& larger,
                               const std::vector<double>& smaller, SingleSide single) {
  std::vector<std::vector<Estimate>> pairs;
  for (const double one : larger) {
    pairs.emplace_back();
    for (const double other : smaller) pairs.back().push_back({one - other, 0});
  }
  if (pairs.size() == 1 && pairs.front().size() == 1) return pairs.front().front();
  return ensemble_mean(pairs, single);
}

Estimate ratio_of_members(const std::vector<double>& larger, const std::vector<double>& smaller,
                          SingleSide single) {
  const auto logarithms = [](std::vector<double> numbers) {
    for (double& one : numbers) one = std::log(one);
    return numbers;
  };
  const Estimate log_ratio = difference_of_members(logarithms(larger), logarithms(smaller), single);
  const double ratio = std::exp(log_ratio.value);
  return {ratio, ratio * std::expm1(log_ratio.half_width)};
}

std::string name_of_members(const CaseAssessment& assessment, const std::string& run) {
  const std::size_t count = members_of(assessment.definition, run).size();
  return count < 2 ? run : fmt::format("{} (mean of {} repeats)", run, count);
}

std::string at_first_gauge(const CaseDefinition& definition, const std::string& kind) {
  if (definition.gauges.empty())
    throw std::runtime_error("the case " + definition.name + " has no gauge");
  return kind + "@" + definition.gauges.front().name;
}

std::pair<std::string, double> filtered_gauge(const CaseDefinition& definition) {
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    if (gauge.filter_cutoff) return {smoothest_pressure(gauge), *gauge.filter_cutoff};
  throw std::runtime_error("the case " + definition.name + " filters no pressure");
}

HistoryDifference difference(const TimeSeries& one, const TimeSeries& other, TimeWindow window) {
  const CommonSamples common = within_window(one, other, window);
  const Values varying = without_mean(common.reference);
  return {.with_means = rms(minus(common.candidate, common.reference)) / rms(varying),
          .without_means = rms(minus(without_mean(common.candidate), varying)) / rms(varying),
          .offset = mean(common.reference) - mean(common.candidate)};
}

double skewness(const TimeSeries& series, TimeWindow window) {
  const Values values = without_mean(cut_to_window(series, window).value);
  double cubes = 0;
  for (const double value : values) cubes += value * value * value;
  return cubes / static_cast<double>(values.size()) / std::pow(rms(values), 3);
}

ToneDifference tone_difference(const TimeSeries& one, const TimeSeries& other, TimeWindow window,
                               double angular_frequency) {
  const CommonSamples common = within_window(one, other, window);
  const FittedTone a = fit_tone(common.time, common.candidate, angular_frequency);
  const FittedTone b = fit_tone(common.time, common.reference, angular_frequency);
  constexpr double degrees = 180 / std::numbers::pi;
  const double relative =
      std::hypot(a.amplitude_half_width / a.amplitude, b.amplitude_half_width / b.amplitude);
  return {.lag_degrees = {degrees * wrap_angle(b.phase - a.phase), degrees * relative},
          .amplitude_ratio = {a.amplitude / b.amplitude, relative * a.amplitude / b.amplitude}};
}

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

std::string frequency_text(const std::vector<double>& members) {
  const auto missing =
      std::count_if(members.begin(), members.end(), [](double one) { return std::isnan(one); });
  if (missing > 0) return fmt::format("none in {} of {}", missing, members.size());
  return interval_text(mean_of_members(members));
}

std::pair<TimeSeries, TimeSeries> momentum_magnitudes(const RunResult& result,
                                                      const CaseDefinition& definition) {
  const TimeSeries &x = result.at("momentum_x"), &z = result.at("momentum_z"),
                   &energy = result.at("kinetic_energy");
  if (x.time != z.time || x.time != energy.time)
    throw std::runtime_error(result.run_name + ": momentum and energy have different times");
  const double mass =
      definition.liquid.density * definition.tank.length * definition.liquid.fill_depth;
  TimeSeries small{"|P|", x.unit, x.time, {}}, large{"sqrt(2 M K)", x.unit, x.time, {}};
  for (std::size_t i = 0; i < x.time.size(); ++i) {
    small.value.push_back(std::hypot(x.value[i], z.value[i]));
    large.value.push_back(std::sqrt(2 * mass * energy.value[i]));
  }
  return {small, large};
}

std::vector<Readings> measured(const CaseAssessment& assessment, const std::string& run,
                               const Measured& what) {
  std::vector<Readings> members;
  for (const std::string& member : members_of(assessment.definition, run))
    members.push_back(of_member(assessment, member, what));
  return members;
}

std::vector<double> numbers(const std::vector<Readings>& members, double Readings::*which) {
  std::vector<double> found;
  for (const Readings& one : members) found.push_back(one.*which);
  return found;
}

}  // namespace slosh
