#include "verification/gate/distributions/bootstrap_interval.hpp"

#include <algorithm>

namespace slosh {
namespace {

Distribution drawn_anew(const Distribution& sample, SeededDraws& draws) {
  std::vector<double> values(sample.sorted().size());
  for (double& value : values) value = sample.sorted()[draws.below(values.size())];
  return {"a sample drawn anew", std::move(values)};
}

}  // namespace

Interval bootstrap_interval(const Distribution& one, const Distribution& other,
                            const TwoSampleFigure& figure, const SeededTrials& draws) {
  SeededDraws random(draws.seed);
  std::vector<double> figures;
  for (int k = 0; k < draws.count; ++k) {
    const Distribution first = drawn_anew(one, random), second = drawn_anew(other, random);
    figures.push_back(figure(first, second));
  }
  const Distribution spread("the figure of samples drawn anew", std::move(figures));
  return {.low = spread.quantile(0.025), .high = spread.quantile(0.975)};
}

Estimate wider_side(double value, const Interval& interval) {
  return {value, std::max(interval.high - value, value - interval.low)};
}

}  // namespace slosh
