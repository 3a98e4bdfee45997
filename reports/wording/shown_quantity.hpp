// How figures name a compared quantity: its title, its axis, and how it was measured and sampled.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

struct ShownQuantity {
  std::string title;
  std::string word;                                   // axis label
  std::string unit;                                   // on the axis: millimetres for metres
  double scale;                                       // from SI
  std::string what = {};                              // a sentence: what exactly is measured
  std::string sph = {}, interfoam = {}, theory = {};  // how each computes it: "the mean over ..."
  std::string recorded = {};  // a sentence: how often and through which filter
};

// `quantity` is one of the case's compared_quantities() (quantities.hpp). Throws
// std::invalid_argument for any other.
ShownQuantity shown_quantity(const CaseDefinition& definition, const std::string& quantity);

// Returns the part of a caption that says what is measured, how each kind of run among `runs`
// computes it, and how it was sampled: sentences with a space after each.
std::string measured_how(const ShownQuantity& shown, const CaseDefinition& definition,
                         const std::vector<std::string>& runs);

// Returns the quantity as a part of a figure's id.
std::string id_of(const std::string& quantity);

// Returns "on the right wall 0.2 m above the bottom", or the place on an outline.
std::string place_on_wall(const PressureGaugeDefinition& gauge);

}  // namespace slosh
