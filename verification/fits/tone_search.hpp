// The nonlinear part of the harmonic fit: frequencies and decay rates of the refined tones by
// variable projection (Golub & Pereyra 1973): the linear coefficients are eliminated by least
// squares, the rest is minimised by Levenberg and Marquardt's method with Kaufman's Jacobian
// (1975), from the best point of a grid. Each refined tone is kept inside a range, by w = centre +
// half_range sin(u), so that no tone runs away.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "verification/fits/harmonic_fit.hpp"

namespace slosh {

struct ToneShape {
  double angular_frequency;  // [rad/s]
  double decay_rate;         // [1/s]
};

struct ToneRange {
  ToneShape low, high;
  bool refined() const { return high.decay_rate > low.decay_rate; }
};

// Where a tone may lie. A refined tone: within 10 % of the request and nearer to it than half-way
// to any other request; decay rate from -2 / span (what noise can make of an undamped mode) to
// critical damping. Another tone: its request, undamped.
std::vector<ToneRange> tone_ranges(const std::vector<ToneRequest>& requests, double span);

// exp(-g s) cos(w s) and exp(-g s) sin(w s), one column each, at the elapsed times s [s].
Eigen::MatrixXd tone_columns(const Eigen::VectorXd& elapsed, const ToneShape& shape);

// Least squares of the values by fixed columns and tones.
struct ToneFit {
  Eigen::MatrixXd basis;         // the fixed columns, then two of each tone
  Eigen::VectorXd coefficients;  // of the basis
  Eigen::VectorXd residual;
};

ToneFit fit_tones(const Eigen::VectorXd& elapsed, const Eigen::VectorXd& value,
                  const Eigen::MatrixXd& fixed, const std::vector<ToneShape>& shapes);

// Frequencies half a spectral bin apart, so that one of them starts inside the main lobe, times
// these decay rates that lie in the range.
std::vector<ToneShape> trial_shapes(const ToneRange& range, double span,
                                    const std::vector<double>& decays_per_span);

// Tones that are tried one by one, their columns computed once.
class TrialTones {
 public:
  // At least one shape.
  TrialTones(const Eigen::VectorXd& elapsed, std::vector<ToneShape> shapes);

  // The one that explains most of what the orthonormal basis leaves of the values.
  ToneShape best(const Eigen::VectorXd& value, const Eigen::MatrixXd& basis) const;

 private:
  std::vector<ToneShape> shapes_;
  Eigen::MatrixXd columns_;  // two of each shape
};

// Least-squares shapes of refined tones within their ranges, from these ones, beside what the
// orthonormal basis takes. The search ends where a step would take less than `least_gain` of the
// residual's sum of squares.
std::vector<ToneShape> refine_tones(const Eigen::VectorXd& elapsed, const Eigen::VectorXd& value,
                                    const Eigen::MatrixXd& basis,
                                    const std::vector<ToneRange>& ranges,
                                    const std::vector<ToneShape>& start, double least_gain);

// Least-squares shapes within the ranges: the known tones first, then one refined tone after the
// other where it explains most, then all of them refined together. `span` is the window's length
// [s].
std::vector<ToneShape> search_tones(const Eigen::VectorXd& elapsed, const Eigen::VectorXd& value,
                                    const Eigen::MatrixXd& fixed,
                                    const std::vector<ToneRange>& ranges, double span);

}  // namespace slosh
