// A liquid that is advanced as in a run (run.hpp), with the time of the neighbour search
// measured separately.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "sph/benchmarks/flows.hpp"
#include "sph/guards/stability_guard.hpp"
#include "sph/liquid.hpp"
#include "sph/run.hpp"
#include "sph/scheme.hpp"

namespace slosh::sph {

class Stepping {
 public:
  virtual ~Stepping() = default;
  virtual void step() = 0;
  // Throws unless the state is finite and the liquid's energy has not grown.
  virtual void check() const = 0;
  virtual std::size_t particles() const = 0;
  // Time and number of the neighbour lists' renewals so far.
  double neighbour_seconds = 0;
  long rebuilds = 0;
};

class TimedLiquid : public Liquid {
 public:
  TimedLiquid(const Scene& scene, Method method, Particles initial, Stepping& stepping)
      : Liquid(scene, std::move(method), std::move(initial)), stepping_(stepping) {}

  void renew_neighbours(double dt) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    if (Liquid::renew_neighbours(dt)) ++stepping_.rebuilds;
    stepping_.neighbour_seconds += std::chrono::duration<double>(Clock::now() - start).count();
  }

 private:
  Stepping& stepping_;
};

template <class Choice>
class SteppingOf : public Stepping {
 public:
  SteppingOf(const Scene& scene, Flow flow)
      : scene_(scene),
        scheme_(scene_),
        liquid_(scene_, method_of(scheme_), flowing(scene_, scheme_, flow), *this),
        first_energy_(energy()) {}

  void step() override {
    double dt = Choice::TimeStep::adapts
                    ? stable_step(liquid_, scene_.gravity)
                    : 0.4 * scheme_.setting.smoothing_length() / scheme_.setting.speed_of_sound;
    integrator_.advance(liquid_, dt);
    liquid_.time += dt;
  }

  void check() const override {
    check_state(liquid_.particles, scene_.rest_density, liquid_.time);
    // The elastic energy is neglected; it is a ten-thousandth in a calm liquid.
    const double now = energy();
    if (!(std::abs(now - first_energy_) <= 0.05 * first_energy_))
      throw std::runtime_error(fmt::format("energy = {} J/m after {} s, {} J/m at the start", now,
                                           liquid_.time, first_energy_));
  }
  std::size_t particles() const override { return liquid_.particles.size(); }

 private:
  double energy() const {
    const Particles& p = liquid_.particles;
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double speed2 = p.velocity_x[i] * p.velocity_x[i] + p.velocity_z[i] * p.velocity_z[i];
      sum += p.mass[i] * (0.5 * speed2 + scene_.gravity * p.z[i]);
    }
    return sum;
  }

  const Scene scene_;
  const Scheme<Choice> scheme_;
  TimedLiquid liquid_;
  typename Choice::Integrator integrator_;
  double first_energy_;
};

}  // namespace slosh::sph
