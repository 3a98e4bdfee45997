#include "verification/metrics/tone_search.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace slosh {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// low at u = -pi/2, high at pi/2.
double inside(double low, double high, double u) {
  return 0.5 * (low + high) + 0.5 * (high - low) * std::sin(u);
}

double angle_of(double low, double high, double value) {
  return std::asin(std::clamp((2 * value - low - high) / (high - low), -1.0, 1.0));
}

// The refined tones' shapes as two angles each.
std::vector<ToneShape> shapes_of(const std::vector<ToneRange>& ranges, const VectorXd& angles) {
  std::vector<ToneShape> shapes;
  Index next = 0;
  for (const ToneRange& range : ranges) {
    const auto& [low, high] = range;
    if (!range.refined()) {
      shapes.push_back(low);
      continue;
    }
    shapes.push_back({inside(low.angular_frequency, high.angular_frequency, angles[next]),
                      inside(low.decay_rate, high.decay_rate, angles[next + 1])});
    next += 2;
  }
  return shapes;
}

VectorXd angles_of(const std::vector<ToneRange>& ranges, const std::vector<ToneShape>& shapes) {
  std::vector<double> angles;
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const auto& [low, high] = ranges[k];
    if (!ranges[k].refined()) continue;
    angles.push_back(
        angle_of(low.angular_frequency, high.angular_frequency, shapes[k].angular_frequency));
    angles.push_back(angle_of(low.decay_rate, high.decay_rate, shapes[k].decay_rate));
  }
  return Eigen::Map<const VectorXd>(angles.data(), static_cast<Index>(angles.size()));
}

// d model / d angles, one column each.
MatrixXd slopes(const VectorXd& elapsed, const ToneFit& fit, const std::vector<ToneRange>& ranges,
                const VectorXd& angles) {
  MatrixXd columns(elapsed.size(), angles.size());
  const Index first = fit.basis.cols() - 2 * static_cast<Index>(ranges.size());
  Index next = 0;
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const auto& [low, high] = ranges[k];
    if (!ranges[k].refined()) continue;
    const Index column = first + 2 * static_cast<Index>(k);
    const auto cosine = fit.basis.col(column), sine = fit.basis.col(column + 1);
    const double a = fit.coefficients[column], b = fit.coefficients[column + 1];
    const double by_frequency =
        0.5 * (high.angular_frequency - low.angular_frequency) * std::cos(angles[next]);
    const double by_decay = 0.5 * (high.decay_rate - low.decay_rate) * std::cos(angles[next + 1]);
    columns.col(next++) = by_frequency * elapsed.cwiseProduct(b * cosine - a * sine);
    columns.col(next++) = -by_decay * elapsed.cwiseProduct(a * cosine + b * sine);
  }
  return columns;
}

// The slopes' normal equations with the linear coefficients eliminated.
struct ReducedNormal {
  MatrixXd matrix;
  VectorXd gradient;
};

ReducedNormal reduced_normal(const ToneFit& fit, const MatrixXd& slope) {
  const MatrixXd cross = fit.basis.transpose() * slope;
  const MatrixXd normal = fit.basis.transpose() * fit.basis;
  return {slope.transpose() * slope - cross.transpose() * normal.ldlt().solve(cross),
          slope.transpose() * fit.residual};
}

}  // namespace

std::vector<ToneRange> tone_ranges(const std::vector<ToneRequest>& requests, double span) {
  std::vector<ToneRange> ranges;
  for (const ToneRequest& request : requests) {
    const double w = request.angular_frequency;
    if (!request.refine) {
      ranges.push_back({{w, 0}, {w, 0}});
      continue;
    }
    double half_range = 0.1 * w;
    for (const ToneRequest& other : requests) {
      if (&other == &request) continue;
      half_range = std::min(half_range, 0.5 * std::abs(other.angular_frequency - w));
    }
    ranges.push_back({{w - half_range, -2 / span}, {w + half_range, w}});
  }
  return ranges;
}

MatrixXd tone_columns(const VectorXd& elapsed, const ToneShape& shape) {
  const std::complex<double> rate(-shape.decay_rate, shape.angular_frequency);
  const Index count = elapsed.size();
  // Equal steps turn by the same factor; afresh every so often, before round-off adds up.
  constexpr Index turns = 32;
  const double step = count > 1 ? (elapsed[count - 1] - elapsed[0]) / double(count - 1) : 0;
  const std::complex<double> turn = std::exp(rate * step);
  const double rounding = 1e-12 * (1 + std::abs(elapsed[count - 1]));
  MatrixXd columns(count, 2);
  std::complex<double> now;
  double expected = std::numeric_limits<double>::quiet_NaN();
  for (Index i = 0; i < count; ++i) {
    now = i % turns != 0 && std::abs(elapsed[i] - expected) < rounding
              ? now * turn
              : std::exp(rate * elapsed[i]);
    expected = elapsed[i] + step;
    columns(i, 0) = now.real();
    columns(i, 1) = now.imag();
  }
  return columns;
}

