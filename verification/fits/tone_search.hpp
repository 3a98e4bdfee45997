// The nonlinear part of the harmonic fit: the frequencies and decay rates of the refined tones by
// variable projection (Golub & Pereyra 1973). The linear coefficients are eliminated by least
// squares. The rest is minimised by the Levenberg-Marquardt method with Kaufman's Jacobian (1975),
// starting at the best point of a grid. The substitution w = centre + half_range sin(u) keeps each
// refined tone inside a range.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "verification/fits/tone_request.hpp"

namespace slosh {

struct ToneShape {
  double angular_frequency;  // [rad/s]
  double decay_rate;         // [1/s]
};

struct ToneRange {
  ToneShape low, high;
  bool refined() const { return high.decay_rate > low.decay_rate; }
};

// The range of each tone. A refined tone lies within 10 % of the request and closer to it than
// half-way to any other request; its decay rate lies between -2 / span (noise can give an undamped
// mode this much growth) and critical damping. Any other tone has the requested frequency and is
// undamped. `span` is the window's length [s].
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

// Least-squares shapes of refined tones within their ranges, starting from `start`. The values are
// fitted by the orthonormal basis and the tones. The search ends where a step would reduce the
// residual's sum of squares by less than the fraction `least_gain`.
std::vector<ToneShape> refine_tones(const Eigen::VectorXd& elapsed, const Eigen::VectorXd& value,
                                    const Eigen::MatrixXd& basis,
                                    const std::vector<ToneRange>& ranges,
                                    const std::vector<ToneShape>& start, double least_gain);

// Least-squares shapes within the ranges. The tones of known shape come first; then each refined
// tone starts where it explains most of the residual; then all of them are refined together. `span`
// is the window's length [s].
std::vector<ToneShape> search_tones(const Eigen::VectorXd& elapsed, const Eigen::VectorXd& value,
                                    const Eigen::MatrixXd& fixed,
                                    const std::vector<ToneRange>& ranges, double span);

}  // namespace slosh
