#include "verification/gate/distributions/solver_panel.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/series/distribution.hpp"

namespace slosh {
namespace {

using boost::math::students_t;

double square(double x) { return x * x; }

double freedom(const SolverMean& one) { return static_cast<double>(one.members) - 1; }

// A mean and its variance.
struct Drawn {
  double mean, variance;
};

// Members that are all equal scatter by rounding.
Drawn drawn_of(const SolverMean& one) {
  constexpr double rounding = 1e-12;
  const double deviation = std::max(one.deviation, rounding * std::abs(one.mean));
  return {one.mean, std::max(square(deviation) / static_cast<double>(one.members),
                             std::numeric_limits<double>::min())};
}

// The weighted mean of all but one, and the variance of that mean.
Drawn weighted_mean(const std::vector<Drawn>& all, std::size_t left_out, double tau2) {
  double weights = 0, sum = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == left_out) continue;
    const double weight = 1 / (tau2 + all[i].variance);
    weights += weight;
    sum += weight * all[i].mean;
  }
  return {sum / weights, 1 / weights};
}

// Q of all but one.
double heterogeneity(const std::vector<Drawn>& all, std::size_t left_out) {
  const double middle = weighted_mean(all, left_out, 0).mean;
  double sum = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i != left_out) sum += square(all[i].mean - middle) / all[i].variance;
  return sum;
}

// The unweighted mean of all but one, the variance of their means, and the mean of the variances
// that these have by sampling.
struct Spread {
  double middle = 0, of_means = 0, own = 0;
};

Spread spread_of(const std::vector<Drawn>& all, std::size_t left_out) {
  const double others = static_cast<double>(all.size()) - 1;
  Spread spread;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == left_out) continue;
    spread.middle += all[i].mean / others;
    spread.own += all[i].variance / others;
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i != left_out) spread.of_means += square(all[i].mean - spread.middle) / (others - 1);
  return spread;
}

double between_solvers(const std::vector<Drawn>& all, std::size_t left_out) {
  const Spread spread = spread_of(all, left_out);
  return std::max(0.0, spread.of_means - spread.own);
}

double further_solver_p(const std::vector<Drawn>& all, std::size_t j) {
  const Spread spread = spread_of(all, j);
  const double others = static_cast<double>(all.size()) - 1;
  const double of_one = std::max(spread.of_means, spread.own);
  const double t = std::abs(all[j].mean - spread.middle) /
                   std::sqrt(of_one * (1 + 1 / others) + all[j].variance);
  return 2 * boost::math::cdf(boost::math::complement(students_t(others - 1), t));
}

// m_j - m_o, and the deviation that T_j divides it by.
struct Distance {
  double difference, deviation;

  double statistic() const { return std::abs(difference) / deviation; }
};

Distance from_others(const std::vector<Drawn>& all, std::size_t j) {
  const double tau2 = between_solvers(all, j);
  const Drawn others = weighted_mean(all, j, tau2);
  return {all[j].mean - others.mean, std::sqrt(tau2 + all[j].variance + others.variance)};
}

// What the bootstrap draws for a solver: a normal number, and a chi-squared one over its degrees of
// freedom.
struct Deviates {
  double normal, scale;
};

class RandomDeviates {
 public:
  explicit RandomDeviates(std::uint64_t seed) : draws_(seed) {}

