// All that a run goes on from, bit for bit. Every part has a name, so that a writer needs no list
// of its own.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sph/setting.hpp"
#include "sph/simulation.hpp"

namespace slosh::sph {

struct SavedState {
  // What the run that goes on has in common: the scheme's terms, its numbers and the scene's.
  std::vector<std::string> terms;
  std::map<std::string, double> setting;
  // The moment, and what steps, samples and counts keep in memory.
  std::map<std::string, double> numbers;
  // Of the particles, in the scheme's frame and the run's order, and of the solids' particles.
  std::map<std::string, std::vector<double>> fields;
  RunOutput output;  // its series so far, and nothing else

  // Calls visit(name, part) for every part: the four above, and the output's series, of which each
  // is a History, a std::map of them by name, or a std::vector<RecordedSeries>.
  template <class State, class Visit>
  static void for_each_part(State& state, const Visit& visit) {
    visit("terms", state.terms);
    visit("setting", state.setting);
    visit("numbers", state.numbers);
    visit("fields", state.fields);
    RunOutput::for_each_series(state.output, visit);
  }
};

// SavedState::setting of a run.
std::map<std::string, double> numbers_in_common(const Setting& setting, const Scene& scene);

// Throws std::invalid_argument for a state that the run cannot go on from: one of another scheme or
// scene, with other names or lengths, or with a number that is not finite. `own`: what the run
// would have saved at its start.
void require_state_of(const SavedState& own, const Scene& scene, const SavedState& state);

}  // namespace slosh::sph
