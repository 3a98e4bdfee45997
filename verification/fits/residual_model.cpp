#include "verification/fits/residual_model.hpp"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "verification/fits/dense_algebra.hpp"
#include "verification/fits/local_noise.hpp"

namespace slosh {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using std::numbers::pi;

constexpr int most_further_tones = 3;
constexpr double chance_level = 1e-5;
constexpr int tested_half_band = 14;
// As a multiple of the highest requested frequency: a tone above it does not affect a requested
// one.
constexpr double highest_searched = 3;
constexpr double round_off = 1e-9;        // of the residual: less than this is no tone
constexpr double samples_per_period = 8;  // of the highest frequency searched

// The means of groups of `stride` successive samples.
MatrixXd thinned(const MatrixXd& columns, Index stride) {
  MatrixXd means(columns.rows() / stride, columns.cols());
  for (Index k = 0; k < means.cols(); ++k)
    for (Index i = 0; i < means.rows(); ++i)
      means(i, k) = columns.col(k).segment(i * stride, stride).mean();
  return means;
}

double highest_frequency(const FitResidual& residual) {
  double highest = 0;
  for (const ToneShape& tone : residual.requested)
    highest = std::max(highest, highest_searched * tone.angular_frequency);
  return highest;
}

struct ExtendedFit {
  std::vector<ToneShape> further;
  VectorXd coefficients;  // of the Jacobian's columns, then of the further tones
  FittedSamples samples;
};

MatrixXd basis_of(const MatrixXd& jacobian) { return orthonormal(unit_columns(jacobian), 1e-8); }

// The fit extended by further tones. Their derivatives by frequency and decay rate become columns
// of the Jacobian.
ExtendedFit extended(const FittedSamples& fit, std::vector<ToneShape> further) {
  const ToneFit tones = fit_tones(fit.elapsed, fit.residual, fit.jacobian, further);
  const Index linear = tones.basis.cols(), first = fit.jacobian.cols();
  MatrixXd jacobian(linear == 0 ? 0 : fit.elapsed.size(), 2 * linear - first);
  jacobian.leftCols(linear) = tones.basis;
  for (Index column = first; column < linear; column += 2) {
    const double a = tones.coefficients[column], b = tones.coefficients[column + 1];
    const auto cosine = tones.basis.col(column), sine = tones.basis.col(column + 1);
    const Index slope = linear + column - first;
    jacobian.col(slope) = fit.elapsed.cwiseProduct(b * cosine - a * sine);
    jacobian.col(slope + 1) = -fit.elapsed.cwiseProduct(a * cosine + b * sine);
  }
  return {std::move(further),
          tones.coefficients,
          {fit.elapsed, jacobian, basis_of(jacobian), tones.residual}};
}

std::vector<ToneRange> ranges_about(const std::vector<ToneShape>& tones, double span) {
  const double bin = 2 * pi / span;
  std::vector<ToneRange> ranges;
  for (const ToneShape& tone : tones) {
    const double w = tone.angular_frequency;
    ranges.push_back({{std::max(w - bin, 0.1 * bin), -2 / span}, {w + bin, 10 / span}});
  }
  return ranges;
}

// Whether the tones are closer than a spectral bin plus the first one's line width g / pi.
bool near(const ToneShape& tone, const ToneShape& other, double span) {
  return std::abs(tone.angular_frequency - other.angular_frequency) <
         2 * pi / span + 2 * std::abs(tone.decay_rate);
}

// The search for further tones.
class Search {
 public:
  // Searches up to the frequency `highest` [rad/s] in a window of length `span` [s], away from the
  // requested tones that are refined.
  Search(const VectorXd& elapsed, double highest, double span, std::vector<ToneShape> refined)
      : span_(span),
        refined_(std::move(refined)),
        trials_(elapsed, pi / span, highest, pi / span, {0, 2 / span},
                [this](const ToneShape& tone) { return admits(tone); }) {}