ToneFit fit_tones(const VectorXd& elapsed, const VectorXd& value, const MatrixXd& fixed,
                  const std::vector<ToneShape>& shapes) {
  ToneFit fit;
  fit.basis.resize(fixed.rows(), fixed.cols() + 2 * static_cast<Index>(shapes.size()));
  fit.basis.leftCols(fixed.cols()) = fixed;
  Index next = fixed.cols();
  for (const ToneShape& shape : shapes) {
    fit.basis.middleCols<2>(next) = tone_columns(elapsed, shape);
    next += 2;
  }
  const Eigen::LDLT<MatrixXd> normal((fit.basis.transpose() * fit.basis).eval());
  fit.coefficients = normal.solve(fit.basis.transpose() * value);
  // Once more, of what the squared condition number has left.
  fit.residual = value - fit.basis * fit.coefficients;
  fit.coefficients += normal.solve(fit.basis.transpose() * fit.residual);
  fit.residual = value - fit.basis * fit.coefficients;
  return fit;
}

std::vector<ToneShape> trial_shapes(const ToneRange& range, double span,
                                    const std::vector<double>& decays_per_span) {
  const double width = range.high.angular_frequency - range.low.angular_frequency;
  const int cells = 1 + static_cast<int>(width * span / std::numbers::pi);
  std::vector<ToneShape> trials;
  for (int i = 0; i < cells; ++i) {
    for (const double decays : decays_per_span) {
      const double decay_rate = decays / span;
      if (decay_rate >= range.high.decay_rate) continue;
      trials.push_back({range.low.angular_frequency + width * (i + 0.5) / cells, decay_rate});
    }
  }
  return trials;
}

ToneShape best_trial(const VectorXd& elapsed, const VectorXd& value, const MatrixXd& columns,
                     const std::vector<ToneShape>& trials) {
  const Eigen::LDLT<MatrixXd> normal((columns.transpose() * columns).eval());
  const VectorXd left = value - columns * normal.solve(columns.transpose() * value);
  double most = -1;
  ToneShape best = trials.front();
  for (const ToneShape& trial : trials) {
    const MatrixXd tone = tone_columns(elapsed, trial);
    const MatrixXd cross = columns.transpose() * tone;
    const Eigen::Matrix2d square =
        tone.transpose() * tone - cross.transpose() * normal.solve(cross);
    const Eigen::Vector2d product = tone.transpose() * left;
    const double explained = product.dot(square.ldlt().solve(product));
    if (explained > most) {
      most = explained;
      best = trial;
    }
  }
  return best;
}

std::vector<ToneShape> refine_tones(const VectorXd& elapsed, const VectorXd& value,
                                    const MatrixXd& fixed, const std::vector<ToneRange>& ranges,
                                    const std::vector<ToneShape>& start) {
  VectorXd angles = angles_of(ranges, start);
  if (angles.size() == 0) return start;
  ToneFit fit = fit_tones(elapsed, value, fixed, shapes_of(ranges, angles));
  double damping = 1e-3;
  constexpr int most_steps = 100;
  for (int step = 0; step < most_steps && damping < 1e8; ++step) {
    ReducedNormal normal = reduced_normal(fit, slopes(elapsed, fit, ranges, angles));
    const VectorXd scale = normal.matrix.diagonal().cwiseMax(
        1e-12 * normal.matrix.diagonal().maxCoeff() + std::numeric_limits<double>::min());
    normal.matrix.diagonal() += damping * scale;
    const VectorXd change = normal.matrix.ldlt().solve(normal.gradient);
    // Below round-off of the sum of squares nothing is to be gained.
    if (!(change.dot(normal.gradient) > 1e-14 * fit.residual.squaredNorm())) break;
    ToneFit next = fit_tones(elapsed, value, fixed, shapes_of(ranges, angles + change));
    const double gain = fit.residual.squaredNorm() - next.residual.squaredNorm();
    if (gain > 0) {
      angles += change;
      fit = std::move(next);
      damping *= 0.1;
    } else {
      damping *= 10;
    }
  }
  return shapes_of(ranges, angles);
}

std::vector<ToneShape> search_tones(const VectorXd& elapsed, const VectorXd& value,
                                    const MatrixXd& fixed, const std::vector<ToneRange>& ranges,
                                    double span) {
  std::vector<ToneShape> shapes, found;
  for (const ToneRange& range : ranges)
    if (!range.refined()) found.push_back(range.low);
  for (const ToneRange& range : ranges) {
    shapes.push_back(range.low);
    if (!range.refined()) continue;
    shapes.back() = best_trial(elapsed, value, fit_tones(elapsed, value, fixed, found).basis,
                               trial_shapes(range, span, {0.0, 0.2, 2.0, 20.0}));
    found.push_back(shapes.back());
  }
  return refine_tones(elapsed, value, fixed, ranges, shapes);
}

}  // namespace slosh
