// The list of all problems.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/case/campaign_definition.hpp"

namespace slosh {

// A verification problem: a problem with a known exact solution, which is solved with the solver's
// own operators at several resolutions. Each is stated with its source and its exact solution in a
// file of this folder, and its run returns the errors. Their limits are gate rows in the campaign
// file.

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
  double expected_time;  // of the whole form on one core [s]: the longest is started first
};

// Returns all problems in the order of the report.
const std::vector<Problem>& all_problems();

// Throws std::invalid_argument with the nearest name where no problem has the name.
const Problem& find_problem(const std::string& name);

// Returns the problems' names and measures, for the reader of campaign files.
std::vector<KnownProblem> known_problems();

// Each problem, with its statement and measures.
Problem taylor_green_problem();
Problem oscillating_drop_problem();
Problem rigid_rotation_problem();
Problem courant_map_problem();
Problem viscosity_map_problem();
Problem gamma_map_problem();
Problem diffusion_map_problem();
Problem lattice_buckling_problem();
Problem lattice_resistance_problem();

}  // namespace slosh
