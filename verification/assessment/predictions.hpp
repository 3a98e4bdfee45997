// What the models of a campaign predicted, beside what theory and records say of the same, over all
// of its cases: the amplitudes of the fitted modes, down to a tenth of the largest one of the
// reference, and the natural frequencies. A model is an SPH
// scheme with all that a run changes of it, or interFoam; of each the finest run of a case counts,
// against the first theory in its range, or record, that the case compares it with.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/convergence/model_bias.hpp"

namespace slosh {

// A smaller mode is of the size of what the others err by: its relative error would tell of those.
inline constexpr double smallest_share_of_amplitude = 0.1;

struct Prediction {
  std::string case_name, candidate, reference, quantity, mode;
  PredictedValue value;
};

struct PredictionSet {
  std::string kind;   // "elevation amplitude", "natural frequency", ...
  std::string unit;   // "m", "Hz", ...
  std::string model;  // "recommended", "recommended, h = 2 dp", "interFoam"
  std::vector<Prediction> predictions;
  std::optional<ModelBias> bias;  // none of too few
};

// By kind and model, both in the order in which the cases name them. The references' deviations are
// a record's stated uncertainty; theory has none.
std::vector<PredictionSet> prediction_sets(const std::vector<CaseAssessment>& cases);

}  // namespace slosh
