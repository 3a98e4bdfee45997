// What a figure of a compared quantity says of it: its title, its axis and how it was sampled.
#pragma once

#include <string>

#include "verification/case_file/case_definition.hpp"

namespace slosh {

struct ShownQuantity {
  std::string title;
  std::string word;      // on the axis
  std::string unit;      // there: millimetres for metres
  double scale;          // from SI
  std::string sampling;  // sentences: how each kind of run measured it; may be empty
};

// Of one of the case's compared_quantities() (quantities.hpp).
ShownQuantity shown_quantity(const CaseDefinition& definition, const std::string& quantity);

// The quantity as a part of a figure's id.
std::string id_of(const std::string& quantity);

}  // namespace slosh