  bool admits(const ToneShape& tone) const {
    return std::none_of(refined_.begin(), refined_.end(),
                        [&](const ToneShape& other) { return near(tone, other, span_); });
  }

  // The fit with one further tone more than `now`, all of them refined together; `now` itself where
  // no tone is admitted.
  ExtendedFit with_one_more(const FittedSamples& fit, const ExtendedFit& now) const {
    if (trials_.empty()) return now;
    std::vector<ToneShape> tones = now.further;
    tones.push_back(trials_.best(now.samples.residual, now.samples.basis));
    // A gain of a millionth is far below the change that the F test detects.
    return extended(fit, refine_tones(fit.elapsed, fit.residual, fit.basis,
                                      ranges_about(tones, span_), tones, 1e-6));
  }

 private:
  double span_;
  std::vector<ToneShape> refined_;
  TrialSpectrum trials_;
};

// The fit with noise of this correlation whitened, so that a sloping spectrum does not pass for a
// tone.
struct WhiteFit {
  WhiteFit(const FittedSamples& fit, double correlation)
      : basis(orthonormal(whitened(fit.basis, correlation), 1e-10)),
        residual(whitened(fit.residual, correlation)) {
    residual -= basis * (basis.transpose() * residual);
  }
  MatrixXd basis;
  VectorXd residual;
};

struct BandEnergy {
  double energy, freedom;
};

BandEnergy left_in(const MatrixXd& band, const WhiteFit& fit) {
  return {(band.transpose() * fit.residual).squaredNorm(),
          static_cast<double>(band.cols()) - transposed_product(fit.basis, band).squaredNorm()};
}

// The probability that noise alone loses this share of its energy.
double chance(const BandEnergy& before, const BandEnergy& after) {
  if (after.freedom < 4 || !(before.energy > after.energy)) return 1;
  const double spent = std::max(before.freedom - after.freedom, 1.0);
  const double ratio = (before.energy - after.energy) / spent / (after.energy / after.freedom);
  const boost::math::fisher_f distribution(spent, after.freedom);
  return std::isfinite(ratio) ? cdf(complement(distribution, ratio)) : 0;
}

double likeliest_correlation(const FittedSamples& fit) {
  const std::vector<LikelyNoise> noises = likely_noises(fit);
  return std::max_element(noises.begin(), noises.end(),
                          [](const auto& a, const auto& b) { return a.weight < b.weight; })
      ->correlation;
}

ExtendedFit choose(const FittedSamples& fit, const std::vector<ToneShape>& requested,
                   const Search& search, double span) {
  std::vector<MatrixXd> bands;
  for (const ToneShape& tone : requested)
    bands.push_back(band_about(fit.elapsed, tone.angular_frequency, span, tested_half_band));
  ExtendedFit chosen = extended(fit, {}), longest = chosen;
  const double correlation = likeliest_correlation(chosen.samples);
  const auto energies = [&](const ExtendedFit& of) {
    const WhiteFit white(of.samples, correlation);
    std::vector<BandEnergy> left;
    for (const MatrixXd& band : bands) left.push_back(left_in(band, white));
    return left;
  };
  std::vector<BandEnergy> before = energies(chosen);
  for (int count = 1; count <= most_further_tones; ++count) {
    if (!(longest.samples.residual.norm() > round_off * fit.residual.norm())) break;
    longest = search.with_one_more(fit, longest);
    const auto& tones = longest.further;
    if (!std::all_of(tones.begin(), tones.end(),
                     [&](const auto& one) { return search.admits(one); }))
      continue;
    std::vector<BandEnergy> after = energies(longest);
    const auto falls = [](const BandEnergy& from, const BandEnergy& to) {
      return chance(from, to) < chance_level;
    };
    if (std::transform_reduce(before.begin(), before.end(), after.begin(), false,
                              std::logical_or<>(), falls)) {
      chosen = longest;
      before = std::move(after);
    }
  }
  return chosen;
}

std::optional<double> nearest_beside(const ToneShape& tone, const std::vector<ToneShape>& further,
                                     double span) {
  std::optional<double> nearest;
  for (const ToneShape& one : further) {
    const double distance = std::abs(one.angular_frequency - tone.angular_frequency);
    if (near(one, tone, span) &&
        !(nearest && distance >= std::abs(*nearest - tone.angular_frequency)))
      nearest = one.angular_frequency;
  }
  return nearest;
}

// The residual at as many samples as the frequencies searched need, with the columns of the known
// tones after those of the Jacobian.
FittedSamples thinned_samples(const FitResidual& residual, const std::vector<ToneShape>& known) {
  const double fewest = samples_per_period * highest_frequency(residual) * residual.span / (2 * pi);
  const auto stride =
      std::max<Index>(1, static_cast<Index>(static_cast<double>(residual.values.size()) / fewest));
  FittedSamples fit{thinned(residual.elapsed, stride),
                    thinned(residual.jacobian, stride),
                    {},
                    thinned(residual.values, stride)};
  Index next = fit.jacobian.cols();
  fit.jacobian.conservativeResize(Eigen::NoChange, next + 4 * static_cast<Index>(known.size()));
  for (const ToneShape& tone : known) {
    fit.jacobian.middleCols<2>(next) = tone_columns(fit.elapsed, tone);
    fit.jacobian.middleCols<2>(next + 2) =
        fit.elapsed.asDiagonal() * fit.jacobian.middleCols<2>(next);
    next += 4;
  }
  fit.basis = basis_of(fit.jacobian);
  return fit;
}

}  // namespace

