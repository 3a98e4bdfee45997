// The case of impact_results.hpp with ensembles of four solvers, made by hand, and two panels.
#pragma once

#include <string>

#include "verification/case/ensemble.hpp"
#include "verification/tests/impact_runs.hpp"

namespace slosh {

// Adds an ensemble whose peaks and plateau are `scale` times the published ones, within 3 %.
inline void add_ensemble(CaseAssessment& assessment, const std::string& name,
                         const decltype(RunDefinition::solver)& solver, int members, double scale) {
  for (int k = 0; k < members; ++k) {
    const double spread = 0.03 * (2.0 * k / (members - 1) - 1);
    const std::string member = k == 0 ? name : name + "_" + std::to_string(k + 1);
    add_run(assessment, member, solver, {pressure_of({.scale = scale * (1 + spread)})});
    assessment.definition.runs.back().ensemble = name;
  }
}

// "particles" are 1.5 times as high as the others; "air" is 1.1 times as high as "cells".
inline CaseAssessment panel_runs() {
  CaseAssessment assessment = no_runs_of(impact_case());
  CaseDefinition& definition = assessment.definition;
  definition.impacts->arrivals = ArrivalsDefinition{0.1, {2.372, 4.070, 5.715, 7.300}};
  InterFoamRun cells{40, 20}, sharp{40, 20}, air{40, 20};
  sharp.program = FoamProgram::inter_iso_foam;
  air.program = FoamProgram::compressible_inter_foam;
  add_ensemble(assessment, "particles", SphRun{"recommended", 0.004, 0.004}, 8, 1.5);
  add_ensemble(assessment, "cells", cells, 5, 1);
  add_ensemble(assessment, "sharp", sharp, 4, 1.01);
  add_ensemble(assessment, "air", air, 4, 1.02);
  definition.panels = {{.name = "impacts",
                        .runs = {"particles", "cells", "sharp", "air"},
                        .quantity = impact_pressure,
                        .metrics = {PanelMetric::impact_peak, PanelMetric::impact_arrival,
                                    PanelMetric::impulse, PanelMetric::plateau},
                        .impulse_duration = 0.05,
                        .air = AirPair{"air", "cells"},
                        .reason = "No solver is the reference."},
                       {.name = "histories",
                        .runs = {"particles", "cells", "sharp", "air"},
                        .quantity = impact_pressure,
                        .metrics = {PanelMetric::rms, PanelMetric::lag},
                        .reason = "No solver is the reference."}};
  return assessment;
}

}  // namespace slosh
