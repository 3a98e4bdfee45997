#include "verification/metrics/harmonic_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verification/metrics/tone_search.hpp"
#include "verification/metrics/windowed_series.hpp"

namespace slosh {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using std::numbers::pi;

constexpr double normal_quantile = 1.959964;  // two-sided 95 %
// sqrt(13.28), the 99 % point of chi-square with the four parameters of a refined tone: what the
// search finds in noise alone stays below this many standard errors.
constexpr double detection_level = 3.644;
// The autocovariance is used up to an eighth of the window, which gives the spectral estimate
// behind it 30 degrees of freedom (3.71 windows per longest lag, Priestley 1981). The
// fit of a tone takes up to four of them out of the residual: the rest is scaled up by 30 / 26, and
// the quantile is Student's for 26.
constexpr int windows_per_longest_lag = 8;
constexpr double removed_by_fit = 30.0 / 26.0, student_quantile = 2.0555;

void require_sampling(const TimeSeries& series, const std::vector<ToneRequest>& requests) {
  double highest = 0;
  for (const ToneRequest& request : requests)
    highest = std::max(highest, request.angular_frequency);
  // Ten samples per period: below, the cubic interpolation beside this fit errs by more than 1 %.
  const double longest_interval = 2 * pi / (10 * highest);
  for (std::size_t i = 1; i < series.time.size(); ++i) {
    if (!(series.time[i] - series.time[i - 1] <= longest_interval)) {
      throw ComparisonError(
          fmt::format("{}: no sample between {} s and {} s; expected intervals up to {:.3g} s",
                      series.name, series.time[i - 1], series.time[i], longest_interval));
    }
  }
  if (series.time.size() < 2 * (2 + 4 * requests.size())) {
    throw ComparisonError(fmt::format("{}: {} samples are too few to fit {} tones", series.name,
                                      series.time.size(), requests.size()));
  }
}

// d model / d (c0, c1, a_0, b_0, ...), then (w, g) of each refined tone.
MatrixXd full_jacobian(const MatrixXd& basis, const VectorXd& coefficients, const VectorXd& elapsed,
                       const std::vector<ToneRequest>& requests) {
  const auto refined =
      std::count_if(requests.begin(), requests.end(), [](const auto& r) { return r.refine; });
  MatrixXd jacobian(basis.rows(), basis.cols() + 2 * refined);
  jacobian.leftCols(basis.cols()) = basis;
  Index next = basis.cols();
  for (std::size_t k = 0; k < requests.size(); ++k) {
    if (!requests[k].refine) continue;
    const auto column = static_cast<Index>(2 + 2 * k);
    const double a = coefficients[column], b = coefficients[column + 1];
    const auto cosine = basis.col(column), sine = basis.col(column + 1);
    jacobian.col(next++) = elapsed.cwiseProduct(b * cosine - a * sine);
    jacobian.col(next++) = -elapsed.cwiseProduct(a * cosine + b * sine);
  }
  return jacobian;
}

double parzen(double x) {
  return x <= 0.5 ? 1 - 6 * x * x * (1 - x) : 2 * (1 - x) * (1 - x) * (1 - x);
}

// Covariances of the parameters were the residuals white, and with the autocorrelation that they
// show.
struct Covariance {
  MatrixXd white, correlated;

