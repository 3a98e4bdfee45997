// How often the interval about a value holds the limit of its steps.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "verification/convergence/discretisation_uncertainty.hpp"

namespace slosh::limit_coverage_test {
namespace {

using Values = std::vector<ValueAtStep>;

// Manufactured data sets with normal noise show how often the interval about the finest value, with
// that value's own noise added in quadrature, holds the limit.
struct Coverage {
  int held = 0, tried = 0;
  double share() const { return static_cast<double>(held) / tried; }
};

enum class Family { power, first, second, mixed };

// The interval is about the finest value, or about that at the coarser step of the index. The steps
// are a factor of 1.25 to 2 apart, the errors of the finest value are 0.3 to 1.3, and the mixed
// expansion's second term is up to 0.3 of the first at the coarsest step, of either sign.
Coverage coverage_of(Family family, std::size_t count, double deviation, std::uint64_t seed,
                     std::size_t asked = 0) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal(0, 1);
  std::uniform_real_distribution<double> uniform(0, 1);
  Coverage coverage;
  for (; coverage.tried < 50; ++coverage.tried) {
    const double leading = (uniform(generator) < 0.5 ? -1 : 1) * (0.3 + uniform(generator));
    const double order = family == Family::power    ? 0.7 + 1.5 * uniform(generator)
                         : family == Family::second ? 2
                                                    : 1;
    const double ratio = 1.25 + 0.75 * uniform(generator);
    const double next = family == Family::mixed ? leading * (0.6 * uniform(generator) - 0.3) /
                                                      std::pow(ratio, count - 1)
                                                : 0;
    Values values;
    for (double h = 1; values.size() < count; h *= ratio)
      values.push_back(
          {h, 1 + leading * std::pow(h, order) + next * h * h + deviation * normal(generator),
           1.96 * deviation});
    const double uncertainty = discretisation_uncertainty(values, values[asked].step).uncertainty;
    const double half_width = std::hypot(uncertainty, values[asked].noise);
    if (std::abs(values[asked].value - 1) <= half_width + 1e-9) ++coverage.held;
  }
  return coverage;
}

TEST(DiscretisationUncertainty, HoldsTheLimitInNineteenOfTwentyManufacturedDataSets) {
  for (const Family family : {Family::power, Family::first, Family::second, Family::mixed}) {
    Coverage all;
    for (const std::size_t count : {3, 4, 5})
      for (const double deviation : {0.0, 0.01, 0.03, 0.1, 0.3}) {
        const Coverage one = coverage_of(family, count, deviation, 17 + count);
        // 86 %: three standard deviations below 95 % of 50.
        EXPECT_GE(one.share(), 0.86)
            << static_cast<int>(family) << ", " << count << " values, noise " << deviation;
        all.held += one.held;
        all.tried += one.tried;
      }
    EXPECT_GE(all.share(), 0.95) << static_cast<int>(family);
    RecordProperty("coverage_of_family_" + std::to_string(static_cast<int>(family)),
                   std::to_string(all.share()));
  }
}

TEST(DiscretisationUncertainty, HoldsTheLimitAboutTheCoarsestValueToo) {
  for (const Family family : {Family::power, Family::first, Family::second, Family::mixed}) {
    Coverage all;
    for (const std::size_t count : {3, 4, 5})
      for (const double deviation : {0.0, 0.01, 0.03, 0.1, 0.3}) {
        const Coverage one = coverage_of(family, count, deviation, 17 + count, count - 1);
        all.held += one.held;
        all.tried += one.tried;
      }
    EXPECT_GE(all.share(), 0.95) << static_cast<int>(family);
  }
}

}  // namespace
}  // namespace slosh::limit_coverage_test
