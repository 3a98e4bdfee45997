// A model of the deterministic part of a harmonic fit's residual. Tones that no request names (a
// beat, the sidebands of a modulation, a higher mode, a harmonic) must not count as noise, which
// would widen every interval, and must not be ignored, which would bias the fitted tones. The
// residual is fitted, to first order in the parameters' changes, by the Jacobian's columns and up
// to three further tones, added one by one and all refined together. One or more of them are kept
// where the energy in fourteen spectral bins about a requested tone, with the noise whitened, falls
// by an amount that noise alone reaches in 1 of 100000 cases (F test; the level is this low
// because in noise alone the search takes the best of some 100 places). The intervals include the
// uncertainty of their parameters. A further tone that is too close to tell from a requested tone
// (closer than a spectral bin plus its own line width g / pi) may be part of that tone: its
// correction is added to the half widths, and above largest_shift the requested tone is unknown.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "verification/fits/local_noise.hpp"
#include "verification/fits/tone_search.hpp"

namespace slosh {

// As a share of a tone's amplitude. An unnamed tone that shifts the requested one by less only
// widens its interval by the shift. The value is a convention: the tolerances of amplitudes in use
// are a twentieth.
inline constexpr double largest_shift = 0.05;

// The residual of a fit at equally spaced times [s] of a window of length `span` [s].
struct FitResidual {
  Eigen::VectorXd elapsed;
  Eigen::MatrixXd jacobian;  // of the fit, one column per parameter
  Eigen::VectorXd values;
  std::vector<ToneShape> requested;
  std::vector<ToneRange> ranges;
  double span;
};

struct ResidualModel {
  Eigen::VectorXd correction;      // of the parameters, one per column of the Jacobian
  std::vector<ToneShape> further;  // the tones that no request names
  std::vector<LocalNoise> noise;   // about each requested tone
  // For each requested tone, the frequency [rad/s] of an unnamed tone that the window cannot tell
  // from it.
  std::vector<std::optional<double>> beside;

  ResidualModel without_corrections() const {
    return {Eigen::VectorXd::Zero(correction.size()), further, noise, beside};
  }
};

// Models a residual. No further tone is taken close to a refined one, whose derivatives by
// frequency and decay rate fill the bins about it already. Tones that are `known` to be in the
// residual are part of the model from the start, each with its derivatives by frequency and decay
// rate. `asked` restricts `noise` and `beside` to one of the requested tones; without it they cover
// all.
ResidualModel model_residual(const FitResidual& residual, std::optional<std::size_t> asked = {},
                             const std::vector<ToneShape>& known = {});

// The correction of the parameters by these further tones alone, each with its derivatives by
// frequency and decay rate.
Eigen::VectorXd correction_by(const FitResidual& residual, const std::vector<ToneShape>& known);

// Those of both lists that a window of this length tells from the requested tone and from the
// trend, from which a tone below one spectral bin differs by little. Tones within half a bin of
// each other count once.
std::vector<ToneShape> of_either(const std::vector<ToneShape>& tones,
                                 const std::vector<ToneShape>& others, const ToneShape& requested,
                                 double span);

}  // namespace slosh
