#include "verification/papers/claim_evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/case/ensemble.hpp"
#include "verification/case/quantities.hpp"
#include "verification/fits/dense_algebra.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

using Values = std::vector<double>;

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

TimeWindow comparison_window(const CaseDefinition& definition) {
  return {definition.window_begin, definition.window_end};
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

}  // namespace slosh
