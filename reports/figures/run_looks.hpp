// The colour, the marker and the dash of each run: the one place that assigns them, for all figures
// of all pages. Theory and records are black and grey. Each SPH scheme, each of
// OpenFOAM's programs and each method of another code has a hue and a marker, and shares at most
// one of the two with another (up to 60 of them); the runs of one family differ in marker and dash,
// the finest unchanged run first.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/case/case_definition.hpp"

namespace slosh {

reports::Look look_of(const CaseDefinition& definition, const std::string& run);

// The look of the family's finest unchanged run. A refinement path, whose name is no family's, is
// one of meshes: it looks as interFoam does.
reports::Look look_of_family(const CaseDefinition& definition, const std::string& family);

// The look of the models of several cases, each a family, or a family and what its runs change:
// "recommended", "recommended, h = 2 dp".
std::vector<reports::Look> looks_of_models(const std::vector<std::string>& models);

// Lines that help the eye and are no run's: tolerances, guides, the front of the best runs.
inline reports::Look guide_look(std::size_t number) { return {true, 1, number}; }

}  // namespace slosh
