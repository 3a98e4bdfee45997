// How a run saves its state and is restarted from it. Particles are summed in an order given by
// their neighbour search, and a saved state holds no neighbour lists. At a save the run therefore
// drops its own lists too, so that the next step of both runs sorts the particles alike.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sph/liquid.hpp"
#include "sph/recording/recorder.hpp"
#include "sph/restart/saved_state.hpp"

namespace slosh::sph {

// What a run of one scheme keeps from step to step and from sample to sample.
template <class Choice>
struct RunMemory {
  Liquid<Scheme<Choice>> liquid;
  Recorder<Scheme<Choice>> recorder;
  typename Choice::Integrator integrator = {};
  int sample = 0;                                                  // the last one recorded
  double smallest_step = std::numeric_limits<double>::infinity();  // [s]

  RunMemory(const Scene& scene, const Scheme<Choice>& scheme, Particles start)
      : liquid(scene, scheme, std::move(start)), recorder(scene, liquid) {}

  template <class Visit>
  void for_each_number(const Visit& visit) {
    visit("time", liquid.time);
    visit("sample", sample);
    visit("steps", recorder.output.steps);
    visit("smallest_time_step", smallest_step);
    liquid.for_each_number(visit);
    recorder.for_each_number(visit);
    integrator.for_each_number(visit);
  }
};

template <class Choice>
SavedState saved_state(RunMemory<Choice>& run, const Scene& scene) {
  SavedState state;
  state.terms = run.recorder.output.active_terms;
  state.setting = numbers_in_common(run.liquid.scheme().setting, scene);
  run.for_each_number([&](const char* name, const auto& value) {
    state.numbers[name] = static_cast<double>(value);
  });
  run.liquid.for_each_saved_field([&](const char* name, const Array<double>& field) {
    state.fields[name].assign(field.begin(), field.end());
  });
  state.output = run.recorder.output;
  return state;
}

// Sets `run`, which is at its start, to the saved state. Throws std::invalid_argument as
// require_state_of does.
template <class Choice>
void resume_from(RunMemory<Choice>& run, const Scene& scene, const SavedState& state) {
  if constexpr (Choice::Integrator::carries_earlier_state)
    run.liquid.particles.make_earlier_state();
  require_state_of(saved_state(run, scene), scene, state);
  RunOutput& output = run.recorder.output;
  const std::size_t particles = output.particles;
  const std::vector<std::string> terms = output.active_terms;
  output = state.output;
  output.particles = particles;
  output.active_terms = terms;
  run.for_each_number([&](const char* name, auto& value) {
    value = static_cast<std::remove_reference_t<decltype(value)>>(state.numbers.at(name));
  });
  run.liquid.for_each_saved_field([&](const char* name, Array<double>& field) {
    const std::vector<double>& saved = state.fields.at(name);
    field.assign(saved.begin(), saved.end());
  });
  run.liquid.forget_neighbours();
}

// The run's state at its last sample, kept in memory so that it can be saved where the run fails
// later.
template <class Choice>
class LastGoodState {
 public:
  void keep(RunMemory<Choice>& run) {
    run.for_each_number(
        [&](const char* name, const auto& value) { numbers_[name] = static_cast<double>(value); });
    run.liquid.for_each_saved_field([&](const char* name, const Array<double>& field) {
      fields_[name].assign(field.begin(), field.end());
    });
  }

  bool kept() const { return !numbers_.empty(); }

  // Returns the kept state; `run` may have gone on since, and its series are cut to the kept time.
  SavedState state(RunMemory<Choice>& run, const Scene& scene) const {
    SavedState state = saved_state(run, scene);
    state.numbers = numbers_;
    state.fields = fields_;
    RunOutput::for_each_series(state.output, [time = numbers_.at("time")](const char*, auto& part) {
      end_at(time, part);
    });
    return state;
  }

 private:
  static void end_at(double time, History& history) {
    while (!history.time.empty() && history.time.back() > time) {
      history.time.pop_back();
      history.value.pop_back();
    }
  }
  static void end_at(double time, std::map<std::string, History>& by_name) {
    for (auto& [name, history] : by_name) end_at(time, history);
  }
  static void end_at(double time, std::vector<RecordedSeries>& list) {
    for (RecordedSeries& one : list) end_at(time, one.history);
  }

  std::map<std::string, double> numbers_;
  std::map<std::string, std::vector<double>> fields_;
};

}  // namespace slosh::sph
