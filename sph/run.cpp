#include "sph/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sph/guards/stability_guard.hpp"
#include "sph/held_arrays.hpp"
#include "sph/recording/recorder.hpp"
#include "sph/restart/resume.hpp"
#include "sph/start/initial_state.hpp"

namespace slosh::sph {
namespace {

double largest_acceleration(const Rates& rates, double gravity) {
  // The loop takes plain pointers because its loads from the arrays would not be vectorised.
  const double *x = rates.acceleration_x.data(), *z = rates.acceleration_z.data();
  const std::size_t n = rates.acceleration_x.size();
  double largest2 = gravity * gravity;
#pragma omp simd reduction(max : largest2)
  for (std::size_t i = 0; i < n; ++i) largest2 = std::max(largest2, x[i] * x[i] + z[i] * z[i]);
  return std::sqrt(largest2);
}

double largest_density(const Particles& particles) {
  const double* density = particles.density.data();
  const std::size_t n = particles.size();
  double largest = 0;
#pragma omp simd reduction(max : largest)
  for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, density[i]);
  return largest;
}

double largest_magnitude(const History& history) {
  double largest = 0;
  for (const double value : history.value) largest = std::max(largest, std::abs(value));
  return largest;
}

void check_fixed_step(const Scene& scene, const Setting& setting) {
  const double finest = std::min(scene.particle_spacing, scene.surface_particle_spacing);
  const double h = setting.smoothing_length_ratio * finest;
  const double dt = FixedStep::step,
               limit = FixedStep::stable_courant_number * h / setting.speed_of_sound;
  if (!(dt <= limit))
    throw SimulationError(
        fmt::format("the scheme's fixed time step {} s is unstable at particle spacing {} m: "
                    "expected at most {:.3g} s",
                    dt, finest, limit));
}

bool adapts(const Method& method) { return std::holds_alternative<AdaptiveStep>(method.time_step); }

// Returns the interval of `what` in samples; 0 for an interval of 0, which stands for none. Throws
// std::invalid_argument where the interval is not a multiple of the sample interval.
int samples_per(const char* what, double interval, const Scene& scene) {
  if (interval == 0) return 0;
  const double ratio = interval / scene.sample_interval, whole = std::round(ratio);
  if (!(whole >= 1 && whole <= 1e9 && std::abs(ratio - whole) <= 1e-9 * whole))
    throw std::invalid_argument(
        fmt::format("{} interval = {} s: expected a multiple of the sample interval of {} s", what,
                    interval, scene.sample_interval));
  return static_cast<int>(whole);
}

std::vector<std::string> terms_of_run(const Scene& scene, const Method& method) {
  std::vector<std::string> terms = method.active_terms();
  const Setting& setting = method.terms->setting;
  if (gap_layers(setting).largest_friction() > 0)
    terms.push_back(fmt::format("boundary layers of the gap walls {:.4g} m apart", scene.breadth));
  terms.push_back(start_name(chosen_state(scene, method)));
  if (scene.speed_from_coarse_run)
    terms.push_back("expected largest speed measured by a coarse run");
  if (adapts(method))
    terms.push_back(fmt::format("time step of at most {} h / c0", setting.courant_number));
  return terms;
}

std::vector<HeldArray> held_arrays(RunMemory& run) {
  HeldArrays arrays;
  run.liquid.report_memory(arrays);
  run.recorder.report_memory(arrays);
  return arrays.held();
}

// Advances the run to the time of the next sample.
void advance_to(double target, RunMemory& run, const Scene& scene) {
  auto& [liquid, recorder, integrator, sample, smallest_step] = run;
  while (liquid.time < target) {
    // The steps to the sample are equal, each at most the stable one; the last ends on it exactly.
    const double left = target - liquid.time;
    const double stable = stable_step(liquid, scene.gravity);
    check_step(stable, liquid.method().longest_step(), liquid.particles, liquid.rates, liquid.time);
    const double count = std::ceil(left / stable - 1e-9);
    const double dt = left / count;
    advance(integrator, liquid, dt);
    liquid.time = count <= 1 ? target : liquid.time + dt;
    check_state(liquid.particles, scene.rest_density, liquid.time);
    recorder.add_step(liquid);
    smallest_step = std::min(smallest_step, dt);
    recorder.output.steps += 1;
  }
}

// Advances the run to its end, and records, saves and reports at the sample times.
void go_through(RunMemory& run, LastGoodState& last_good, const Scene& scene,
                const Progress& progress) {
  auto& [liquid, recorder, integrator, sample, smallest_step] = run;
  const int snapshot_stride = samples_per("snapshot", scene.snapshot_interval, scene),
            state_stride = samples_per("state", scene.state_interval, scene);
  auto last_report = std::chrono::steady_clock::now();

  const int samples =
      scene.takes_steps
          ? static_cast<int>(std::floor(scene.duration / scene.sample_interval + 1e-9))
          : 0;
  for (; sample <= samples; ++sample) {
    advance_to(sample * scene.sample_interval, run, scene);
    // The step has left the accelerations of its start or its middle; a sample needs its own.
    liquid.accelerate_for_sample();
    recorder.record(liquid, sample == samples);
    if (snapshot_stride != 0 && sample % snapshot_stride == 0) recorder.record_snapshot(liquid);
    if (state_stride != 0 && sample > 0 && sample % state_stride == 0) {
      scene.save_state(saved_state(run, scene));
      liquid.forget_neighbours();
    }
    if (scene.save_last_good_state && sample > 0) last_good.keep(run);
    if (progress &&
        std::chrono::steady_clock::now() - last_report > std::chrono::milliseconds(100)) {
      progress(liquid.time, recorder.output.steps);
      last_report = std::chrono::steady_clock::now();
    }
  }
}

void add_diagnostics(RunMemory& run, const Scene& scene, RunOutput& output) {
  const Setting& setting = run.liquid.setting();
  output.held_arrays = held_arrays(run);
  output.exchanged_at_walls = run.liquid.exchanged_at_walls();
  output.diagnostics["expected_speed_m_s"] = setting.expected_speed;
  if (const auto& coarse = scene.coarse_run)
    output.diagnostics["coarse_run_spacing_m"] = coarse->particle_spacing;
  output.diagnostics["speed_of_sound_m_s"] = setting.speed_of_sound;
  output.diagnostics["smoothing_length_ratio"] = setting.smoothing_length_ratio;
  output.diagnostics["evaluations_per_step"] =
      std::visit([](const auto& own) { return own.evaluations; }, run.integrator);
  if (adapts(run.liquid.method())) output.diagnostics["courant_number"] = setting.courant_number;
  output.diagnostics["smallest_time_step_s"] = run.smallest_step;
  output.diagnostics["wall_crossings"] = static_cast<double>(output.exchanged_at_walls);
  for (const RecordedSeries& series : output.soundness)
    output.diagnostics["largest_" + series.name] = largest_magnitude(series.history);
  output.diagnostics["largest_packing_drift"] = largest_magnitude(output.packing_drift);
}

}  // namespace

