// What linear theory leaves out of a case's waves: the second and the third order of their
// steepness (reference/third_order_waves.hpp), as an estimate of its error. The waves are those of
// a rectangle as long as the still surface, of the fill depth or, for another section, of the depth
// that has the section's first natural frequency. The motion is scaled so that the linear waves
// have the height of linear theory at the right wall. Against nonlinear potential flow, rms, in
// rectangles of depths of 0.2 to 1 length: in standing waves up to k A = 0.2 and in surges the
// estimate is 0.8 to 1.25 times the truth for elevations, velocities, pressures and forces; in
// rolls of up to 0.08 it is 0.7 to 2.5 times where the truth exceeds a thousandth of the series
// (tests/beyond_linear_test.cpp).
#pragma once

#include <string>
#include <vector>

#include "reference/third_order_waves.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/results/result_file.hpp"
#include "verification/solvers/theory/sampled_flow.hpp"

namespace slosh {

// Each quantity of nonlinear flow less that of linear theory, at the case's sample times.
// `at_right` is the elevation of linear theory at the right end of the still surface [m]; with a
// viscosity [m2/s] the waves decay. The estimate is not finite where the waves are too steep for
// it.
class BeyondLinear : public SampledFlow {
 public:
  BeyondLinear(const CaseDefinition& definition, const std::vector<double>& at_right,
               double kinematic_viscosity = 0);

  std::vector<double> elevation(double x) const override;
  std::vector<double> pressure(Corner place) const override;
  std::vector<double> velocity_x(Corner place) const override;
  std::vector<double> velocity_z(Corner place) const override;
  std::vector<double> force_x() const override;
  bool has_moment() const override;
  std::vector<double> moment() const override;
  std::string modes_text() const override;

 private:
  Corner from_middle(Corner place) const;
  std::vector<double> sampled(const std::vector<double>& values) const;

  reference::ThirdOrderRecord record_;
  double interval_;
};

// Returns straight lines between values that are an interval apart, from 0 s on, at times [s]; the
// last value after them. Requires two values.
std::vector<double> at_times(const std::vector<double>& value, double interval,
                             const std::vector<double>& times);

// Adds the series with what is beyond it, with the suffix `nonlinear`, to the result where all of
// it is finite.
void add_moved(TimeSeries series, const std::vector<double>& beyond, RunResult& result);

}  // namespace slosh
