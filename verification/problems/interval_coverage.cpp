// Problem: the coverage of the 95 % intervals. In each scenario 400 pairs of synthetic series with
// known parameters (interval_scenarios.hpp) are compared as a campaign compares them; the share of
// the intervals that contain the truth should be 0.95. Where the window is too short to separate
// the tones the comparison should refuse the pair; refused pairs are counted separately. Source:
// Student 1908. The standard error of a share of 400 at 0.95 is 0.011, so that a deviation of 0.04
// is 3.7 standard errors: one of a hundred right shares deviates by more in one of fifty campaigns.
// Scenarios that the comparison should refuse have 1600 pairs: their share is held against 0.05
// itself, near which it lies (0.045), and of 400 pairs it is uncertain by 0.011.
#include <fmt/format.h>

#include <algorithm>

#include "verification/problems/interval_scenarios.hpp"
#include "verification/problems/problem_list.hpp"

namespace slosh {
namespace {

int draws_of(const IntervalScenario& scenario) { return scenario.to_be_refused ? 1600 : 400; }

double share_of(int count, int all) { return static_cast<double>(count) / all; }

// Integers make the value exact at the bounds, where 0.99 - 0.95 has a rounding error.
double excess_over_95_percent(int held, int judged) {
  return static_cast<double>(20 * held - 19 * judged) / (20 * judged);
}

// Without noise there is nothing that one interval in twenty should miss.
void add_errors(double place, const IntervalScenario& scenario, const IntervalCoverage& found,
                MeasuredErrors& measure) {
  for (const IntervalCoverage::Quantity& quantity : found.quantities) {
    const double excess = excess_over_95_percent(quantity.held, found.judged);
    measure.errors.push_back({place, scenario.without_noise ? std::min(0.0, excess) : excess});
  }
}

void add_rows(const IntervalScenario& scenario, const IntervalCoverage& found,
              reports::Table& table) {
  for (const IntervalCoverage::Quantity& quantity : found.quantities) {
    const bool any = found.judged > 0;
    table.rows.push_back(
        {scenario.name, scenario.meaning,
         fmt::format("{:.4g} s", scenario.window.end - scenario.window.begin), quantity.name,
         any ? fmt::format("{:.1f} %", 100 * share_of(quantity.held, found.judged)) : "none judged",
         any ? fmt::format("{:.2f}", quantity.mean_half_width / quantity.rms_error) : "",
         fmt::format("{} of {}", found.refused, draws_of(scenario))});
  }
}

ProblemOutcome run(bool quick) {
  ProblemOutcome outcome;
  MeasuredErrors noise{"coverage_noise", {}}, leftovers{"coverage_leftovers", {}};
  MeasuredErrors refused{"refused", {}}, answered{"answered_beyond_window", {}};
  reports::Table table;
  table.id = "interval_coverage-shares";
  table.title = "Share of the 95 % intervals that hold the truth";
  table.caption = "Of the pairs that are not refused.";
  table.header = {"scenario",   "what it adds",       "window", "quantity",
                  "held truth", "half width / error", "refused"};
  double place = 0;
  for (const IntervalScenario& scenario : interval_scenarios()) {
    ++place;
    if (quick && !scenario.quick) continue;
    const IntervalCoverage found = interval_coverage(scenario, draws_of(scenario));
    add_rows(scenario, found, table);
    if (scenario.to_be_refused) {
      answered.errors.push_back({place, share_of(found.judged, draws_of(scenario))});
    } else {
      if (!scenario.may_be_refused)
        refused.errors.push_back({place, share_of(found.refused, draws_of(scenario))});
      add_errors(place, scenario, found, scenario.deterministic_leftovers ? leftovers : noise);
    }
  }
  outcome.measures = {std::move(noise), std::move(leftovers), std::move(refused),
                      std::move(answered)};
  outcome.tables.push_back(std::move(table));
  return outcome;
}

}  // namespace

Problem interval_coverage_problem() {
  return {"interval_coverage",
          "Intervals that are 95 %",
          "Pairs of series with known differences, under noise, modulations and beats that no "
          "request names, are compared; the intervals are counted that hold the truth.",
          "Student 1908, Biometrika 6:1",
          "The candidate's forced mode is 2 % higher and 1 degree later than the reference's, its "
          "natural mode 2 % higher, 0.3 % faster and decaying at 0.05 1/s.",
          {{"coverage_noise", "1", "scenario",
            "share of the intervals that hold the truth, less 0.95, under noise", false},
           {"coverage_leftovers", "1", "scenario",
            "the same, beside modulations, beats and tones that no request names", false},
           {"refused", "1", "scenario", "share of the pairs that are refused", false},
           {"answered_beyond_window", "1", "scenario",
            "share of the pairs that are answered though the window tells nothing", false}},
          &run,
          60,
          true};
}

}  // namespace slosh
