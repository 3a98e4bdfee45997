// The nonlinear part of the harmonic fit: frequencies and decay rates of the refined tones by
// variable projection (Golub & Pereyra 1973): the linear coefficients are eliminated by least
// squares, the rest is minimised by Levenberg-Marquardt (Eigen) with Kaufman's Jacobian (1975),
// from the best point of a grid. Each refined tone is kept inside a range, by w = centre +
// half_range sin(u), so that no tone runs away.
#pragma once

#include <vector>

#include "verification/metrics/harmonic_fit.hpp"

namespace slosh {

struct ToneShape {
  double angular_frequency;  // [rad/s]
  double decay_rate;         // [1/s]
};

struct ToneRange {
  ToneShape low, high;
};

// Times are elapsed since the window's begin; span is the window's length [s].
struct WindowSamples {
  std::vector<double> elapsed, value;
  double span;
};

// Where a tone may lie. A refined tone: within 10 % of the request and nearer to it than half-way
// to any other request; decay rate from -2 / span (what noise can make of an undamped mode) to
// critical damping. Another tone: its request, undamped.
std::vector<ToneRange> tone_ranges(const std::vector<ToneRequest>& requests, double span);

// Columns of the linear problem, each as long as `elapsed` s, one after the other: 1, 2 s / span -
// 1, then per tone exp(-g s) cos(w s), exp(-g s) sin(w s).
std::vector<double> harmonic_basis(const WindowSamples& samples,
                                   const std::vector<ToneShape>& shapes);

// Least-squares shapes within the ranges.
std::vector<ToneShape> search_tones(const WindowSamples& samples,
                                    const std::vector<ToneRange>& ranges);

}  // namespace slosh
