#include "sph/simulation.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "sph/free_surface_gauge.hpp"
#include "sph/initial_lattice.hpp"
#include "sph/liquid.hpp"
#include "sph/schemes.hpp"
#include "sph/stability_guard.hpp"

namespace slosh::sph {
namespace {

// Records what the scene asks for, at its sample times.
template <class Scheme>
class Recorder {
 public:
  Recorder(const Scene& scene, const Liquid<Scheme>& liquid)
      : scene_(scene), initial_potential_(potential(liquid)) {}

  void record(const Liquid<Scheme>& liquid) {
    const Particles& p = liquid.particles;
    check_state(p, scene_.rest_density, liquid.time);
    const double wall = scene_.displacement(liquid.time);
    for (const Gauge& gauge : scene_.gauges)
      push(output.elevation[gauge.name], liquid.time,
           surface_elevation(p, wall, scene_.tank_length, scene_.fill_depth, gauge.x));
    double kinetic = 0, force = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      kinetic +=
          0.5 * p.mass[i] * (p.velocity_x[i] * p.velocity_x[i] + p.velocity_z[i] * p.velocity_z[i]);
      force -= p.mass[i] * liquid.rates.acceleration_x[i];
    }
    push(output.kinetic_energy, liquid.time, kinetic);
    push(output.potential_energy, liquid.time, potential(liquid) - initial_potential_);
    // The walls' is the only horizontal force on the liquid, so its reaction is minus the
    // momentum's rate. Before the first step there is none.
    if (output.steps > 0) push(output.horizontal_force, liquid.time, force);
  }

  void record_snapshot(const Liquid<Scheme>& liquid) const {
    const Particles& p = liquid.particles;
    const double wall = scene_.displacement(liquid.time);
    Snapshot snapshot{liquid.time, {}, {}, {}, {}, {}, {}};
    snapshot.z.assign(p.z.begin(), p.z.end());
    snapshot.velocity_x.assign(p.velocity_x.begin(), p.velocity_x.end());
    snapshot.velocity_z.assign(p.velocity_z.begin(), p.velocity_z.end());
    snapshot.density.assign(p.density.begin(), p.density.end());
    for (std::size_t i = 0; i < p.size(); ++i) {
      snapshot.x.push_back(p.x[i] - wall);
      snapshot.pressure.push_back(liquid.scheme().state.pressure(p.density[i]));
    }
    scene_.record_snapshot(snapshot);
  }

  RunOutput output;

 private:
  static void push(History& history, double time, double value) {
    history.time.push_back(time);
    history.value.push_back(value);
  }
  static double potential(const Liquid<Scheme>& liquid) {
    double sum = 0;
    for (std::size_t i = 0; i < liquid.particles.size(); ++i)
      sum += liquid.particles.mass[i] * liquid.scheme().gravity * liquid.particles.z[i];
    return sum;
  }

  const Scene& scene_;
  double initial_potential_;
};

double largest_acceleration(const Rates& rates, double gravity) {
  double largest2 = gravity * gravity;
  for (std::size_t i = 0; i < rates.acceleration_x.size(); ++i)
    largest2 = std::max(largest2, rates.acceleration_x[i] * rates.acceleration_x[i] +
                                      rates.acceleration_z[i] * rates.acceleration_z[i]);
  return std::sqrt(largest2);
}

template <class Scheme>
void check_fixed_step(const Scene& scene, const Scheme& scheme) {
  const double h =
      Scheme::smoothing_ratio * std::min(scene.particle_spacing, scene.surface_particle_spacing);
  const double dt = scheme.time_step(scene, 0),
               limit = Scheme::stable_courant_number * h / scheme.state.speed_of_sound;
  if (!(dt <= limit))
    throw SimulationError(
        fmt::format("the scheme's fixed time step {} s is unstable at particle spacing {} m: "
                    "expected at most {:.3g} s",
                    dt, std::min(scene.particle_spacing, scene.surface_particle_spacing), limit));
}

// How many samples a snapshot comes after the one before it.
double samples_per_snapshot(const Scene& scene) {
  const double ratio = scene.snapshot_interval / scene.sample_interval, whole = std::round(ratio);
  if (!(whole >= 1 && std::abs(ratio - whole) <= 1e-9 * whole))
    throw std::invalid_argument(
        fmt::format("snapshot interval = {} s: expected a multiple of the sample interval of {} s",
                    scene.snapshot_interval, scene.sample_interval));
  return whole;
}

template <class Scheme>
RunOutput run_scheme(const Scene& scene, const Progress& progress) {
  const Scheme scheme(scene);
  if constexpr (Scheme::fixed_step) check_fixed_step(scene, scheme);
  Liquid<Scheme> liquid(scene, scheme, initial_lattice(scene, scheme.state));
  typename Scheme::Integrator integrator;
  Recorder<Scheme> recorder(scene, liquid);
  RunOutput& output = recorder.output;
  output.particles = liquid.particles.size();
  const bool snapshots = scene.snapshot_interval != 0;
  const double stride = snapshots ? samples_per_snapshot(scene) : 0;
  double smallest_step = std::numeric_limits<double>::infinity();
  auto last_report = std::chrono::steady_clock::now();

  const int samples = static_cast<int>(std::floor(scene.duration / scene.sample_interval + 1e-9));
  for (int sample = 0; sample <= samples; ++sample) {
    const double target = sample * scene.sample_interval;
    while (liquid.time < target) {
      // Equal steps up to the sample, each at most the stable one; the last one lands on it
      // exactly.
      const double left = target - liquid.time;
      const double stable =
          scheme.time_step(scene, largest_acceleration(liquid.rates, scene.gravity));
      const double count = std::ceil(left / stable - 1e-9);
      const double dt = left / count;
      integrator.advance(liquid, dt);
      liquid.time = count <= 1 ? target : liquid.time + dt;
      smallest_step = std::min(smallest_step, dt);
      output.steps += 1;
    }
    recorder.record(liquid);
    if (snapshots && std::fmod(sample, stride) == 0) recorder.record_snapshot(liquid);
    if (progress &&
        std::chrono::steady_clock::now() - last_report > std::chrono::milliseconds(100)) {
      progress(liquid.time, output.steps);
      last_report = std::chrono::steady_clock::now();
    }
  }
  output.active_terms = active_terms<Scheme>();
  output.diagnostics["speed_of_sound_m_s"] = scheme.state.speed_of_sound;
  output.diagnostics["smallest_time_step_s"] = smallest_step;
  return std::move(output);
}

}  // namespace

std::vector<std::string> scheme_names() {
  return {"li2010", "low_dissipation", "low_dissipation_wendland"};
}

RunOutput run(const std::string& scheme, const Scene& scene, const Progress& progress) {
  const bool uniform = scene.surface_particle_spacing == scene.particle_spacing;
  if (scheme == "li2010" && uniform) return run_scheme<Li2010<UniformSmoothing>>(scene, progress);
  if (scheme == "li2010") return run_scheme<Li2010<PairSmoothing>>(scene, progress);
  if (!uniform && scheme.starts_with("low_dissipation"))
    throw std::invalid_argument("scheme " + scheme +
                                " takes one particle spacing: surface_particle_spacing differs");
  if (scheme == "low_dissipation")
    return run_scheme<LowDissipation<QuinticSpline>>(scene, progress);
  if (scheme == "low_dissipation_wendland")
    return run_scheme<LowDissipation<WendlandC2>>(scene, progress);
  throw std::invalid_argument(
      fmt::format("scheme = \"{}\": expected one of {}", scheme, fmt::join(scheme_names(), " | ")));
}

}  // namespace slosh::sph
