#include "verification/fits/trial_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "verification/fits/dense_algebra.hpp"
#include "verification/series/fourier_transform.hpp"

namespace slosh {

using Eigen::Index, Eigen::MatrixXcd, Eigen::MatrixXd, Eigen::VectorXd;
using std::numbers::pi;

TrialSpectrum::TrialSpectrum(const VectorXd& elapsed, double low, double high, double spacing,
                             const std::vector<double>& decay_rates,
                             const std::function<bool(const ToneShape&)>& admits) {
  const Index count = elapsed.size();
  const double interval = (elapsed[count - 1] - elapsed[0]) / static_cast<double>(count - 1);
  // The factor allows for round-off.
  const auto least = static_cast<Index>(std::ceil((1 - 1e-9) * 2 * pi / (spacing * interval)));
  length_ = fast_length(std::max(least, count));
  step_ = 2 * pi / (static_cast<double>(length_) * interval);
  // The transforms must also hold twice each frequency.
  const auto last = std::min(static_cast<Index>(high / step_), (length_ / 2) / 2);
  for (const double decay_rate : decay_rates) {
    OneDecay one{decay_rate, (-decay_rate * elapsed).array().exp(), {}, {}};
    one.squares = fourier_transforms(one.envelope.cwiseAbs2(), length_);
    for (auto place = static_cast<Index>(std::ceil(low / step_)); place <= last; ++place)
      if (admits({static_cast<double>(place) * step_, decay_rate})) one.places.push_back(place);
    decays_.push_back(std::move(one));
  }
}

bool TrialSpectrum::empty() const {
  return std::all_of(decays_.begin(), decays_.end(),
                     [](const OneDecay& one) { return one.places.empty(); });
}

ToneShape TrialSpectrum::best(const VectorXd& value, const MatrixXd& basis) const {
  MatrixXd columns(basis.rows(), basis.cols() + 1);
  columns << orthogonal_part(value, basis), basis;
  double most = -1;
  ToneShape found{};
  for (const OneDecay& one : decays_) {
    // The real parts are the products with the cosine, the imaginary parts the negative products
    // with the sine, of a tone whose phase counts from the first time.
    const MatrixXcd products =
        fourier_transforms(one.envelope.asDiagonal() * columns, length_).transpose();
    const double sum = one.squares[0].real();
    for (const Index place : one.places) {
      const std::complex<double> twice = one.squares[2 * place], left = products(0, place);
      const auto taken = products.col(place).tail(basis.cols());
      const double cosines = 0.5 * (sum + twice.real()) - taken.real().squaredNorm(),
                   sines = 0.5 * (sum - twice.real()) - taken.imag().squaredNorm(),
                   mixed = -0.5 * twice.imag() + taken.real().dot(taken.imag());
      const double c = left.real(), s = -left.imag();
      const double explained =
          (sines * c * c - 2 * mixed * c * s + cosines * s * s) / (cosines * sines - mixed * mixed);
      if (explained > most) {
        most = explained;
        found = {static_cast<double>(place) * step_, one.decay_rate};
      }
    }
  }
  return found;
}

}  // namespace slosh
