// What a figure of a compared quantity says of it: its title, its axis and how it was sampled.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

struct ShownQuantity {
  std::string title;
  std::string word;                                   // on the axis
  std::string unit;                                   // there: millimetres for metres
  double scale;                                       // from SI
  std::string what = {};                              // a sentence on what exactly is measured
  std::string sph = {}, interfoam = {}, theory = {};  // how each comes by it: "the mean over ..."
  std::string recorded = {};  // a sentence: how often and through which filter
};

// Of one of the case's compared_quantities() (quantities.hpp).
ShownQuantity shown_quantity(const CaseDefinition& definition, const std::string& quantity);

// For a caption of a figure that shows these runs: what is measured, how by each kind of run that
// is among them, how it was sampled. Sentences with a space behind each.
std::string measured_how(const ShownQuantity& shown, const CaseDefinition& definition,
                         const std::vector<std::string>& runs);

// The quantity as a part of a figure's id.
std::string id_of(const std::string& quantity);

}  // namespace slosh
