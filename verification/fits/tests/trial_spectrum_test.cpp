#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "verification/fits/dense_algebra.hpp"
#include "verification/fits/local_noise.hpp"
#include "verification/series/fourier_transform.hpp"

namespace slosh::trial_spectrum_test {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using std::numbers::pi;

constexpr double span = 12, interval = 0.03;

VectorXd times() { return VectorXd::LinSpaced(400, 0.5 * interval, 399.5 * interval); }

// A mean, a trend and a tone, as the fits have them in addition to the searched tones.
MatrixXd basis() {
  MatrixXd columns(times().size(), 4);
  columns.col(0).setOnes();
  columns.col(1) = times();
  columns.rightCols<2>() = tone_columns(times(), {2.1, 0});
  return orthonormal(unit_columns(columns), 1e-12);
}

VectorXd tone(const ToneShape& shape, double phase) {
  return tone_columns(times(), shape) * Eigen::Vector2d(std::cos(phase), std::sin(phase));
}

// The best tone by least squares, one trial after the other.
double explained_by(const ToneShape& shape, const VectorXd& value) {
  MatrixXd columns(times().size(), basis().cols() + 2);
  columns << basis(), tone_columns(times(), shape);
  const MatrixXd all = orthonormal(unit_columns(columns), 1e-12);
  return (all.transpose() * value).squaredNorm() - (basis().transpose() * value).squaredNorm();
}

TEST(TrialSpectrum, FindsTheToneThatLeastSquaresFindsToExplainMost) {
  const std::vector<double> decay_rates{0, 2 / span};
  const auto any = [](const ToneShape&) { return true; };
  const TrialSpectrum trials(times(), pi / span, 9, pi / span, decay_rates, any);
  const VectorXd value = tone({5.03, 0.15}, 0.7) + 0.3 * tone({3.0, 0}, 2) + tone({2.1, 0}, 1);
  const ToneShape best = trials.best(value, basis());
  const double grid = 2 * pi / (static_cast<double>(fast_length(800)) * interval);
  ToneShape expected{};
  double most = -1;
  for (Index place = 2; static_cast<double>(place) * grid < 9; ++place) {
    for (const double decay_rate : decay_rates) {
      const ToneShape shape{static_cast<double>(place) * grid, decay_rate};
      if (explained_by(shape, value) > most) {
        most = explained_by(shape, value);
        expected = shape;
      }
    }
  }
  EXPECT_NEAR(best.angular_frequency, expected.angular_frequency, 1e-12);
  EXPECT_EQ(best.decay_rate, expected.decay_rate);
  EXPECT_NEAR(best.angular_frequency, 5.03, 0.5 * pi / span);
}

TEST(TrialSpectrum, TriesOnlyWhatIsAdmitted) {
  const auto below_four = [](const ToneShape& shape) { return shape.angular_frequency < 4; };
  const TrialSpectrum trials(times(), pi / span, 9, pi / span, {0}, below_four);
  EXPECT_LT(trials.best(tone({5.03, 0}, 0.7), basis()).angular_frequency, 4);
  const auto none = [](const ToneShape&) { return false; };
  EXPECT_TRUE(TrialSpectrum(times(), pi / span, 9, pi / span, {0}, none).empty());
}

TEST(FourierTransforms, SumTheSamplesTimesTheirTurns) {
  const MatrixXd columns = MatrixXd::Random(7, 2);
  const Eigen::MatrixXcd found = fourier_transforms(columns, 12);
  ASSERT_EQ(found.rows(), 7);
  for (Index j = 0; j < found.rows(); ++j) {
    for (Index k = 0; k < 2; ++k) {
      std::complex<double> sum = 0;
      for (Index i = 0; i < 7; ++i)
        sum += columns(i, k) * std::polar(1.0, -2 * pi * static_cast<double>(i * j) / 12);
      EXPECT_NEAR(std::abs(found(j, k) - sum), 0, 1e-14);
    }
  }
}

TEST(FourierTransforms, HaveLengthsWithoutLargePrimeFactors) {
  EXPECT_EQ(fast_length(1), 1);
  EXPECT_EQ(fast_length(7), 8);
  EXPECT_EQ(fast_length(1901), 1920);
}

}  // namespace
}  // namespace slosh::trial_spectrum_test
