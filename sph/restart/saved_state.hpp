// The state from which a run is restarted, bit for bit. Every part has a name, so that a writer of
// files needs no list of its own.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sph/run_output.hpp"
#include "sph/scene.hpp"
#include "sph/setting.hpp"

namespace slosh::sph {

struct SavedState {
  // The restarted run must agree in these: the scheme's terms, its numbers and the scene's.
  std::vector<std::string> terms;
  std::map<std::string, double> setting;
  // The time, and the numbers that integrator, recorder and guards keep.
  std::map<std::string, double> numbers;
  // The fields of the particles, in the scheme's frame and the run's order, and of the solids.
  std::map<std::string, std::vector<double>> fields;
  RunOutput output;  // its series so far, and nothing else

  // Calls visit(name, part) for every part: the four above and the output's series. A series is a
  // History, a std::map<std::string, History> or a std::vector<RecordedSeries>.
  template <class State, class Visit>
  static void for_each_part(State& state, const Visit& visit) {
    visit("terms", state.terms);
    visit("setting", state.setting);
    visit("numbers", state.numbers);
    visit("fields", state.fields);
    RunOutput::for_each_series(state.output, visit);
  }
};

// Returns SavedState::setting of a run.
std::map<std::string, double> numbers_in_common(const Setting& setting, const Scene& scene);

// Throws std::invalid_argument for a state from which the run cannot be restarted: one of another
// scheme or scene, with other names or lengths, or with a number that is not finite. `own` is the
// state of the run at its start.
void require_state_of(const SavedState& own, const Scene& scene, const SavedState& state);

}  // namespace slosh::sph
