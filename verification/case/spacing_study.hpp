// A case made from another one: its tank, motion and comparison with one SPH scheme at several
// spacings beside one reference, as a case file of its own.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

struct SpacingStudy {
  // One of the two: a run of the case, all of whose settings but the spacing are kept, or a scheme
  // as it is.
  std::string candidate, family;
  std::vector<double> spacings;  // [m]
  std::string reference;         // a run of the case
};

// The run of a study that has the spacing: "recommended_12p5mm".
std::string study_run_name(const SpacingStudy& study, double spacing);

// The case file's text: the case's own without its runs, refinements and gate rows, but with the
// reference, the study's runs and a refinement "spacing" through these; files it names stand by
// their whole paths. Throws CaseFileError where the case has no such candidate or reference, the
// candidate is no SPH run, or the spacings are not three or more, each above zero and given once.
std::string spacing_study_text(const CaseDefinition& definition, const SpacingStudy& study);

}  // namespace slosh
