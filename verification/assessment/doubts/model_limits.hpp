// Effects that the models of a case leave out, each as a number with the limit beyond which it
// makes their results doubtful, and the limit's source. All follow from the case file alone.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

struct ModelLimit {
  std::string effect;  // what is left out, and of which runs
  double value;        // a share: of the amplitude in a period, of a frequency, of a pressure
  double limit;        // the same share
  std::string what;    // "of the wave's amplitude in each period"
  std::string source;

  bool exceeded() const { return !(value <= limit); }
};

// Returns the effects that the runs of the case leave out, in this order, of those that apply:
//   the friction of the liquid at walls where it slips in the model, or sticks in layers thinner
//     than three particles, or than three of the cells beside the walls
//   the friction of the front and the back wall, where the case gives no breadth: of a tank as
//     broad as long
//   the artificial viscosity of an SPH run that sets its own
//   surface tension, for 0.073 N/m, that of clean water in air
//   the compression of trapped air, where the case declares impacts
//   the compressibility of an SPH run that sets its own speed of sound
std::vector<ModelLimit> model_limits(const CaseDefinition& definition);

// "the friction at walls ...: 8 % of the wave's amplitude in each period, limit 2 % (Keulegan
// 1959)"
std::string limit_text(const ModelLimit& limit);

}  // namespace slosh
