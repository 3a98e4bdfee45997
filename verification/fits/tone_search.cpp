#include "verification/fits/tone_search.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "verification/fits/dense_algebra.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// The value in the range: low at u = -pi/2, high at pi/2.
double inside(double low, double high, double u) {
  return 0.5 * (low + high) + 0.5 * (high - low) * std::sin(u);
}

double angle_of(double low, double high, double value) {
  return std::asin(std::clamp((2 * value - low - high) / (high - low), -1.0, 1.0));
}

// The shapes that these angles stand for, two angles per shape.
std::vector<ToneShape> shapes_of(const std::vector<ToneRange>& ranges, const VectorXd& angles) {
  std::vector<ToneShape> shapes;
  Index next = 0;
  for (const auto& [low, high] : ranges) {
    shapes.push_back({inside(low.angular_frequency, high.angular_frequency, angles[next]),
                      inside(low.decay_rate, high.decay_rate, angles[next + 1])});
    next += 2;
  }
  return shapes;
}

VectorXd angles_of(const std::vector<ToneRange>& ranges, const std::vector<ToneShape>& shapes) {
  VectorXd angles(2 * static_cast<Index>(ranges.size()));
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const auto& [low, high] = ranges[k];
    angles.segment<2>(2 * static_cast<Index>(k))
        << angle_of(low.angular_frequency, high.angular_frequency, shapes[k].angular_frequency),
        angle_of(low.decay_rate, high.decay_rate, shapes[k].decay_rate);
  }
  return angles;
}

MatrixXd columns_of(const VectorXd& elapsed, const std::vector<ToneShape>& shapes) {
  MatrixXd columns(elapsed.size(), 2 * static_cast<Index>(shapes.size()));
  for (std::size_t k = 0; k < shapes.size(); ++k)
    columns.middleCols<2>(2 * static_cast<Index>(k)) = tone_columns(elapsed, shapes[k]);
  return columns;
}

// Least squares of values that are orthogonal to an orthonormal basis, by the parts of the tones
// orthogonal to it.
struct ReducedFit {
  MatrixXd tones, in_basis;  // the tones' columns, and their products with the basis
  SymmetricFactors normal;
  VectorXd coefficients, residual;
};

ReducedFit reduced_fit(const VectorXd& elapsed, const VectorXd& left, const MatrixXd& basis,
                       const std::vector<ToneShape>& shapes) {
  ReducedFit fit;
  fit.tones = columns_of(elapsed, shapes);
  fit.in_basis = transposed_product(basis, fit.tones);
  fit.normal = SymmetricFactors(transposed_product(fit.tones, fit.tones) -
                                transposed_product(fit.in_basis, fit.in_basis));
  fit.coefficients = VectorXd::Zero(fit.tones.cols());
  fit.residual = left;
  // The second pass corrects the error that the squared condition number leaves.
  for (int pass = 0; pass < 2; ++pass) {
    const VectorXd more = fit.normal.solve(fit.tones.transpose() * fit.residual);
    fit.coefficients += more;
    fit.residual -= fit.tones * more - basis * (fit.in_basis * more);
  }
  return fit;
}

// The derivatives of the fitted tones by the angles, one column each.
MatrixXd slopes(const VectorXd& elapsed, const ReducedFit& fit,
                const std::vector<ToneRange>& ranges, const VectorXd& angles) {
  MatrixXd columns(elapsed.size(), angles.size());
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const auto& [low, high] = ranges[k];
    const Index column = 2 * static_cast<Index>(k);
    const auto cosine = fit.tones.col(column), sine = fit.tones.col(column + 1);
    const double a = fit.coefficients[column], b = fit.coefficients[column + 1];
    const double by_frequency =
        0.5 * (high.angular_frequency - low.angular_frequency) * std::cos(angles[column]);
    const double by_decay = 0.5 * (high.decay_rate - low.decay_rate) * std::cos(angles[column + 1]);
    columns.col(column) = by_frequency * elapsed.cwiseProduct(b * cosine - a * sine);
    columns.col(column + 1) = -by_decay * elapsed.cwiseProduct(a * cosine + b * sine);
  }
  return columns;
}

// The slopes' normal equations with the linear coefficients eliminated.
struct ReducedNormal {
  MatrixXd matrix;
  VectorXd gradient;
};

ReducedNormal reduced_normal(const ReducedFit& fit, const MatrixXd& basis, const MatrixXd& slope) {
  const MatrixXd in_basis = transposed_product(basis, slope);
  const MatrixXd cross =
      transposed_product(fit.tones, slope) - transposed_product(fit.in_basis, in_basis);
  return {transposed_product(slope, slope) - transposed_product(in_basis, in_basis) -
              transposed_product(cross, fit.normal.solve_columns(cross)),
          slope.transpose() * fit.residual};
}

