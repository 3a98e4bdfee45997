// An effect that the models of a case leave out, as a number with the limit beyond which it makes
// their results doubtful, and the limit's source.
#pragma once

#include <functional>
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

// "the friction at walls ...: 8 % of the wave's amplitude in each period, limit 2 % (Keulegan
// 1959)"
std::string limit_text(const ModelLimit& limit);

// The share of a wave's amplitude by which the repeats of an experiment differ. They hide what
// changes the wave by less in a period.
inline constexpr double seen_share = 0.02;
inline constexpr const char* of_amplitude = "of the wave's amplitude in each period";

// The names of the runs that the test holds for.
std::vector<std::string> runs_with(const CaseDefinition& definition,
                                   const std::function<bool(const RunDefinition&)>& test);

// "a, b, c and 2 more"
std::string few_of(const std::vector<std::string>& runs);

}  // namespace slosh
