#include "sph/restart/saved_state.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <type_traits>

namespace slosh::sph {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("resume: " + what);
}

template <class Value>
std::vector<std::string> names_of(const std::map<std::string, Value>& parts) {
  std::vector<std::string> names;
  for (const auto& [name, part] : parts) names.push_back(name);
  return names;
}
template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& list) {
  std::vector<std::string> names;
  for (const Named& one : list) names.push_back(one.name);
  std::sort(names.begin(), names.end());
  return names;
}

void require_names(const char* what, const std::vector<std::string>& found,
                   const std::vector<std::string>& expected) {
  if (found != expected)
    refuse(fmt::format("the state's {} are {}: expected {}, as this run has them", what,
                       fmt::join(found, ", "), fmt::join(expected, ", ")));
}

void require_finite(const std::string& name, const std::vector<double>& values) {
  const auto bad =
      std::find_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
  if (bad != values.end())
    refuse(fmt::format("the state's {} number {} is {}: expected a finite number", name,
                       bad - values.begin(), *bad));
}

void require_numbers(const std::string& name, const History& series) {
  require_finite(name, series.time);
  require_finite(name, series.value);
  if (series.time.size() != series.value.size())
    refuse(fmt::format("the state's {} has {} times and {} values: expected as many of each", name,
                       series.time.size(), series.value.size()));
}

void require_series(const std::string& name, const History& series, double time) {
  require_numbers(name, series);
  if (!series.time.empty() && series.time.back() != time)
    refuse(fmt::format("the state's {} ends at {} s: expected the state's time, {} s", name,
                       series.time.back(), time));
}

struct RequireSeries {
  double time;

  void operator()(const char* name, const History& series) const {
    // The packing is not measured at every sample.
    if (std::string_view(name) == "packing_drift")
      require_numbers(name, series);
    else
      require_series(name, series, time);
  }
  void operator()(const char* name, const std::map<std::string, History>& by_gauge) const {
    for (const auto& [gauge, series] : by_gauge)
      require_series(fmt::format("{} of {}", name, gauge), series, time);
  }
  void operator()(const char*, const std::vector<RecordedSeries>& list) const {
    for (const RecordedSeries& series : list) require_series(series.name, series.history, time);
  }
};

void require_common_setting(const SavedState& own, const SavedState& state) {
  if (state.terms != own.terms)
    refuse(fmt::format("the state's terms are {}: expected {}", fmt::join(state.terms, ", "),
                       fmt::join(own.terms, ", ")));
  require_names("numbers in common", names_of(state.setting), names_of(own.setting));
  for (const auto& [name, value] : own.setting)
    if (!(state.setting.at(name) == value))
      refuse(fmt::format("the state has {} = {}: expected {}, as this run has it", name,
                         state.setting.at(name), value));
}

void require_moment(const Scene& scene, const SavedState& state) {
  const double time = state.numbers.at("time"), sample = state.numbers.at("sample");
  if (!(sample >= 1 && sample == std::round(sample) && time == sample * scene.sample_interval))
    refuse(fmt::format(
        "the state is of sample {} at {} s: expected a sample after the first, every {} s", sample,
        time, scene.sample_interval));
  if (!(time <= scene.duration + 1e-9 * scene.sample_interval))
    refuse(fmt::format("the state is at t = {} s: expected a time within the run's {} s", time,
                       scene.duration));
}

void require_lengths(const SavedState& own, const SavedState& state) {
  for (const auto& [name, values] : state.fields) {
    if (values.size() != own.fields.at(name).size())
      refuse(fmt::format("the state's {} has {} numbers: expected {}", name, values.size(),
                         own.fields.at(name).size()));
    require_finite(name, values);
  }
}

}  // namespace

std::map<std::string, double> numbers_in_common(const Setting& s, const Scene& scene) {
  const Roll roll = scene.roll.value_or(no_roll());
  std::map<std::string, double> numbers{
      {"gravity", s.gravity},
      {"fill_depth", s.fill_depth},
      {"rest_density", s.rest_density},
      {"kinematic_viscosity", s.kinematic_viscosity},
      {"breadth", s.breadth},
      {"particle_spacing", s.particle_spacing},
      {"smoothing_length_ratio", s.smoothing_length_ratio},
      {"coarse_run_speed", scene.coarse_run ? scene.coarse_run->expected_speed : 0},
      {"coarse_run_spacing", scene.coarse_run ? scene.coarse_run->particle_spacing : 0},
      {"speed_of_sound", s.speed_of_sound},
      {"courant_number", s.courant_number},
      {"artificial_viscosity", s.artificial_viscosity},
      {"density_diffusion", s.density_diffusion},
      {"surface_particle_spacing", scene.surface_particle_spacing},
      {"tank_length", scene.tank_length},
      {"tank_height", scene.tank_height},
      {"column_width", scene.column_width.value_or(scene.tank_length)},
      {"wave_mode", scene.initial_wave ? scene.initial_wave->mode : 0},
      {"wave_amplitude", scene.initial_wave ? scene.initial_wave->amplitude : 0},
      {"sample_interval", scene.sample_interval},
      {"axis_x", roll.axis_x},
      {"axis_z", roll.axis_z}};
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    const Rectangle& r = scene.obstacles[i];
    for (const auto& [edge, place] :
         {std::pair{"left", r.left}, {"right", r.right}, {"bottom", r.bottom}, {"top", r.top}})
      numbers[fmt::format("obstacle_{}_{}", i, edge)] = place;
  }
  return numbers;
}

void require_state_of(const SavedState& own, const Scene& scene, const SavedState& state) {
  require_common_setting(own, state);
  require_names("numbers", names_of(state.numbers), names_of(own.numbers));
  for (const auto& [name, value] : state.numbers) require_finite(name, {value});
  require_moment(scene, state);
  require_names("fields", names_of(state.fields), names_of(own.fields));
  require_lengths(own, state);
  require_names("gauges", names_of(state.output.elevation), names_of(scene.gauges));
  require_names("pressure gauges", names_of(state.output.wall_pressure),
                names_of(scene.pressure_gauges));
  if (state.output.still_water.empty() == scene.record_still_water ||
      state.output.energy.empty() == scene.record_energy_budget)
    refuse("the state and the run differ in record_still_water or record_energy_budget");
  RunOutput::for_each_series(state.output, RequireSeries{state.numbers.at("time")});
}

}  // namespace slosh::sph
