// What a harmonic fit leaves, modelled as far as it is deterministic: tones that no request names
// (a beat, the sidebands of a modulation, a higher mode, a harmonic) are neither noise, which would
// widen every interval, nor nothing, which would bias the fitted tones. To the first order in the
// parameters' changes, the residual is fitted by the Jacobian's columns and up to three further
// tones, one after the other, all refined together. One or more of them are taken where the energy
// in fourteen spectral bins about a requested tone, the noise made white, falls by more than chance
// has it in 1 of 100000 cases (F test: of noise alone the search takes the best of some 100
// places). Their parameters' uncertainty is in the intervals. One too near to tell from a requested
// tone (nearer than a spectral bin and its own line's width g / pi) may be part of that: its
// correction is added to the half widths, and above largest_shift the requested tone is unknown.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "verification/fits/local_noise.hpp"
#include "verification/fits/tone_search.hpp"

namespace slosh {

// Of a tone's amplitude: what moves it by less widens its interval by as much; a convention, as the
// tolerances of amplitudes in use are a twentieth.
inline constexpr double largest_shift = 0.05;

struct LeftoverModel {
  Eigen::VectorXd correction;     // of the parameters, one per column of the Jacobian
  std::vector<LocalNoise> noise;  // about each requested tone
  // Of each requested tone: the frequency [rad/s] of what the window cannot tell it from.
  std::vector<std::optional<double>> beside;

  LeftoverModel without_corrections() const {
    return {Eigen::VectorXd::Zero(correction.size()), noise, beside};
  }
};

// Of a fit with this Jacobian and these residuals at equally spaced times [s] of a window that is
// `span` long. No further tone is taken beside a refined one, whose slopes by frequency and decay
// rate fill the bins about it already. Of `asked` alone, one of the requested tones, the noise and
// what is beside it are told; of all where it is none.
LeftoverModel model_leftovers(const Eigen::VectorXd& elapsed, const Eigen::MatrixXd& jacobian,
                              const Eigen::VectorXd& residual,
                              const std::vector<ToneShape>& requested,
                              const std::vector<ToneRange>& ranges, double span,
                              std::optional<std::size_t> asked = {});

}  // namespace slosh
