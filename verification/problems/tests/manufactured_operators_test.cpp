// The order of the pair sums on manufactured fields (operator_errors.hpp), with k the fields' wave
// number. Source: Quinlan, Basa & Lastiwka 2006, Int. J. Numer. Meth. Eng. 66:2064; Monaghan 2005,
// Rep. Prog. Phys. 68:1703.
//   lattice     The smoothing error is (k h)^2 times half the kernel's second moment. The error
//               of the quadrature depends on h / dp alone: it is constant where that ratio is
//               constant, and of second order in h where the ratio grows.
//   scattered   sum_b V_b grad W_ab is no longer zero. An operator with the sum p_a + p_b or with a
//               second derivative has an error of disorder / (k h), of order -1 at constant h / dp;
//               one with the difference v_a - v_b has a constant relative error, of order 0. At
//               constant h both vanish as (dp / h)^2, because independent displacements average
//               out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "verification/problems/tests/operator_errors.hpp"

namespace slosh::manufactured_operators_test {
namespace {

using Errors = double OperatorErrors::*;
using ResolutionOf = std::function<Resolution(int cells)>;

// h / dp grows as the square root of the number of cells.
Resolution growing_ratio(int cells) { return {cells, 3 * std::sqrt(cells / 32.0), 0}; }
Resolution on_lattice(int cells) { return {cells, 1.5, 0}; }
Resolution scattered(int cells) { return {cells, 1.5, 0.1}; }
Resolution scattered_in_kept_smoothing(int cells) { return {cells, 1.5 * cells / 32.0, 0.1}; }

// The errors with 32, 64 and 128 cells, and the slope of their logarithm over that of 1 / cells.
struct Series {
  std::vector<double> errors;
  double order;
  double finest() const { return errors.back(); }
  double largest() const { return *std::max_element(errors.begin(), errors.end()); }
};

template <class Choice>
Series series_of(Errors which, const ResolutionOf& resolution) {
  Series series;
  for (const int cells : {32, 64, 128})
    series.errors.push_back(operator_errors<Choice>(resolution(cells)).*which);
  series.order = std::log2(series.errors.front() / series.errors.back()) / 2;
  return series;
}

// In h, which falls as the root of the spacing where h / dp grows.
double order_in_smoothing(const Series& series) { return 2 * series.order; }

TEST(ManufacturedOperators, AreOfSecondOrderInTheSmoothingLengthOnALattice) {
  for (const auto& [which, limit] : {std::pair{&OperatorErrors::gradient, 0.005},
                                     {&OperatorErrors::divergence, 0.005},
                                     {&OperatorErrors::diffusion, 0.0025}}) {
    const Series series = series_of<sph::Recommended>(which, growing_ratio);
    EXPECT_NEAR(order_in_smoothing(series), 2, 0.1);  // measured 1.99
    EXPECT_LE(series.finest(), limit);
  }
  const Series symmetric =
      series_of<sph::WithSymmetricPressure>(&OperatorErrors::gradient, growing_ratio);
  EXPECT_NEAR(order_in_smoothing(symmetric), 2, 0.1);
  EXPECT_LE(symmetric.finest(), 0.005);
}

// Smoothing and a quadrature error in (dp / h)^2, of opposite signs: the two cancel at the coarse
// end.
TEST(ManufacturedOperators, LoseOrderWhereTheViscousForcesErrorsCancel) {
  const Series series = series_of<sph::Recommended>(&OperatorErrors::viscosity, growing_ratio);
  EXPECT_GE(order_in_smoothing(series), 1);  // measured 1.57
  EXPECT_LE(series.finest(), 0.002);
}

// Beyond the smoothing the quadrature is left, a floor where h / dp is kept. The Kaiser-Bessel
// kernel's transform ends before the lattice's first wave number: next to none is left.
TEST(ManufacturedOperators, KeepAFloorOfTheLatticeThatTheKernelDecides) {
  const Errors beyond = &OperatorErrors::gradient_beyond_smoothing;
  EXPECT_LE(series_of<sph::Recommended>(beyond, growing_ratio).finest(), 5e-6);
  EXPECT_LE(series_of<sph::Recommended>(beyond, on_lattice).largest(), 1e-5);
  const Series quintic = series_of<sph::WithQuinticSpline>(beyond, on_lattice),
               wendland = series_of<sph::WithWendlandC2>(beyond, on_lattice);
  EXPECT_NEAR(quintic.order, 0, 0.1);
  EXPECT_NEAR(wendland.order, 0, 0.1);
  EXPECT_NEAR(quintic.largest(), 8.0e-4, 2e-4);
  EXPECT_NEAR(wendland.largest(), 2.6e-3, 4e-4);
}

TEST(ManufacturedOperators, DivergeOnScatteredParticlesButForTheDivergence) {
  for (const Errors which :
       {&OperatorErrors::gradient, &OperatorErrors::viscosity, &OperatorErrors::diffusion})
    EXPECT_NEAR(series_of<sph::Recommended>(which, scattered).order, -1, 0.1);
  const Series divergence = series_of<sph::Recommended>(&OperatorErrors::divergence, scattered);
  EXPECT_NEAR(divergence.order, 0, 0.1);
  EXPECT_LE(divergence.largest(), 0.045);
  EXPECT_GE(
      series_of<sph::Recommended>(&OperatorErrors::gradient, scattered_in_kept_smoothing).order,
      1.8);
}

}  // namespace
}  // namespace slosh::manufactured_operators_test
