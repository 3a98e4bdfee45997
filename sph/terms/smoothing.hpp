// The smoothing length of a pair of particles: one for all, or the mean of the two where spacings
// differ.
#pragma once

#include "sph/setting.hpp"

namespace slosh::sph {

// h = ratio * spacing, one for the whole scene.
struct UniformSmoothing {
  static constexpr const char* name = "uniform smoothing length";
  static constexpr bool reads_spacing = false;
  double inverse_length;  // 1/h [1/m]

  explicit UniformSmoothing(const Setting& s) : inverse_length(1.0 / s.smoothing_length()) {}
  template <class Number, class Other>
  double inverse(Number, Other) const {
    return inverse_length;
  }
};

// h_ab = ratio * (spacing_a + spacing_b) / 2 (Monaghan 1992, section 4).
struct PairSmoothing {
  static constexpr const char* name = "smoothing length averaged over each pair";
  static constexpr bool reads_spacing = true;
  double twice_inverse_ratio;

  explicit PairSmoothing(const Setting& s) : twice_inverse_ratio(2.0 / s.smoothing_length_ratio) {}
  template <class Number, class Other>
  auto inverse(Number spacing_a, Other spacing_b) const {
    return twice_inverse_ratio / (spacing_a + spacing_b);
  }
};

}  // namespace slosh::sph
