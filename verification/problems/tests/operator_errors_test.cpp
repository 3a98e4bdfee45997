// The pair sums on fields whose derivatives are known: right ones have their order, and ones that
// are wrong by a twentieth fail the gate.
#include "verification/problems/tests/operator_errors.hpp"

#include <gtest/gtest.h>

#include "verification/assessment/problem_assessment.hpp"

namespace slosh::operator_errors_test {
namespace {

// The pressure's part of the momentum equation a twentieth too large.
struct TooStrong : sph::VolumeWeighted {
  using VolumeWeighted::VolumeWeighted;
  template <class Number>
  Number strength(Number pressure, Number density) const {
    return 1.05 * VolumeWeighted::strength(pressure, density);
  }
};
struct WithWrongGradient : sph::Recommended {
  using Formulation = TooStrong;
};

}  // namespace
}  // namespace slosh::operator_errors_test

namespace slosh::sph {
// No start is projected with it.
template <>
std::shared_ptr<const SchemeTerms> compiled_operators(
    const PressureAlone<PairTermsOf<Measured<operator_errors_test::WithWrongGradient>>>&) {
  return nullptr;
}
}  // namespace slosh::sph

namespace slosh::operator_errors_test {
namespace {

template <class Choice>
ProblemRun run_of(double OperatorErrors::*errors) {
  ProblemResult result;
  MeasuredErrors measure{"gradient", {}};
  for (const int cells : {24, 32, 48}) {
    const Resolution resolution{cells, 3 * std::sqrt(cells / 32.0), 0};
    measure.errors.push_back(
        {resolution.smoothing_length(), operator_errors<Choice>(resolution).*errors});
  }
  result.outcome.measures = {std::move(measure)};
  return {{RunState::finished, ""}, std::move(result)};
}

const ProblemGateRow second_order{"gradient", ProblemMetric::order_at_least, "1", 1.9, {}, "", "",
                                  {}};
// The smoothing of the quintic at the finest, (k h)^2 times half its second moment, is 1.24e-2.
const ProblemGateRow small{"gradient", ProblemMetric::error_at_finest, "1", 0.0135, {}, "", "", {}};

TEST(OperatorErrors, AreOfSecondOrderInTheSmoothingLength) {
  for (const auto errors :
       {&OperatorErrors::gradient, &OperatorErrors::divergence, &OperatorErrors::diffusion}) {
    const ProblemRun run = run_of<sph::Recommended>(errors);
    EXPECT_EQ(evaluate(second_order, run).verdict, Verdict::pass)
        << evaluate(second_order, run).message;
    EXPECT_EQ(evaluate(small, run).verdict, Verdict::pass) << evaluate(small, run).message;
  }
}

TEST(OperatorErrors, OfAGradientThatIsATwentiethTooLargeFailTheGate) {
  const ProblemRun run = run_of<WithWrongGradient>(&OperatorErrors::gradient);
  EXPECT_EQ(evaluate(second_order, run).verdict, Verdict::violated);
  EXPECT_EQ(evaluate(small, run).verdict, Verdict::violated);
  EXPECT_EQ(evaluate(second_order, run_of<WithWrongGradient>(&OperatorErrors::divergence)).verdict,
            Verdict::pass);
}

TEST(OperatorErrors, OfScatteredParticlesDivergeWhereTheSumIsOfPressures) {
  const OperatorErrors coarse = operator_errors<sph::Recommended>({24, 1.5, 0.1}),
                       fine = operator_errors<sph::Recommended>({48, 1.5, 0.1});
  EXPECT_NEAR(fine.gradient / coarse.gradient, 2, 0.3);
  EXPECT_NEAR(fine.viscosity / coarse.viscosity, 2, 0.3);
  EXPECT_NEAR(fine.divergence / coarse.divergence, 1, 0.15);
}

// Of the transform of a Gaussian no closed form is at hand; that of any kernel begins with 1 - (k
// h)^2 / 4 times its second moment.
TEST(KeptOfWave, FallsWithTheSquareOfTheWaveNumber) {
  EXPECT_NEAR(kept_of_wave<sph::QuinticSpline>(0), 1, 1e-6);
  const double loss = 1 - kept_of_wave<sph::QuinticSpline>(0.2);
  EXPECT_NEAR((1 - kept_of_wave<sph::QuinticSpline>(0.1)) / loss, 0.25, 2e-3);
}

}  // namespace
}  // namespace slosh::operator_errors_test