// Trial frequencies half a spectral bin apart, so that one of them lies inside the main lobe, each
// with those of the decay rates that are below the range's end.
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

// Tones that are tried one by one; their columns are computed once.
class TrialTones {
 public:
  // Requires at least one shape.
  TrialTones(const VectorXd& elapsed, std::vector<ToneShape> shapes)
      : shapes_(std::move(shapes)), columns_(columns_of(elapsed, shapes_)) {}

  // The shape that explains most of the part of the values orthogonal to the basis.
  ToneShape best(const VectorXd& value, const MatrixXd& basis) const {
    const MatrixXd in_basis = transposed_product(basis, columns_);
    const VectorXd products = columns_.transpose() * orthogonal_part(value, basis);
    double most = -1;
    std::size_t best = 0;
    for (std::size_t k = 0; k < shapes_.size(); ++k) {
      const Index column = 2 * static_cast<Index>(k);
      const auto tone = columns_.middleCols<2>(column), taken = in_basis.middleCols<2>(column);
      const MatrixXd square = transposed_product(tone, tone) - transposed_product(taken, taken);
      const VectorXd with_value = products.segment<2>(column);
      const double explained = with_value.dot(SymmetricFactors(square).solve(with_value));
      if (explained > most) {
        most = explained;
        best = k;
      }
    }
    return shapes_[best];
  }

 private:
  std::vector<ToneShape> shapes_;
  MatrixXd columns_;  // two of each shape
};

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
  // Over equal steps the tone turns by the same factor. The exponential is computed anew every 32
  // steps, before round-off adds up.
  constexpr Index turns = 32;
  const double step = count > 1 ? (elapsed[count - 1] - elapsed[0]) / double(count - 1) : 0;
  const std::complex<double> turn = std::exp(rate * step);
  const double rounding = 1e-12 * (1 + std::abs(elapsed[count - 1]));
  MatrixXd columns(count, 2);
  std::complex<double> now;
  double expected = not_a_number;
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
  const SymmetricFactors normal(transposed_product(fit.basis, fit.basis));
  fit.coefficients = normal.solve(fit.basis.transpose() * value);
  // The second solution corrects the error that the squared condition number leaves.
  fit.residual = value - fit.basis * fit.coefficients;
  fit.coefficients += normal.solve(fit.basis.transpose() * fit.residual);
  fit.residual = value - fit.basis * fit.coefficients;
  return fit;
}

std::vector<ToneShape> refine_tones(const VectorXd& elapsed, const VectorXd& value,
                                    const MatrixXd& basis, const std::vector<ToneRange>& ranges,
                                    const std::vector<ToneShape>& start, double least_gain) {
  if (ranges.empty()) return {};
  const VectorXd left = orthogonal_part(value, basis);
  VectorXd angles = angles_of(ranges, start);
  ReducedFit fit = reduced_fit(elapsed, left, basis, shapes_of(ranges, angles));
  double damping = 1e-3;
  constexpr int most_steps = 100;
  for (int step = 0; step < most_steps && damping < 1e8; ++step) {
    ReducedNormal normal = reduced_normal(fit, basis, slopes(elapsed, fit, ranges, angles));
    const VectorXd scale = normal.matrix.diagonal().cwiseMax(
        1e-12 * normal.matrix.diagonal().maxCoeff() + std::numeric_limits<double>::min());
    normal.matrix.diagonal() += damping * scale;
    const VectorXd change = SymmetricFactors(normal.matrix).solve(normal.gradient);
    if (!(change.dot(normal.gradient) > least_gain * fit.residual.squaredNorm())) break;
    ReducedFit next = reduced_fit(elapsed, left, basis, shapes_of(ranges, angles + change));
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
  std::vector<ToneShape> known;
  std::vector<ToneRange> refined;
  for (const ToneRange& range : ranges) {
    if (range.refined())
      refined.push_back(range);
    else
      known.push_back(range.low);
  }
  const auto beside = [&](const std::vector<ToneShape>& tones) {
    return orthonormal(unit_columns(fit_tones(elapsed, value, fixed, tones).basis), 1e-12);
  };
  const MatrixXd basis = beside(known);
  std::vector<ToneShape> start, found = known;
  for (const ToneRange& range : refined) {
    start.push_back(TrialTones(elapsed, trial_shapes(range, span, {0.0, 0.2, 2.0, 20.0}))
                        .best(value, beside(found)));
    found.push_back(start.back());
  }
  // A smaller gain would be below the round-off of the sum of squares.
  const std::vector<ToneShape> best = refine_tones(elapsed, value, basis, refined, start, 1e-14);
  std::vector<ToneShape> shapes;
  auto next = best.begin();
  for (const ToneRange& range : ranges) shapes.push_back(range.refined() ? *next++ : range.low);
  return shapes;
}

}  // namespace slosh
