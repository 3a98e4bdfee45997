#include "verification/assessment/across_runs/basket.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "verification/assessment/error_over_tolerance.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/run_cost.hpp"
#include "verification/gate/measured_value.hpp"

namespace slosh {
namespace {

using BasketMeasures = std::vector<BasketMeasure>;

bool is_in_basket(const CaseAssessment& one, const BasketMeasures& measures) {
  return std::any_of(measures.begin(), measures.end(), [&](const BasketMeasure& measure) {
    return measure.case_name == one.definition.name;
  });
}

std::vector<const CaseAssessment*> cases_of(const BasketMeasures& measures,
                                            const std::vector<CaseAssessment>& cases) {
  std::vector<const CaseAssessment*> found;
  for (const CaseAssessment& one : cases)
    if (is_in_basket(one, measures)) found.push_back(&one);
  return found;
}

bool is_reference(const std::string& run, const BasketMeasures& measures) {
  return std::any_of(measures.begin(), measures.end(),
                     [&](const BasketMeasure& one) { return one.row.reference == run; });
}

bool is_candidate(const RunDefinition& run, const CaseAssessment& of,
                  const BasketMeasures& measures) {
  return is_simulation(run) && !is_later_member(run) && !run.at_input &&
         !is_reference(run.name, measures) &&
         of.runs.status.at(run.name).state != RunState::not_selected;
}

// Whether the run is measured for the choice that its name begins with.
bool has_suffix(const std::string& run, const BasketMeasures& measures) {
  return std::any_of(measures.begin(), measures.end(), [&](const BasketMeasure& one) {
    return !one.run_suffix.empty() && run.ends_with(one.run_suffix);
  });
}

// Returns the names in the order in which the cases declare them.
std::vector<std::string> names_of_choices(const BasketMeasures& measures,
                                          const std::vector<const CaseAssessment*>& cases) {
  std::vector<std::pair<std::string, int>> counted;
  for (const CaseAssessment* one : cases)
    for (const RunDefinition& run : one->definition.runs) {
      if (!is_candidate(run, *one, measures)) continue;
      const auto known = std::find_if(counted.begin(), counted.end(),
                                      [&](const auto& other) { return other.first == run.name; });
      if (known == counted.end()) {
        counted.push_back({run.name, 1});
      } else {
        ++known->second;
      }
    }
  std::vector<std::string> names;
  for (const auto& [name, count] : counted)
    if (count >= 2 && !has_suffix(name, measures)) names.push_back(name);
  return names;
}

bool has_run(const CaseAssessment& one, const std::string& run) {
  return one.runs.status.contains(run);
}

BasketValue no_basket_value(const std::string& why) { return {no_value, not_a_number, why}; }

BasketValue value_of(const std::string& choice, const BasketMeasure& measure,
                     const std::vector<const CaseAssessment*>& cases) {
  const auto of = std::find_if(cases.begin(), cases.end(), [&](const CaseAssessment* one) {
    return one->definition.name == measure.case_name;
  });
  const std::string run = choice + measure.run_suffix;
  if (of == cases.end() || !has_run(**of, run))
    return no_basket_value(fmt::format("{} has no run {}", measure.case_name, run));
  GateRow row = measure.row;
  row.candidate = run;
  CaseEvidence evidence((*of)->definition, (*of)->runs, &(*of)->fitted);
  const GateOutcome outcome = evidence.judge(row);
  const double value = outcome.value.value;
  if (!std::isfinite(value)) return no_basket_value(outcome.message);
  return {{value, half_width_of(outcome)}, std::abs(value) / row.limit.value(), ""};
}

double core_seconds_of(const std::string& choice, const std::vector<const CaseAssessment*>& cases) {
  double sum = 0;
  for (const CaseAssessment* one : cases)
    sum += one->runs.results.contains(choice) ? cost_of(one->runs, choice).core_seconds.value
                                              : not_a_number;
  return sum;
}

BasketChoice assessed(const std::string& name, const BasketMeasures& measures,
                      const std::vector<const CaseAssessment*>& cases) {
  BasketChoice choice{name, {}, 0, 0, core_seconds_of(name, cases)};
  for (const BasketMeasure& measure : measures) {
    choice.values.push_back(value_of(name, measure, cases));
    choice.worst = std::max(choice.worst, choice.values.back().ratio);
    choice.mean += choice.values.back().ratio / static_cast<double>(measures.size());
  }
  if (missing_values(choice) > 0) choice.worst = choice.mean = not_a_number;
  return choice;
}

bool is_better(const BasketChoice& one, const BasketChoice& other) {
  const std::size_t missing = missing_values(one), others_missing = missing_values(other);
  return missing == others_missing ? one.worst < other.worst : missing < others_missing;
}

}  // namespace

std::size_t missing_values(const BasketChoice& choice) {
  return static_cast<std::size_t>(
      std::count_if(choice.values.begin(), choice.values.end(),
                    [](const BasketValue& one) { return std::isnan(one.ratio); }));
}

BasketAssessment assess(const std::vector<BasketMeasure>& measures,
                        const std::vector<CaseAssessment>& cases) {
  BasketAssessment basket{measures, {}};
  const std::vector<const CaseAssessment*> of_basket = cases_of(measures, cases);
  for (const std::string& name : names_of_choices(measures, of_basket))
    basket.choices.push_back(assessed(name, measures, of_basket));
  std::stable_sort(basket.choices.begin(), basket.choices.end(), is_better);
  return basket;
}

}  // namespace slosh
