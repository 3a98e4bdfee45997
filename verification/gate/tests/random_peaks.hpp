// Samples of peaks of a known distribution, the same on every machine but for the last digit.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "verification/gate/distributions/seeded_draws.hpp"
#include "verification/series/distribution.hpp"

namespace slosh {

class RandomPeaks {
 public:
  explicit RandomPeaks(std::uint64_t seed) : draws_(seed) {}

  // Lognormal of the median 1 and a deviation of some 30 %, about that of the water's peaks of
  // SPHERIC benchmark 10, times the scale.
  Distribution sample(std::size_t size, double scale = 1) {
    std::vector<double> values(size);
    for (double& value : values) value = scale * std::exp(0.3 * normal());
    return {"peaks", std::move(values)};
  }

 private:
  double normal() {  // Box & Muller 1958
    const auto uniform = [&] {
      return (static_cast<double>(draws_.below(1'000'000'000)) + 0.5) * 1e-9;
    };
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

  SeededDraws draws_;
};

inline constexpr std::size_t of_candidate = 20, of_experiment = 102;

// Half the width in which a share of `trials` lies with 99.9 % if each happens with probability p.
inline double binomial_half_width(double p, int trials) {
  return 3.29 * std::sqrt(p * (1 - p) / trials);
}

}  // namespace slosh
