// The predictions of a campaign's models and the corresponding values of theory and records, over
// all of its cases: the amplitudes of the fitted modes, down to a tenth of the reference's largest
// one, and the natural frequencies. A model is an SPH scheme with all that a run changes of it, or
// interFoam. The finest run of each model counts in each case, against the first theory inside its
// range, or record, that the case compares it with.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/convergence/model_bias.hpp"

namespace slosh {

// A smaller mode is as small as the errors of the larger ones: its relative error would measure
// those.
inline constexpr double smallest_share_of_amplitude = 0.1;

struct Prediction {
  std::string case_name, candidate, reference, quantity, mode;
  PredictedValue value;
  // Of the 95 % interval of predicted over reference: the fits of both series, and the record's
  // uncertainty.
  double ratio_half_width = 0;
};

struct PredictionSet {
  std::string kind;   // "elevation amplitude", "natural frequency", ...
  std::string unit;   // "m", "Hz", ...
  std::string model;  // "recommended", "recommended, h = 2 dp", "interFoam"
  std::vector<Prediction> predictions;
  std::optional<ModelBias> bias;  // nullopt for too few predictions
};

// One set for each kind and model, both in the order in which the cases name them. A reference's
// standard deviation comes from the record's declared uncertainty; theory has none.
std::vector<PredictionSet> prediction_sets(const std::vector<CaseAssessment>& cases);

// Sets each bias from the predictions, and puts the sets of one kind behind one another.
void settle(std::vector<PredictionSet>& sets);

}  // namespace slosh