  double normal() {  // Box & Muller 1958
    const double radius = std::sqrt(-2 * std::log(uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }
  // Half of its degrees of freedom are exponential numbers; one that is left is a squared normal.
  double chi_squared(std::size_t degrees) {
    double sum = degrees % 2 == 1 ? square(normal()) : 0;
    for (std::size_t k = 0; k < degrees / 2; ++k) sum -= 2 * std::log(uniform());
    return sum;
  }

 private:
  double uniform() { return (static_cast<double>(draws_.below(1'000'000'000)) + 0.5) * 1e-9; }

  SeededDraws draws_;
};

using Draw = std::vector<Deviates>;

std::vector<Draw> random_draws(const std::vector<SolverMean>& solvers, const SeededTrials& draws) {
  RandomDeviates random(draws.seed);
  std::vector<Draw> all(static_cast<std::size_t>(draws.count));
  for (Draw& draw : all)
    for (const SolverMean& one : solvers) {
      const double normal = random.normal();
      draw.push_back({normal, random.chi_squared(one.members - 1) / freedom(one)});
    }
  return all;
}

// Solvers of one mean, which scatter by tau beside their own sampling.
std::vector<Drawn> drawn_anew(const std::vector<Drawn>& all, const Draw& draw, double tau2) {
  std::vector<Drawn> anew;
  for (std::size_t i = 0; i < all.size(); ++i)
    anew.push_back({std::sqrt(all[i].variance + tau2) * draw[i].normal,
                    std::max(all[i].variance * draw[i].scale, std::numeric_limits<double>::min())});
  return anew;
}

double share_reached(const std::vector<double>& values, double reached) {
  const auto as_large =
      std::count_if(values.begin(), values.end(), [&](double value) { return value >= reached; });
  return (static_cast<double>(as_large) + 1) / (static_cast<double>(values.size()) + 1);
}

constexpr std::size_t nobody = static_cast<std::size_t>(-1);

// `equal` are draws of equal solvers that do not scatter beside their sampling.
double agreement(const std::vector<Drawn>& all, std::size_t left_out,
                 const std::vector<std::vector<Drawn>>& equal) {
  std::vector<double> values;
  for (const std::vector<Drawn>& draw : equal) values.push_back(heterogeneity(draw, left_out));
  return share_reached(values, heterogeneity(all, left_out));
}

SolverApart against_others(const std::vector<Drawn>& all, std::size_t j,
                           const std::vector<Draw>& draws,
                           const std::vector<std::vector<Drawn>>& equal) {
  const Distance found = from_others(all, j);
  const double tau2 = between_solvers(all, j);
  std::vector<double> values;
  for (std::size_t k = 0; k < draws.size(); ++k)
    values.push_back(
        from_others(tau2 > 0 ? drawn_anew(all, draws[k], tau2) : equal[k], j).statistic());
  const double p = share_reached(values, found.statistic());
  const double widest = Distribution("bootstrap", std::move(values)).quantile(1 - panel_level);
  return {{found.difference, widest * found.deviation},
          p,
          p,
          agreement(all, j, equal),
          further_solver_p(all, j)};
}

void correct_by_holm(std::vector<SolverApart>& each, double SolverApart::*p,
                     double SolverApart::*corrected) {
  std::vector<SolverApart*> ordered;
  for (SolverApart& one : each) ordered.push_back(&one);
  std::sort(ordered.begin(), ordered.end(),
            [&](const SolverApart* a, const SolverApart* b) { return a->*p < b->*p; });
  double largest = 0;
  for (std::size_t rank = 0; rank < ordered.size(); ++rank) {
    const double factor = static_cast<double>(ordered.size() - rank);
    largest = std::max(largest, std::min(1.0, factor * (ordered[rank]->*p)));
    ordered[rank]->*corrected = largest;
  }
}

double welch_half_width(double a, double b, double freedom_a, double freedom_b) {
  if (!(a + b > 0)) return a + b == 0 ? 0 : not_a_number;
  const double degrees = square(a + b) / (a * a / freedom_a + b * b / freedom_b);
  return boost::math::quantile(students_t(degrees), 0.975) * std::sqrt(a + b);
}

double variance_of_mean(const SolverMean& one) {
  return square(one.deviation) / static_cast<double>(one.members);
}

}  // namespace

Estimate SolverMean::estimate() const {
  return {mean, boost::math::quantile(students_t(freedom(*this)), 0.975) *
                    std::sqrt(variance_of_mean(*this))};
}

SolverMean solver_mean(const std::vector<double>& values) {
  if (values.size() < fewest_members)
    throw std::invalid_argument("a solver of a panel has three members or more");
  const Distribution sample("members", values);
  return {sample.mean(), sample.standard_deviation(), values.size()};
}

PanelVerdict judge_panel(const std::vector<SolverMean>& solvers, const SeededTrials& draws) {
  if (solvers.size() < 2) throw std::invalid_argument("a panel has two solvers or more");
  std::vector<Drawn> all;
  for (const SolverMean& one : solvers) all.push_back(drawn_of(one));
  const std::vector<Draw> random = random_draws(solvers, draws);
  std::vector<std::vector<Drawn>> equal;
  for (const Draw& draw : random) equal.push_back(drawn_anew(all, draw, 0));
  PanelVerdict verdict{agreement(all, nobody, equal), {}, {}, {}};
  if (solvers.size() < fewest_solvers) return verdict;
  for (std::size_t j = 0; j < all.size(); ++j)
    verdict.each.push_back(against_others(all, j, random, equal));
  correct_by_holm(verdict.each, &SolverApart::p, &SolverApart::corrected_p);
  correct_by_holm(verdict.each, &SolverApart::further_solver_p, &SolverApart::further_solver_p);
  if (verdict.all_agree()) return verdict;
  for (std::size_t j = 0; j < all.size(); ++j) {
    const SolverApart& one = verdict.each[j];
    if (one.others_agree_p >= panel_level && one.corrected_p < panel_level)
      verdict.apart.push_back(j);
  }
  if (verdict.apart.size() == 1) verdict.odd = verdict.apart.front();
  return verdict;
}

Estimate ratio_less_one(const SolverMean& one, const SolverMean& other) {
  const double ratio = one.mean / other.mean;
  return {ratio - 1, welch_half_width(variance_of_mean(one) / square(other.mean),
                                      square(ratio) * variance_of_mean(other) / square(other.mean),
                                      freedom(one), freedom(other))};
}

Estimate difference_of(const SolverMean& one, const SolverMean& other) {
  return {one.mean - other.mean, welch_half_width(variance_of_mean(one), variance_of_mean(other),
                                                  freedom(one), freedom(other))};
}

}  // namespace slosh
