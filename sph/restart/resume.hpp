// How a run saves its state and is restarted from it. Particles are summed in an order given by
// their neighbour search, and a saved state holds no neighbour lists. At a save the run therefore
// drops its own lists too, so that the next step of both runs sorts the particles alike.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sph/liquid.hpp"
#include "sph/recording/recorder.hpp"
#include "sph/restart/saved_state.hpp"

namespace slosh::sph {

// What a run of one scheme keeps from step to step and from sample to sample.
struct RunMemory {
  Liquid liquid;
  Recorder recorder;
  Integrator integrator;
  int sample = 0;                                                  // the last one recorded
  double smallest_step = std::numeric_limits<double>::infinity();  // [s]

  RunMemory(const Scene& scene, const Method& method, Particles start)
      : liquid(scene, method, std::move(start)),
        recorder(scene, liquid),
        integrator(method.integrator) {}

  template <class Visit>
  void for_each_number(const Visit& visit) {
    visit("time", liquid.time);
    visit("sample", sample);
    visit("steps", recorder.output.steps);
    visit("smallest_time_step", smallest_step);
    liquid.for_each_number(visit);
    recorder.for_each_number(visit);
    std::visit([&](auto& own) { own.for_each_number(visit); }, integrator);
  }
};

SavedState saved_state(RunMemory& run, const Scene& scene);

// Sets `run`, which is at its start, to the saved state. Throws std::invalid_argument as
// require_state_of does.
void resume_from(RunMemory& run, const Scene& scene, const SavedState& state);

// The run's state at its last sample, kept in memory so that it can be saved where the run fails
// later.
class LastGoodState {
 public:
  void keep(RunMemory& run);
  bool kept() const { return !numbers_.empty(); }

  // Returns the kept state; `run` may have gone on since, and its series are cut to the kept time.
  SavedState state(RunMemory& run, const Scene& scene) const;

 private:
  std::map<std::string, double> numbers_;
  std::map<std::string, std::vector<double>> fields_;
};

}  // namespace slosh::sph