ResidualModel model_residual(const FitResidual& residual, std::optional<std::size_t> asked,
                             const std::vector<ToneShape>& known) {
  const auto& [elapsed, jacobian, values, requested, ranges, span] = residual;
  std::vector<ToneShape> refined;
  for (std::size_t k = 0; k < requested.size(); ++k)
    if (ranges[k].refined()) refined.push_back(requested[k]);
  const FittedSamples fit = thinned_samples(residual, known);
  const Search search(fit.elapsed, highest_frequency(residual), span, refined);
  const ExtendedFit model = choose(fit, requested, search, span);

  ResidualModel found{.correction = VectorXd::Zero(jacobian.cols()),
                      .further = known,
                      .noise = std::vector<LocalNoise>(requested.size()),
                      .beside = std::vector<std::optional<double>>(requested.size())};
  found.further.insert(found.further.end(), model.further.begin(), model.further.end());
  // Without further tones the correction stays zero: the thinned residual is not exactly orthogonal
  // to the thinned columns.
  if (!found.further.empty()) found.correction = model.coefficients.head(jacobian.cols());
  const ParameterNoise of_parameters(model.samples, likely_noises(model.samples));
  for (std::size_t k = 0; k < requested.size(); ++k) {
    if (asked && k != *asked) continue;
    const double w = requested[k].angular_frequency;
    found.noise[k] = LocalNoise(model.samples, w, span, of_parameters);
    found.beside[k] = nearest_beside(requested[k], found.further, span);
    if (!found.noise[k].known() && !found.beside[k]) found.beside[k] = w;
  }
  return found;
}

VectorXd correction_by(const FitResidual& residual, const std::vector<ToneShape>& known) {
  if (known.empty()) return VectorXd::Zero(residual.jacobian.cols());
  return extended(thinned_samples(residual, known), {}).coefficients.head(residual.jacobian.cols());
}

std::vector<ToneShape> of_either(const std::vector<ToneShape>& tones,
                                 const std::vector<ToneShape>& others, const ToneShape& requested,
                                 double span) {
  const double bin = 2 * pi / span;
  std::vector<ToneShape> found;
  for (const auto* of : {&tones, &others})
    for (const ToneShape& one : *of)
      if (one.angular_frequency >= bin && !near(one, requested, span) &&
          std::none_of(found.begin(), found.end(), [&](const ToneShape& other) {
            return std::abs(one.angular_frequency - other.angular_frequency) < pi / span;
          }))
        found.push_back(one);
  return found;
}

}  // namespace slosh
