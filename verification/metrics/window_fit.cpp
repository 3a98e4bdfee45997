#include "verification/metrics/window_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace slosh {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using std::numbers::pi;

WindowSamples samples_of(const std::vector<double>& time, const std::vector<double>& value,
                         TimeWindow window) {
  WindowSamples samples{.elapsed = time, .value = value, .span = window.end - window.begin};
  for (double& s : samples.elapsed) s -= window.begin;
  return samples;
}

MatrixXd basis_of(const WindowSamples& samples, const std::vector<ToneShape>& shapes) {
  const auto rows = static_cast<Index>(samples.elapsed.size());
  const auto columns = harmonic_basis(samples, shapes);
  return Eigen::Map<const MatrixXd>(columns.data(), rows,
                                    static_cast<Index>(columns.size()) / rows);
}

}  // namespace

void require_sampled(const TimeSeries& cut, const std::vector<ToneRequest>& requests) {
  double highest = 0;
  for (const ToneRequest& request : requests)
    highest = std::max(highest, request.angular_frequency);
  // Ten samples per period: below, the cubic interpolation beside this fit errs by more than 1 %.
  const double longest_interval = 2 * pi / (10 * highest);
  for (std::size_t i = 1; i < cut.time.size(); ++i) {
    if (!(cut.time[i] - cut.time[i - 1] <= longest_interval)) {
      throw ComparisonError(
          fmt::format("{}: no sample between {} s and {} s; expected intervals up to {:.3g} s",
                      cut.name, cut.time[i - 1], cut.time[i], longest_interval));
    }
  }
  if (cut.time.size() < 2 * (2 + 4 * requests.size())) {
    throw ComparisonError(fmt::format("{}: {} samples are too few to fit {} tones", cut.name,
                                      cut.time.size(), requests.size()));
  }
}

MatrixXd WindowFit::jacobian(const std::vector<double>& time) const {
  const WindowSamples samples = samples_of(time, {}, window);
  const MatrixXd basis = basis_of(samples, shapes);
  const Eigen::Map<const VectorXd> elapsed(samples.elapsed.data(), basis.rows());
  const auto refined =
      std::count_if(requests.begin(), requests.end(), [](const auto& r) { return r.refine; });
  MatrixXd all(basis.rows(), basis.cols() + 2 * refined);
  all.leftCols(basis.cols()) = basis;
  Index next = basis.cols();
  for (std::size_t k = 0; k < requests.size(); ++k) {
    if (!requests[k].refine) continue;
    const auto column = static_cast<Index>(2 + 2 * k);
    const double a = coefficients[column], b = coefficients[column + 1];
    const auto cosine = basis.col(column), sine = basis.col(column + 1);
    all.col(next++) = elapsed.cwiseProduct(b * cosine - a * sine);
    all.col(next++) = -elapsed.cwiseProduct(a * cosine + b * sine);
  }
  return all;
}

VectorXd WindowFit::residual(const std::vector<double>& time,
                             const std::vector<double>& value) const {
  const MatrixXd basis = basis_of(samples_of(time, {}, window), shapes);
  return Eigen::Map<const VectorXd>(value.data(), basis.rows()) - basis * coefficients;
}

WindowFit::HalfWidths WindowFit::half_widths(std::size_t k, const FitCovariance& spread) const {
  const auto cosine = static_cast<Index>(2 + 2 * k);
  const auto refined_before =
      std::count_if(requests.begin(), requests.begin() + static_cast<std::ptrdiff_t>(k),
                    [](const auto& r) { return r.refine; });
  const auto shape = static_cast<Index>(2 + 2 * requests.size()) + 2 * refined_before;
  const double a = coefficients[cosine], b = coefficients[cosine + 1];
  const double amplitude = std::hypot(a, b), square = amplitude * amplitude;
  const auto half_width = [&](double by_a, double by_b, double by_w, double by_g) {
    VectorXd gradient = VectorXd::Zero(spread.white.rows());
    gradient[cosine] = by_a;
    gradient[cosine + 1] = by_b;
    if (requests[k].refine) gradient.segment<2>(shape) << by_w, by_g;
    return spread.half_width(gradient);
  };
  // Of the phase this long after the window's begin.
  const auto of_phase = [&](double time) {
    return std::min(pi, half_width(b / square, -a / square, time, 0));
  };
  return {.amplitude = half_width(a / amplitude, b / amplitude, 0, 0),
          .angular_frequency = half_width(0, 0, 1, 0),
          .decay_rate = half_width(0, 0, 0, 1),
          .phase = of_phase(-window.begin),
          .phase_at_middle = of_phase(0.5 * (window.end - window.begin))};
}

WindowFit fit_window(const TimeSeries& cut, TimeWindow window,
                     const std::vector<ToneRequest>& requests) {
  require_resolved(window, requests);
  require_sampled(cut, requests);
  const WindowSamples samples = samples_of(cut.time, cut.value, window);
  WindowFit fit{window, requests, tone_ranges(requests, samples.span), {}, {}};
  fit.shapes = search_tones(samples, fit.ranges);
  const MatrixXd basis = basis_of(samples, fit.shapes);
  fit.coefficients =
      basis.colPivHouseholderQr().solve(Eigen::Map<const VectorXd>(cut.value.data(), basis.rows()));
  return fit;
}

}  // namespace slosh
