// What a run was at its last sample, kept in memory so that it can be saved where the run goes
// wrong after that.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sph/resume.hpp"

namespace slosh::sph {

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

  // Of a run that has gone on since.
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
