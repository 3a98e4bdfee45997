// Case files that are made from another case: a convergence study of its runs, and a case of the
// user's own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// The tank, motion and comparison of a case, with one SPH scheme, or one method of an external
// program, at several spacings and one reference.
struct SpacingStudy {
  // Exactly one of the two is given: a run of the case, which keeps all its settings but the
  // spacing, or a scheme or the method of an external run of the case.
  std::string candidate, family;
  std::vector<double> spacings;  // [m]
  std::string reference;         // a run of the case
};

// Returns the name of the study's run with this spacing [m]: "recommended_12p5mm".
std::string study_run_name(const SpacingStudy& study, double spacing);

// A table that the study names, to be copied to a place relative to the study's case file.
struct StudyTable {
  std::filesystem::path source, place;
};

struct StudyText {
  std::string text;
  std::vector<StudyTable> tables;  // no two have one place
};

// Returns the text of the study's case file: that of the case, with the reference, the study's runs
// and a refinement "spacing" through these in place of its runs, refinements and gate rows. The
// paths of programs and their inputs become absolute. Throws CaseFileError if the case has no such
// candidate or reference, if the candidate has not one spacing, or if the spacings are not three or
// more different numbers > 0.
StudyText spacing_study_text(const CaseDefinition& definition, const SpacingStudy& study);

// Returns the text of a case of the user's own, to be edited: the file of another case, reduced to
// its theories and one SPH run with its gate rows, where each key is explained by its row. The kept
// SPH run is the coarsest of those that a gate row judges by a limit. Files that the case names are
// named by their whole paths. Records that only the user has, ensembles, refinements, uncertain
// inputs and animations are left out. Throws CaseFileError for a name that no case may have, and
// for a case without an SPH run.
std::string commented_case(const CaseDefinition& like, const std::string& name);

}  // namespace slosh
