#include "verification/evidence/history_uncertainty.hpp"

#include <algorithm>
#include <cmath>

#include "verification/case/quantities.hpp"
#include "verification/convergence/error_expansion_fit.hpp"
#include "verification/evidence/refinement.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/time_series.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr double cautious_safety_factor = 3;  // Oberkampf & Roy 2010, chapter 8
constexpr double order_too_high = 2.1;        // discretisation_uncertainty.hpp

// The values of one run of a path at the sample times of the run whose uncertainty is wanted.
struct HistoryAtStep {
  double step;
  std::vector<double> value;
};

// The run itself and those coarser runs that can be read at its times, finest first.
std::vector<HistoryAtStep> histories(const CaseDefinition& definition, const CaseRuns& runs,
                                     const RefinementDefinition& path, const std::string& own,
                                     const TimeSeries& series) {
  std::vector<HistoryAtStep> found;
  const double own_step = step_of(path.number, run_named(definition, own), runs);
  for (const std::string& name : path.runs) {
    if (!runs.results.contains(name)) continue;
    const double step = step_of(path.number, run_named(definition, name), runs);
    if (name != own && step < least_refinement_ratio * own_step) continue;
    try {
      const TimeSeries whole = cut_to_window(runs.results.at(name).at(series.name),
                                             {series.time.front(), series.time.back()});
      found.push_back(
          {step, whole.time == series.time ? whole.value : interpolate(whole, series.time)});
    } catch (const std::runtime_error&) {
      continue;  // ComparisonError or ResultError: this run has no such history
    }
  }
  std::sort(found.begin(), found.end(),
            [](const HistoryAtStep& a, const HistoryAtStep& b) { return a.step < b.step; });
  const auto repeated =
      std::unique(found.begin(), found.end(), [](const HistoryAtStep& a, const HistoryAtStep& b) {
        return b.step < least_refinement_ratio * a.step;
      });
  found.erase(repeated, found.end());
  return found;
}

// The factor of |f2 - f1| in the uncertainty.
double factor_of(const std::vector<HistoryAtStep>& path) {
  const double ratio = path[1].step / path[0].step;
  if (path.size() == 2) return cautious_safety_factor / std::min(1.0, ratio - 1);
  const double fine = rms(minus(path[1].value, path[0].value)),
               coarse = rms(minus(path[2].value, path[1].value));
  const double observed =
      three_grid_order({path[0].step, 0}, {path[1].step, fine}, {path[2].step, fine + coarse})
          .value_or(0);
  const bool reliable = observed >= reliable_orders.low && observed < order_too_high;
  const double order = std::clamp(observed, reliable_orders.low, reliable_orders.high);
  return (reliable ? reliable_safety_factor : cautious_safety_factor) /
         (std::pow(ratio, order) - 1);
}

void add_in_quadrature(std::vector<double>& widths, const std::vector<double>& apart,
                       double factor) {
  widths.resize(apart.size());
  for (std::size_t i = 0; i < apart.size(); ++i)
    widths[i] = std::hypot(widths[i], factor * apart[i]);
}

// The difference of the run with fewer nodes from the run at its samples. Potential flow ends where
// it leaves its range: the difference is NaN where only one of the two runs has a sample.
std::vector<double> apart_from(const TimeSeries& coarse, const TimeSeries& series) {
  std::vector<double> apart(series.value.size(), not_a_number);
  for (std::size_t i = 0; i < std::min(apart.size(), coarse.value.size()); ++i)
    if (coarse.time.at(i) == series.time.at(i)) apart[i] = coarse.value[i] - series.value[i];
  return apart;
}

}  // namespace

std::vector<double> numerical_half_widths(const CaseDefinition& definition, const CaseRuns& runs,
                                          const std::string& run, const std::string& quantity) {
  const TimeSeries& series = runs.results.at(run).at(quantity);
  std::vector<double> widths;
  for (const RefinementDefinition& path : definition.refinements) {
    if (std::find(path.runs.begin(), path.runs.end(), run) == path.runs.end()) continue;
    const std::vector<HistoryAtStep> found = histories(definition, runs, path, run, series);
    // The path is of no use without the run's own history, and where the next step changes nothing.
    if (found.size() < 2 ||
        found[0].step > step_of(path.number, run_named(definition, run), runs) ||
        are_same(series, {series.name, series.unit, series.time, found[1].value},
                 {series.time.front(), series.time.back()}))
      continue;
    add_in_quadrature(widths, minus(found[1].value, found[0].value), factor_of(found));
  }
  if (has_series(runs, run, quantity + coarser))
    add_in_quadrature(widths, apart_from(runs.results.at(run).at(quantity + coarser), series), 1);
  return widths;
}

}  // namespace slosh
