#include "verification/fits/window_fit.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace slosh {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using std::numbers::pi;

VectorXd elapsed_of(const std::vector<double>& time, TimeWindow window) {
  return Eigen::Map<const VectorXd>(time.data(), static_cast<Index>(time.size())).array() -
         window.begin;
}

Eigen::Map<const VectorXd> vector_of(const std::vector<double>& values) {
  return {values.data(), static_cast<Index>(values.size())};
}

// The columns 1 and 2 s / span - 1.
MatrixXd mean_and_trend(const VectorXd& elapsed, TimeWindow window) {
  MatrixXd columns(elapsed.size(), 2);
  columns.col(0).setOnes();
  columns.col(1) = 2 * elapsed.array() / (window.end - window.begin) - 1;
  return columns;
}

MatrixXd basis_of(const VectorXd& elapsed, TimeWindow window,
                  const std::vector<ToneShape>& shapes) {
  MatrixXd basis(elapsed.size(), 2 + 2 * static_cast<Index>(shapes.size()));
  basis.leftCols<2>() = mean_and_trend(elapsed, window);
  Index next = 2;
  for (const ToneShape& shape : shapes) {
    basis.middleCols<2>(next) = tone_columns(elapsed, shape);
    next += 2;
  }
  return basis;
}

}  // namespace

MatrixXd WindowFit::jacobian(const std::vector<double>& time) const {
  const VectorXd elapsed = elapsed_of(time, window);
  const MatrixXd basis = basis_of(elapsed, window, shapes);
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
  return vector_of(value) - basis_of(elapsed_of(time, window), window, shapes) * coefficients;
}

FitResidual WindowFit::at_times(const std::vector<double>& time, VectorXd residuals) const {
  return {elapsed_of(time, window), jacobian(time), std::move(residuals), shapes, ranges,
          window.end - window.begin};
}

WindowFit::ToneEstimates WindowFit::estimates(std::size_t k, const ResidualModel& model) const {
  const auto cosine = static_cast<Index>(2 + 2 * k);
  const auto refined_before =
      std::count_if(requests.begin(), requests.begin() + static_cast<std::ptrdiff_t>(k),
                    [](const auto& r) { return r.refine; });
  const auto shape = static_cast<Index>(2 + 2 * requests.size()) + 2 * refined_before;
  const bool refine = requests[k].refine;
  const double a = coefficients[cosine] + model.correction[cosine],
               b = coefficients[cosine + 1] + model.correction[cosine + 1];
  const double w = shapes[k].angular_frequency + (refine ? model.correction[shape] : 0),
               g = shapes[k].decay_rate + (refine ? model.correction[shape + 1] : 0);
  const double amplitude = std::hypot(a, b), square = amplitude * amplitude;
  const auto half_width = [&](double by_a, double by_b, double by_w, double by_g) {
    VectorXd gradient = VectorXd::Zero(model.correction.size());
    gradient[cosine] = by_a;
    gradient[cosine + 1] = by_b;
    if (refine) gradient.segment<2>(shape) << by_w, by_g;
    return model.noise[k].half_width(gradient);
  };
  // Where the correction may equally well belong to the tone itself, all of it is uncertain.
  const auto corrected = [&](double value, double uncorrected, double half) -> Estimate {
    return {value, half + (model.beside[k] ? std::abs(value - uncorrected) : 0)};
  };
  const double a0 = coefficients[cosine], b0 = coefficients[cosine + 1];
  const double w0 = shapes[k].angular_frequency, g0 = shapes[k].decay_rate;
  // The phase at a time since the window's begin [s].
  const auto phase_after = [&](double time) {
    const double angle = std::atan2(-b, a) + w * time,
                 change = angle - std::atan2(-b0, a0) - w0 * time;
    const Estimate phase =
        corrected(angle, angle - wrap_angle(change), half_width(b / square, -a / square, time, 0));
    return Estimate{wrap_angle(angle), std::min(pi, phase.half_width)};
  };
  return {.amplitude = corrected(amplitude, std::hypot(a0, b0),
                                 half_width(a / amplitude, b / amplitude, 0, 0)),
          .angular_frequency = corrected(w, w0, half_width(0, 0, 1, 0)),
          .decay_rate = corrected(g, g0, half_width(0, 0, 0, 1)),
          .phase = phase_after(-window.begin),
          .phase_at_middle = phase_after(0.5 * (window.end - window.begin))};
}

std::optional<double> WindowFit::beside(std::size_t k, const ResidualModel& model) const {
  const auto cosine = static_cast<Index>(2 + 2 * k);
  const double shift = model.correction.segment<2>(cosine).norm();
  if (model.noise[k].known() && shift < largest_shift * coefficients.segment<2>(cosine).norm())
    return std::nullopt;
  return model.beside[k];
}

WindowFit fit_window(const TimeSeries& cut, TimeWindow window,
                     const std::vector<ToneRequest>& requests) {
  require_resolved(window, requests);
  require_sampled(cut, requests);
  const double span = window.end - window.begin;
  const VectorXd elapsed = elapsed_of(cut.time, window), value = vector_of(cut.value);
  const MatrixXd fixed = mean_and_trend(elapsed, window);
  WindowFit fit{window, requests, tone_ranges(requests, span), {}, {}};
  fit.shapes = search_tones(elapsed, value, fixed, fit.ranges, span);
  fit.coefficients = fit_tones(elapsed, value, fixed, fit.shapes).coefficients;
  return fit;
}

}  // namespace slosh
