#include "verification/campaign/claim_evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "verification/metrics/windowed_series.hpp"

namespace slosh {
namespace {

using Values = std::vector<double>;

double mean(const Values& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double rms(const Values& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

Values without_mean(Values values) {
  const double m = mean(values);
  for (double& value : values) value -= m;
  return values;
}

Values minus(Values one, const Values& other) {
  for (std::size_t i = 0; i < one.size(); ++i) one[i] -= other[i];
  return one;
}

struct Common {
  Values time, one, other;
};

// At the other's times inside the window and inside the one's (at most a sample less).
Common common_samples(const TimeSeries& one, const TimeSeries& other, TimeWindow window) {
  const TimeSeries cut = cut_to_window(other, window);
  cut_to_window(one, {cut.time.front(), cut.time.back()});  // for its checks
  Common common;
  for (std::size_t i = 0; i < cut.time.size(); ++i) {
    if (cut.time[i] < one.time.front() || cut.time[i] > one.time.back()) continue;
    common.time.push_back(cut.time[i]);
    common.other.push_back(cut.value[i]);
  }
  common.one = interpolate(one, common.time);
  return common;
}

struct FittedTone {
  double amplitude, phase, amplitude_half_width;  // y = mean + amplitude cos(w t + phase)
};

// Normal equations of 1, cos, sin by Cramer's rule.
FittedTone fit_tone(const Values& time, const Values& value, double omega) {
  std::array<std::array<double, 3>, 3> m{};
  std::array<double, 3> right{};
  const auto basis = [&](double t) {
    return std::array<double, 3>{1, std::cos(omega * t), std::sin(omega * t)};
  };
  for (std::size_t k = 0; k < time.size(); ++k) {
    const auto b = basis(time[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      right[i] += b[i] * value[k];
      for (std::size_t j = 0; j < 3; ++j) m[i][j] += b[i] * b[j];
    }
  }
  const auto determinant = [](const auto& a) {
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
           a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
           a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
  };
  std::array<double, 3> x{};
  for (std::size_t j = 0; j < 3; ++j) {
    auto replaced = m;
    for (std::size_t i = 0; i < 3; ++i) replaced[i][j] = right[i];
    x[j] = determinant(replaced) / determinant(m);
  }
  double sum = 0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    const auto b = basis(time[k]);
    const double left = value[k] - x[0] - x[1] * b[1] - x[2] * b[2];
    sum += left * left;
  }
  const double count = static_cast<double>(time.size());
  // Of samples spread over whole periods: each coefficient's variance is 2 s^2 / n.
  const double half_width = 1.96 * std::sqrt(sum / (count - 3) * 2 / count);
  return {std::hypot(x[1], x[2]), std::atan2(-x[2], x[1]), half_width};
}

}  // namespace

const CaseAssessment& case_named(const std::vector<CaseAssessment>& cases,
                                 const std::string& name) {
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const CaseAssessment& one) {
    return one.definition.name == name;
  });
  if (found == cases.end())
    throw std::runtime_error("the case " + name + " is not part of this campaign");
  return *found;
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
    if (gauge.filter_cutoff)
      return {"wall_pressure@" + gauge.name + "/filtered", *gauge.filter_cutoff};
  throw std::runtime_error("the case " + definition.name + " filters no pressure");
}

HistoryDifference difference(const TimeSeries& one, const TimeSeries& other, TimeWindow window) {
  const Common common = common_samples(one, other, window);
  const Values varying = without_mean(common.other);
  return {.as_it_is = rms(minus(common.one, common.other)) / rms(varying),
          .without_means = rms(minus(without_mean(common.one), varying)) / rms(varying),
          .offset = mean(common.other) - mean(common.one)};
}

double skewness(const TimeSeries& series, TimeWindow window) {
  const Values values = without_mean(cut_to_window(series, window).value);
  double cubes = 0;
  for (const double value : values) cubes += value * value * value;
  return cubes / static_cast<double>(values.size()) / std::pow(rms(values), 3);
}

ToneDifference tone_difference(const TimeSeries& one, const TimeSeries& other, TimeWindow window,
                               double angular_frequency) {
  const Common common = common_samples(one, other, window);
  const FittedTone a = fit_tone(common.time, common.one, angular_frequency);
  const FittedTone b = fit_tone(common.time, common.other, angular_frequency);
  constexpr double degrees = 180 / std::numbers::pi;
  const double relative =
      std::hypot(a.amplitude_half_width / a.amplitude, b.amplitude_half_width / b.amplitude);
  return {.lag_degrees = {degrees * wrap_angle(b.phase - a.phase), degrees * relative},
          .amplitude_ratio = {a.amplitude / b.amplitude, relative * a.amplitude / b.amplitude}};
}

}  // namespace slosh