double stable_step(const Liquid& liquid, double gravity) {
  return liquid.method().stable_step(
      largest_acceleration(liquid.rates, gravity),
      liquid.terms().speed_of_sound_at(largest_density(liquid.particles)));
}

RunOutput run(const Method& method, const Scene& scene, const Progress& progress) {
  if (!adapts(method)) check_fixed_step(scene, method.terms->setting);
  // A run that takes no steps, or goes on from a saved state, needs no prepared liquid.
  const bool prepares = scene.takes_steps && !scene.resume;
  RunMemory run(scene, method,
                prepares ? initial_state(scene, method) : start_lattice(scene, method));
  RunOutput& output = run.recorder.output;
  output.particles = run.liquid.particles.size();
  output.active_terms = terms_of_run(scene, method);
  if (scene.resume) {
    resume_from(run, scene, *scene.resume);
    ++run.sample;
  }
  check_state(run.liquid.particles, scene.rest_density, run.liquid.time);
  LastGoodState last_good;
  try {
    go_through(run, last_good, scene, progress);
  } catch (const SimulationError&) {
    if (last_good.kept()) scene.save_last_good_state(last_good.state(run, scene));
    throw;
  }
  add_diagnostics(run, scene, output);
  return std::move(output);
}

}  // namespace slosh::sph
