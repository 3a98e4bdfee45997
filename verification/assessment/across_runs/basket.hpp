// The choices of a scheme on a basket of cases. A choice is the runs of one name, and it is judged
// by its worst and its mean over all measures of the basket:
//   ratio = |value| / goal.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/case/campaign_definition.hpp"

namespace slosh {

struct BasketValue {
  Estimate value;       // in the metric's unit, as a gate row takes it; an ensemble has its mean
  double ratio;         // NaN where there is no value
  std::string message;  // why there is no value; empty where there is one
};

struct BasketChoice {
  std::string name;
  std::vector<BasketValue> values;  // by measure
  double worst, mean;               // of the ratios; NaN where one is missing
  double core_seconds;  // [s] over the basket's cases; NaN where one has no result of the choice
};

struct BasketAssessment {
  std::vector<BasketMeasure> measures = {};
  std::vector<BasketChoice> choices = {};  // by their worst ratio; those with a value missing last
};

// The choices are the runs that two or more of the basket's cases have in this form of the campaign
// under one name. References, theory, records, later members of ensembles and runs with a changed
// input are no choices.
BasketAssessment assess(const std::vector<BasketMeasure>& measures,
                        const std::vector<CaseAssessment>& cases);

// The number of measures for which the choice has no value.
std::size_t missing_values(const BasketChoice& choice);

}  // namespace slosh
