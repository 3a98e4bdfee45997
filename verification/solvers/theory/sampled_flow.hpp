// A flow that is a sum of solutions at the case's sample times.
#pragma once

#include <cstddef>
#include <vector>

#include "verification/solvers/reference_tank.hpp"
#include "verification/solvers/theory/linear_flow.hpp"

namespace slosh {

class SampledFlow : public LinearFlow {
 protected:
  explicit SampledFlow(const CaseDefinition& definition)
      : definition_(definition), times_(sample_times(definition)) {}

  static void add(std::vector<double>& sum, const std::vector<double>& values) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += values[i];
  }
  // Returns value(t) at all times.
  template <class Value>
  std::vector<double> series(const Value& value) const {
    std::vector<double> values;
    for (const double t : times_) values.push_back(value(t));
    return values;
  }

  const CaseDefinition& definition_;
  const std::vector<double> times_;
};

}  // namespace slosh
