#include "verification/metrics/tone_search.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/LevenbergMarquardt>

namespace slosh {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

bool refined(const ToneRange& range) { return range.high.decay_rate > range.low.decay_rate; }

// low at u = -pi/2, high at pi/2.
double inside(double low, double high, double u) {
  return 0.5 * (low + high) + 0.5 * (high - low) * std::sin(u);
}

double angle_of(double low, double high, double value) {
  return std::asin(std::clamp((2 * value - low - high) / (high - low), -1.0, 1.0));
}

struct Projection {
  MatrixXd basis;
  Eigen::HouseholderQR<MatrixXd> factors;
  VectorXd coefficients, residual;
};

Projection project(const WindowSamples& samples, const std::vector<ToneShape>& shapes) {
  const auto columns = harmonic_basis(samples, shapes);
  const auto rows = static_cast<Index>(samples.value.size());
  const Eigen::Map<const VectorXd> values(samples.value.data(), rows);
  Projection p;
  p.basis =
      Eigen::Map<const MatrixXd>(columns.data(), rows, static_cast<Index>(columns.size()) / rows);
  p.factors.compute(p.basis);
  p.coefficients = p.factors.solve(values);
  p.residual = values - p.basis * p.coefficients;
  return p;
}

// Residuals of the projected problem over two angles per refined tone.
class ProjectedResiduals : public Eigen::DenseFunctor<double> {
 public:
  ProjectedResiduals(const WindowSamples& samples, const std::vector<ToneRange>& ranges)
      : DenseFunctor(2 * static_cast<int>(std::count_if(ranges.begin(), ranges.end(), refined)),
                     static_cast<int>(samples.value.size())),
        samples_(samples),
        ranges_(ranges) {}

  std::vector<ToneShape> shapes(const VectorXd& angles) const {
    std::vector<ToneShape> result;
    Index next = 0;
    for (const auto& [low, high] : ranges_) {
      if (!refined({low, high})) {
        result.push_back(low);
        continue;
      }
      result.push_back({inside(low.angular_frequency, high.angular_frequency, angles[next]),
                        inside(low.decay_rate, high.decay_rate, angles[next + 1])});
      next += 2;
    }
    return result;
  }

  VectorXd angles(const std::vector<ToneShape>& shapes) const {
    VectorXd result(inputs());
    Index next = 0;
    for (std::size_t k = 0; k < ranges_.size(); ++k) {
      const auto& [low, high] = ranges_[k];
      if (!refined(ranges_[k])) continue;
      result[next++] =
          angle_of(low.angular_frequency, high.angular_frequency, shapes[k].angular_frequency);
      result[next++] = angle_of(low.decay_rate, high.decay_rate, shapes[k].decay_rate);
    }
    return result;
  }

  int operator()(const VectorXd& angles, VectorXd& residual) const {
    residual = project(samples_, shapes(angles)).residual;
    return 0;
  }

  int df(const VectorXd& angles, MatrixXd& jacobian) const {
    const Projection p = project(samples_, shapes(angles));
    const Eigen::Map<const Eigen::ArrayXd> s(samples_.elapsed.data(), p.basis.rows());
    Index next = 0;
    for (std::size_t k = 0; k < ranges_.size(); ++k) {
      if (!refined(ranges_[k])) continue;
      const auto& [low, high] = ranges_[k];
      const auto column = static_cast<Index>(2 + 2 * k);
      const auto cosine = p.basis.col(column).array(), sine = p.basis.col(column + 1).array();
      const double a = p.coefficients[column], b = p.coefficients[column + 1];
      const double frequency_slope =
          0.5 * (high.angular_frequency - low.angular_frequency) * std::cos(angles[next]);
      const double decay_slope =
          0.5 * (high.decay_rate - low.decay_rate) * std::cos(angles[next + 1]);
      jacobian.col(next++) = -frequency_slope * s * (b * cosine - a * sine);
      jacobian.col(next++) = decay_slope * s * (a * cosine + b * sine);
    }
    jacobian -= p.basis * p.factors.solve(jacobian);
    return 0;
  }

 private:
  const WindowSamples& samples_;
  const std::vector<ToneRange>& ranges_;
};

// Frequencies half a spectral bin apart, so that one of them starts inside the main lobe, times
// decay rates from none to one that ends within a twentieth of the window.
std::vector<ToneShape> trial_shapes(const ToneRange& range, double span) {
  const double width = range.high.angular_frequency - range.low.angular_frequency;
  const int cells = 1 + static_cast<int>(width * span / std::numbers::pi);
  std::vector<ToneShape> trials;
  for (int i = 0; i < cells; ++i) {
    for (const double decays_per_span : {0.0, 0.2, 2.0, 20.0}) {
      const double decay_rate = decays_per_span / span;
      if (decay_rate >= range.high.decay_rate) continue;
      trials.push_back({range.low.angular_frequency + width * (i + 0.5) / cells, decay_rate});
    }
  }
  return trials;
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

std::vector<double> harmonic_basis(const WindowSamples& samples,
                                   const std::vector<ToneShape>& shapes) {
  const std::size_t rows = samples.elapsed.size();
  std::vector<double> columns(rows * (2 + 2 * shapes.size()), 1.0);
  for (std::size_t i = 0; i < rows; ++i) {
    columns[rows + i] = 2 * samples.elapsed[i] / samples.span - 1;
  }
  auto cosine = columns.begin() + static_cast<std::ptrdiff_t>(2 * rows);
  for (const auto& [w, g] : shapes) {
    const auto sine = cosine + static_cast<std::ptrdiff_t>(rows);
    for (std::size_t i = 0; i < rows; ++i) {
      const double s = samples.elapsed[i], envelope = std::exp(-g * s);
      cosine[static_cast<std::ptrdiff_t>(i)] = envelope * std::cos(w * s);
      sine[static_cast<std::ptrdiff_t>(i)] = envelope * std::sin(w * s);
    }
    cosine = sine + static_cast<std::ptrdiff_t>(rows);
  }
  return columns;
}

std::vector<ToneShape> search_tones(const WindowSamples& samples,
                                    const std::vector<ToneRange>& ranges) {
  // The known tones first, then one refined tone after the other, each where it explains most.
  std::vector<ToneShape> shapes, known;
  for (const ToneRange& range : ranges) {
    if (!refined(range)) known.push_back(range.low);
  }
  for (const ToneRange& range : ranges) {
    ToneShape best = range.low;
    if (refined(range)) {
      double least = std::numeric_limits<double>::infinity();
      for (const ToneShape& trial : trial_shapes(range, samples.span)) {
        known.push_back(trial);
        const double misfit = project(samples, known).residual.squaredNorm();
        known.pop_back();
        if (misfit < least) {
          least = misfit;
          best = trial;
        }
      }
      known.push_back(best);
    }
    shapes.push_back(best);
  }

  ProjectedResiduals residuals(samples, ranges);
  if (residuals.inputs() == 0) return shapes;
  VectorXd angles = residuals.angles(shapes);
  Eigen::LevenbergMarquardt<ProjectedResiduals> solver(residuals);
  solver.setXtol(1e-10);
  solver.setFtol(1e-10);
  solver.setMaxfev(200);
  solver.minimize(angles);
  return residuals.shapes(angles);
}

}  // namespace slosh
