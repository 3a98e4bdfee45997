#include "verification/assessment/predictions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "verification/assessment/work_points.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/record_uncertainty.hpp"

namespace slosh {
namespace {

// The half width of a 95 % interval over the standard deviation of a normal distribution.
constexpr double coverage = 1.96;

// Returns "elevation amplitude" for "elevation@right", and an empty text for a quantity whose
// amplitude is not predicted.
std::string amplitude_kind(const std::string& quantity) {
  const Quantity* known = find_quantity(quantity);
  return known && !is_filtered(quantity) ? known->amplitude : "";
}

// For each model and quantity the comparison of the finest run with its first theory or record.
std::vector<const Comparison*> counted_comparisons(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  std::map<std::pair<std::string, std::string>, const Comparison*> finest;
  for (const Comparison& one : assessment.comparisons) {
    const RunDefinition& candidate = run_named(definition, one.candidate);
    if (assessment.runs.status.at(one.reference).state == RunState::out_of_range ||
        is_simulation(run_named(definition, one.reference)))
      continue;
    const Comparison*& best = finest[{work_family(candidate), one.quantity}];
    if (!best || resolution(candidate) > resolution(run_named(definition, best->candidate)))
      best = &one;
  }
  std::vector<const Comparison*> counted;
  for (const Comparison& one : assessment.comparisons)
    for (const auto& [key, best] : finest)
      if (best == &one) counted.push_back(&one);
  return counted;
}

double largest_amplitude(const Comparison& pair) {
  double largest = 0;
  for (const ModeComparison& mode : pair.modes)
    largest = std::max(largest, mode.reference.amplitude.value);
  return largest;
}

double amplitude_deviation(const CaseDefinition& definition, const Comparison& pair,
                           const ModeComparison& mode) {
  const auto* record = std::get_if<RecordRun>(&run_named(definition, pair.reference).solver);
  if (!record || !record->uncertainty) return 0;
  return uncertainty_from_values(Metric::amplitude_error, mode.mode, pair, *record->uncertainty) /
         coverage;
}

bool is_usable(const PredictedValue& value) {
  return value.predicted > 0 && value.reference > 0 && std::isfinite(value.predicted) &&
         std::isfinite(value.reference) && std::isfinite(value.reference_deviation);
}

class Collection {
 public:
  void add(const CaseAssessment& assessment) {
    const CaseDefinition& definition = assessment.definition;
    const std::string first = compared_quantities(definition).front();
    for (const Comparison* pair : counted_comparisons(assessment))
      for (const ModeComparison& mode : pair->modes) {
        if (!mode.resolved()) continue;
        const std::string kind = amplitude_kind(pair->quantity);
        if (!kind.empty() && mode.reference.amplitude.value >=
                                 smallest_share_of_amplitude * largest_amplitude(*pair))
          add(kind, pair->unit, definition, *pair, mode,
              {mode.candidate.amplitude.value, mode.reference.amplitude.value,
               amplitude_deviation(definition, *pair, mode)},
              mode.amplitude_error.half_width);
        // All quantities oscillate at the same natural frequencies; the case's first one is used.
        if (!is_forced(mode.mode) && pair->quantity == first)
          add("natural frequency", "Hz", definition, *pair, mode,
              {mode.candidate.angular_frequency.value / (2 * std::numbers::pi),
               mode.reference.angular_frequency.value / (2 * std::numbers::pi)},
              mode.frequency_error.half_width);
      }
  }

  std::vector<PredictionSet> release() {
    settle(sets_);
    return std::move(sets_);
  }

 private:
  void add(const std::string& kind, const std::string& unit, const CaseDefinition& definition,
           const Comparison& pair, const ModeComparison& mode, const PredictedValue& value,
           double half_width_of_fits) {
    if (!is_usable(value)) return;
    const std::string model = work_family(run_named(definition, pair.candidate));
    auto set = std::find_if(sets_.begin(), sets_.end(), [&](const PredictionSet& one) {
      return one.kind == kind && one.model == model;
    });
    if (set == sets_.end()) set = sets_.insert(set, {kind, unit, model, {}, {}});
    const double of_record =
        coverage * value.reference_deviation * value.predicted / value.reference;
    set->predictions.push_back({definition.name, pair.candidate, pair.reference, pair.quantity,
                                mode.mode, value, std::hypot(half_width_of_fits, of_record)});
  }

  std::vector<PredictionSet> sets_;
};

}  // namespace

std::vector<PredictionSet> prediction_sets(const std::vector<CaseAssessment>& cases) {
  Collection collection;
  for (const CaseAssessment& one : cases) collection.add(one);
  return collection.release();
}

void settle(std::vector<PredictionSet>& sets) {
  std::vector<std::string> kinds;
  for (PredictionSet& set : sets) {
    if (std::find(kinds.begin(), kinds.end(), set.kind) == kinds.end()) kinds.push_back(set.kind);
    std::vector<PredictedValue> values;
    for (const Prediction& one : set.predictions) values.push_back(one.value);
    set.bias = model_bias(values);
  }
  const auto place = [&](const PredictionSet& set) {
    return std::find(kinds.begin(), kinds.end(), set.kind) - kinds.begin();
  };
  std::stable_sort(sets.begin(), sets.end(),
                   [&](const PredictionSet& one, const PredictionSet& other) {
                     return place(one) < place(other);
                   });
}

}  // namespace slosh
