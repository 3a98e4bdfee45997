#include "sph/restart/resume.hpp"

#include <type_traits>

namespace slosh::sph {
namespace {

void end_at(double time, History& history) {
  while (!history.time.empty() && history.time.back() > time) {
    history.time.pop_back();
    history.value.pop_back();
  }
}
void end_at(double time, std::map<std::string, History>& by_name) {
  for (auto& [name, history] : by_name) end_at(time, history);
}
void end_at(double time, std::vector<RecordedSeries>& list) {
  for (RecordedSeries& one : list) end_at(time, one.history);
}

}  // namespace

SavedState saved_state(RunMemory& run, const Scene& scene) {
  SavedState state;
  state.terms = run.recorder.output.active_terms;
  state.setting = numbers_in_common(run.liquid.setting(), scene);
  run.for_each_number([&](const char* name, const auto& value) {
    state.numbers[name] = static_cast<double>(value);
  });
  run.liquid.for_each_saved_field([&](const char* name, const Array<double>& field) {
    state.fields[name].assign(field.begin(), field.end());
  });
  state.output = run.recorder.output;
  return state;
}

void resume_from(RunMemory& run, const Scene& scene, const SavedState& state) {
  if (std::visit([](const auto& own) { return own.carries_earlier_state; }, run.integrator))
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

void LastGoodState::keep(RunMemory& run) {
  run.for_each_number(
      [&](const char* name, const auto& value) { numbers_[name] = static_cast<double>(value); });
  run.liquid.for_each_saved_field([&](const char* name, const Array<double>& field) {
    fields_[name].assign(field.begin(), field.end());
  });
}

SavedState LastGoodState::state(RunMemory& run, const Scene& scene) const {
  SavedState state = saved_state(run, scene);
  state.numbers = numbers_;
  state.fields = fields_;
  RunOutput::for_each_series(
      state.output, [time = numbers_.at("time")](const char*, auto& part) { end_at(time, part); });
  return state;
}

}  // namespace slosh::sph
