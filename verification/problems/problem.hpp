// A verification problem: a problem with a known exact solution, which is solved with the solver's
// own operators at several resolutions. Each is stated with its source and its exact solution in a
// file of this folder, and its run returns the errors. Their limits are gate rows in the campaign
// file.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/case/campaign_definition.hpp"

namespace slosh {

// The step is what refinement reduces: the particle spacing, the smoothing length, a time step.
struct ErrorAtStep {
  double step, error;
};

struct MeasureKind {
  std::string name;  // letters, digits and _
  std::string unit;  // of the error; "1" for none
  std::string step;  // what the steps are, with their unit: "h / L"
  std::string meaning;
  bool has_order = true;  // the report shows the order of the errors in the steps
};

struct MeasuredErrors {
  std::string name;
  std::vector<ErrorAtStep> errors;  // from the largest step to the smallest
};

// The figures and tables show fields and time series that only the run has, so they are part of
// what it returns and of the stored result.
struct ProblemOutcome {
  std::vector<MeasuredErrors> measures;  // in the order of the problem's kinds
  std::vector<reports::Figure> figures;
  std::vector<reports::Table> tables = {};
};

struct Problem {
  std::string name, title;
  std::string statement, source, exact_solution;  // in words and formulas
  std::vector<MeasureKind> measures;
  // Solves the problem; the quick form leaves out the finest resolutions.
  ProblemOutcome (*run)(bool quick);
  double expected_time;        // of the whole form on one core [s]: the longest is started first
  bool is_of_metrics = false;  // it tests the metrics and solves nothing by SPH
};

}  // namespace slosh
