#include "verification/gate/distributions/spacing_study.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "verification/series/distribution.hpp"

namespace slosh {
namespace {

constexpr double nearly = 1 - 1e-12;  // two orders of one sum differ by less

using Member = std::vector<double>;        // the figure of each impact
using Members = std::vector<Member>;       // of one ensemble
using BothSides = std::array<Members, 2>;  // whose members may be exchanged
using Statistic = std::function<double(const std::vector<BothSides>& strata)>;

double value_of(const ImpactNumbers& impact, ImpactFigure figure, std::size_t n) {
  const bool occurs =
      figure == ImpactFigure::peak ? impact.peak.has_value() : impact.arrival.has_value();
  if (!occurs)
    throw ComparisonError(fmt::format("impact_{} does not occur in a member of the study", n + 1));
  return figure == ImpactFigure::peak ? std::log(impact.peak->pressure) : *impact.arrival;
}

Members figures_of(const ImpactEnsemble& ensemble, ImpactFigure figure) {
  if (ensemble.empty()) throw ComparisonError("an ensemble of a study of spacings has no member");
  Members members;
  for (const std::vector<ImpactNumbers>& impacts : ensemble) {
    members.emplace_back();
    for (std::size_t n = 0; n < impacts.size(); ++n)
      members.back().push_back(value_of(impacts[n], figure, n));
  }
  return members;
}

Member experiment_of(const CaseDefinition& definition, ImpactFigure figure) {
  if (!definition.impacts || !definition.impacts->arrivals)
    throw ComparisonError("the case " + definition.name + " publishes no arrivals of impacts");
  if (figure == ImpactFigure::arrival) return definition.impacts->arrivals->times;
  Member peaks;
  for (std::size_t n = 0; n < definition.impacts->peak_means.size(); ++n)
    peaks.push_back(std::log(definition.impacts->repeats.empty()
                                 ? definition.impacts->peak_means[n]
                                 : repeated_peaks(definition, n).quantile(0.5)));
  return peaks;
}

Member means_of(const Members& members) {
  Member means;
  for (std::size_t n = 0; n < members.front().size(); ++n) {
    means.push_back(0);
    for (const Member& one : members)
      means.back() += one.at(n) / static_cast<double>(members.size());
  }
  return means;
}

double mean_distance(const Member& from, const Member& to) {
  double sum = 0;
  for (std::size_t n = 0; n < from.size(); ++n) sum += std::abs(from[n] - to.at(n));
  return sum / static_cast<double>(from.size());
}

// The members of both sides in a random order, the sizes of the sides as they are.
BothSides exchanged(const BothSides& sides, SeededDraws& draws) {
  Members all = sides[0];
  all.insert(all.end(), sides[1].begin(), sides[1].end());
  for (std::size_t i = 0; i < sides[0].size(); ++i)
    std::swap(all[i], all[i + draws.below(all.size() - i)]);
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(sides[0].size());
  return {Members(all.begin(), middle), Members(middle, all.end())};
}

ExchangeTest test(const std::vector<BothSides>& strata, const Statistic& statistic,
                  const SeededTrials& trials) {
  const double found = statistic(strata), reached = std::abs(found) * nearly;
  SeededDraws draws(trials.seed);
  int as_large = 0;
  for (int k = 0; k < trials.count; ++k) {
    std::vector<BothSides> divided;
    for (const BothSides& sides : strata) divided.push_back(exchanged(sides, draws));
    as_large += std::abs(statistic(divided)) >= reached ? 1 : 0;
  }
  return {found, (as_large + 1.0) / (trials.count + 1.0)};
}

void require_spacings(const SpacingStudy& study) {
  if (study.size() < 2)
    throw ComparisonError(
        fmt::format("a study of {} spacing(s); expected two or more", study.size()));
}

// c of the members on one side, coarse to fine.
double change(const std::vector<BothSides>& strata, std::size_t side) {
  const Member finest = means_of(strata.back()[side]);
  double sum = 0;
  for (std::size_t k = 0; k + 1 < strata.size(); ++k)
    sum += mean_distance(means_of(strata[k][side]), finest);
  return sum / static_cast<double>(strata.size() - 1);
}

}  // namespace

double distance_to_experiment(const ImpactEnsemble& ensemble, ImpactFigure figure,
                              const CaseDefinition& definition) {
  return mean_distance(means_of(figures_of(ensemble, figure)), experiment_of(definition, figure));
}

ExchangeTest nearer_when_finer(const SpacingStudy& study, ImpactFigure figure,
                               const CaseDefinition& definition, const SeededTrials& trials) {
  require_spacings(study);
  const Member experiment = experiment_of(definition, figure);
  const auto distance = [&](const Members& members) {
    return mean_distance(means_of(members), experiment);
  };
  return test(
      {{figures_of(study.front(), figure), figures_of(study.back(), figure)}},
      [&](const std::vector<BothSides>& ends) {
        return distance(ends[0][0]) - distance(ends[0][1]);
      },
      trials);
}

ExchangeTest changes_less(const SpacingStudy& first, const SpacingStudy& second,
                          ImpactFigure figure, const SeededTrials& trials) {
  require_spacings(first);
  if (first.size() != second.size())
    throw ComparisonError(fmt::format("studies of {} and {} spacings; expected the same spacings",
                                      first.size(), second.size()));
  std::vector<BothSides> strata;
  for (std::size_t k = 0; k < first.size(); ++k)
    strata.push_back({figures_of(first[k], figure), figures_of(second[k], figure)});
  return test(
      strata, [](const std::vector<BothSides>& ways) { return change(ways, 1) - change(ways, 0); },
      trials);
}

}  // namespace slosh
