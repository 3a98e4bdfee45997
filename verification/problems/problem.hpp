// A verification problem: one whose exact solution is known, solved with the solver's own operators
// at several resolutions. Each is one short file of this folder, which states the problem, its
// source and its exact solution, and leaves the errors; what they are to be stands as gate rows in
// the campaign file.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/case/campaign_definition.hpp"

namespace slosh {

// The longest side of a cell, the smoothing length, a time step: whatever shrinks.
struct ErrorAtStep {
  double step, error;
};

struct MeasureKind {
  std::string name;  // letters, digits and _
  std::string unit;  // of the error; "1" for none
  std::string step;  // what the steps are, with their unit: "h / L"
  std::string meaning;
  bool has_order = true;  // in the steps: the report shows it
};

struct MeasuredErrors {
  std::string name;
  std::vector<ErrorAtStep> errors;  // from the largest step to the smallest
};

struct ProblemOutcome {
  std::vector<MeasuredErrors> measures;  // in the order of the problem's kinds
  std::vector<reports::Figure> figures;
  std::vector<reports::Table> tables = {};
};

struct Problem {
  std::string name, title;
  std::string statement, source, exact_solution;  // in words and formulas
  std::vector<MeasureKind> measures;
  // The quick form leaves out the finest resolutions.
  ProblemOutcome (*run)(bool quick);
  double expected_time;        // of the whole form on one core [s]: the longest is started first
  bool is_of_metrics = false;  // solves nothing by SPH, but tries the metrics
};

// In the order of the report.
const std::vector<Problem>& all_problems();

// Throws std::invalid_argument with the nearest names where there is none of that name.
const Problem& find_problem(const std::string& name);

// For the reader of campaign files.
std::vector<KnownProblem> known_problems();

}  // namespace slosh
