// How a run saves what it goes on from, and goes on from it. Particles are summed in an order that
// their neighbour search has given them, and a saved state holds no neighbour lists: at a save the
// run drops its own too, and the next step of both sorts alike.
#pragma once

#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sph/liquid.hpp"
#include "sph/recorder.hpp"
#include "sph/saved_state.hpp"

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

// `run` at its start, whose particles it replaces. Throws std::invalid_argument as
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

}  // namespace slosh::sph
