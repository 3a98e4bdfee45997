// The panels of a case after its runs: for each impact and metric the mean of each solver's members
// with its 95 % interval, whether the solvers agree, which one is apart (solver_panel.hpp), and
// what the air's compressibility changes. The values are the members' own; none is an error against
// a reference. A panel judges no gate row.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/gate/distributions/solver_panel.hpp"

namespace slosh {

// The members of one solver.
struct PanelSolver {
  std::string run;
  std::vector<double> values;           // of the members that have one, in the metric's unit
  std::size_t without_value = 0;        // members in which the impact never came
  std::vector<std::string> left_out;    // those without a usable series, each with the reason
  std::optional<SolverMean> mean = {};  // nullopt: too few values, so that the solver is left out
};

struct PanelRow {
  std::string mode;  // "impact_1", ..., or "whole"
  PanelMetric metric;
  std::string unit;
  std::vector<PanelSolver> solvers;  // in the order of the panel
  // Of the solvers that have a mean, in this order; nullopt for fewer than two.
  std::optional<PanelVerdict> verdict = {};
  std::vector<std::size_t> judged = {};  // their places among the solvers
  // What the air's compressibility changes: (compressible - incompressible) / incompressible, or of
  // a time the difference in its unit. nullopt where one of the two has no mean or none is asked.
  std::optional<Estimate> air_share = {};

  // The solver that is apart. nullptr where nobody is named.
  const PanelSolver* odd() const {
    return verdict && verdict->odd ? &solvers[judged[*verdict->odd]] : nullptr;
  }
};

// "all agree", "one apart", "several could be apart", "differ" or "too few solvers"
std::string panel_finding(const PanelRow& row);

struct PanelAssessment {
  PanelDefinition definition;
  std::vector<PanelRow> rows;  // by impact, then by metric
};

std::vector<PanelAssessment> panels_of(const CaseAssessment& assessment);

}  // namespace slosh