  // Half width of a quantity with this gradient: never below the one for white residuals.
  double half_width(const VectorXd& gradient) const {
    return std::max(
        normal_quantile * std::sqrt(gradient.dot(white * gradient)),
        student_quantile * std::sqrt(removed_by_fit * gradient.dot(correlated * gradient)));
  }
};

Covariance covariance(const MatrixXd& jacobian, const VectorXd& residual) {
  // Columns of unit length, because those of w carry seconds and those of a weak tone vanish.
  const VectorXd length =
      jacobian.colwise().norm().transpose().cwiseMax(std::numeric_limits<double>::min());
  const MatrixXd scaled = jacobian * length.cwiseInverse().asDiagonal();
  const MatrixXd normal = scaled.transpose() * scaled;
  const MatrixXd inverse = normal.completeOrthogonalDecomposition().pseudoInverse();

  const Index count = residual.size(),
              longest = std::max<Index>(1, count / windows_per_longest_lag);
  const auto freedom = static_cast<double>(count - jacobian.cols());
  MatrixXd correlated = residual.squaredNorm() / freedom * scaled;
  for (Index lag = 1; lag < longest; ++lag) {
    const Index overlap = count - lag;
    const double autocovariance = residual.head(overlap).dot(residual.tail(overlap)) / freedom *
                                  parzen(static_cast<double>(lag) / static_cast<double>(longest));
    correlated.topRows(overlap) += autocovariance * scaled.bottomRows(overlap);
    correlated.bottomRows(overlap) += autocovariance * scaled.topRows(overlap);
  }
  const auto rescale = [&](const MatrixXd& matrix) -> MatrixXd {
    return length.cwiseInverse().asDiagonal() * matrix * length.cwiseInverse().asDiagonal();
  };
  return {.white = rescale(residual.squaredNorm() / freedom * inverse),
          .correlated = rescale(inverse * (scaled.transpose() * correlated) * inverse)};
}

// One tone's place in the parameter vector; `shape` is that of w, followed by g, of a refined tone.
struct ToneColumns {
  Index cosine, shape;
};

// Whether the search ended at an end of its range, so that the data would have it outside.
bool at_edge(double value, double low, double high) {
  const double edge =
      1e-3 * (high - low);  // as near as the sine's flat ends let it come for certain
  return !(value > low + edge && value < high - edge);
}

bool detected(const Estimate& amplitude) {
  return amplitude.value * normal_quantile > detection_level * amplitude.half_width;
}

void widen_if_unresolved(Tone& tone, const ToneRange& range) {
  const auto& [low, high] = range;
  tone.resolved =
      tone.resolved && !at_edge(tone.decay_rate.value, low.decay_rate, high.decay_rate) &&
      !at_edge(tone.angular_frequency.value, low.angular_frequency, high.angular_frequency);
  if (tone.resolved) return;
  tone.amplitude.half_width = std::max(tone.amplitude.half_width, tone.amplitude.value);
  tone.angular_frequency.half_width = high.angular_frequency - low.angular_frequency;
  tone.decay_rate.half_width = high.decay_rate - low.decay_rate;
  tone.phase.half_width = tone.phase_at_middle.half_width = pi;
}

Tone estimate_tone(const ToneRequest& request, const ToneShape& shape, const VectorXd& coefficients,
                   const Covariance& spread, const ToneColumns& columns, TimeWindow window) {
  const double a = coefficients[columns.cosine], b = coefficients[columns.cosine + 1];
  const double amplitude = std::hypot(a, b), phase_at_begin = std::atan2(-b, a);
  const Index parameters = spread.white.rows();
  const auto half_width = [&](double by_a, double by_b, double by_w, double by_g) {
    VectorXd gradient = VectorXd::Zero(parameters);
    gradient[columns.cosine] = by_a;
    gradient[columns.cosine + 1] = by_b;
    if (request.refine) gradient.segment<2>(columns.shape) << by_w, by_g;
    return spread.half_width(gradient);
  };
  // The phase [rad] this long after the window's begin.
  const auto phase_after = [&](double time) -> Estimate {
    const double square = amplitude * amplitude;
    return {.value = wrap_angle(phase_at_begin + shape.angular_frequency * time),
            .half_width = std::min(pi, half_width(b / square, -a / square, time, 0))};
  };
  const Estimate at_begin{amplitude, half_width(a / amplitude, b / amplitude, 0, 0)};
  return {.name = request.name,
          .resolved = detected(at_begin),
          .angular_frequency = {shape.angular_frequency, half_width(0, 0, 1, 0)},
          .decay_rate = {shape.decay_rate, half_width(0, 0, 0, 1)},
          .amplitude = at_begin,
          .phase = phase_after(-window.begin),
          .phase_at_middle = phase_after(0.5 * (window.end - window.begin))};
}

}  // namespace

void require_resolved(TimeWindow window, const std::vector<ToneRequest>& requests) {
  const double length = window.end - window.begin;
  const auto require_apart = [&](double difference, const std::string& which) {
    const double needed = 2 * pi / std::abs(difference);
    if (!(length > needed)) {
      throw ComparisonError(
          fmt::format("the window of {:.4g} s cannot resolve {}; needed: more than {:.4g} s",
                      length, which, needed));
    }
  };
  const auto describe = [](const ToneRequest& tone) {
    return fmt::format("{} ({:.4g} Hz)", tone.name, tone.angular_frequency / (2 * pi));
  };
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (!(requests[i].angular_frequency > 0)) {
      throw ComparisonError(describe(requests[i]) + ": expected a positive frequency");
    }
    require_apart(requests[i].angular_frequency, describe(requests[i]) + " from the mean");
    for (std::size_t j = 0; j < i; ++j) {
      require_apart(requests[i].angular_frequency - requests[j].angular_frequency,
                    describe(requests[j]) + " from " + describe(requests[i]));
    }
  }
}

double wrap_angle(double angle) { return std::remainder(angle, 2 * pi); }

HarmonicFit fit_harmonics(const TimeSeries& series, TimeWindow window,
                          const std::vector<ToneRequest>& requests) {
  const TimeSeries cut = cut_to_window(series, window);
  require_resolved(window, requests);
  require_sampling(cut, requests);

  WindowSamples samples{.elapsed = cut.time, .value = cut.value, .span = window.end - window.begin};
  for (double& s : samples.elapsed) s -= window.begin;
  const auto ranges = tone_ranges(requests, samples.span);
  const auto shapes = search_tones(samples, ranges);

  const auto rows = static_cast<Index>(samples.value.size());
  const auto columns = harmonic_basis(samples, shapes);
  const Eigen::Map<const MatrixXd> basis(columns.data(), rows,
                                         static_cast<Index>(columns.size()) / rows);
  const Eigen::Map<const VectorXd> values(samples.value.data(), rows);
  const Eigen::Map<const VectorXd> elapsed(samples.elapsed.data(), rows);
  const VectorXd coefficients = basis.colPivHouseholderQr().solve(values);
  const VectorXd residual = values - basis * coefficients;
  const Covariance spread =
      covariance(full_jacobian(basis, coefficients, elapsed, requests), residual);

  HarmonicFit fit{.mean = coefficients[0],
                  .trend = 2 * coefficients[1] / samples.span,
                  .tones = {},
                  .residual_rms = std::sqrt(residual.squaredNorm() / static_cast<double>(rows))};
  Index shape_column = basis.cols();
  for (std::size_t k = 0; k < requests.size(); ++k) {
    const ToneColumns place{.cosine = static_cast<Index>(2 + 2 * k), .shape = shape_column};
    fit.tones.push_back(estimate_tone(requests[k], shapes[k], coefficients, spread, place, window));
    if (requests[k].refine) {
      widen_if_unresolved(fit.tones.back(), ranges[k]);
      shape_column += 2;
    }
  }
  return fit;
}

}  // namespace slosh
