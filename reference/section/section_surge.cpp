#include "reference/section/section_surge.hpp"

#include <cmath>

#include "reference/require.hpp"
#include "reference/section/section_flow.hpp"

namespace slosh::reference {
namespace {

constexpr auto in_section_surge = "SectionSurge";

std::vector<TankMode> modes_of_surge(const SectionFlow& flow, double initial_velocity) {
  require(std::isfinite(initial_velocity), in_section_surge, "initial velocity", initial_velocity,
          "a finite velocity, m/s");
  std::vector<TankMode> modes;
  for (Eigen::Index n = 0; n < flow.modes(); ++n) {
    const double coupling = flow.wave_numbers[n] * flow.lines[n];
    modes.push_back({.wave_number = flow.wave_numbers[n],
                     .depth_factor = 1,
                     .line = flow.lines[n],
                     .coupling = coupling,
                     .natural_frequency = std::sqrt(flow.section().gravity * flow.wave_numbers[n]),
                     .initial_rate = -coupling * initial_velocity});
  }
  return modes;
}

}  // namespace

struct SectionSurge::Waves {
  std::shared_ptr<const SectionFlow> flow;
  SurgeResponse response;

  template <class Motion>
  Waves(const SectionModes& modes, Start start, const Motion& motion)
      : flow(modes.flow()),
        response(in_section_surge,
                 modes_of_surge(
                     *flow, start == Start::earth ? SurgeResponse::initial_velocity(motion) : 0),
                 motion) {}

  // Returns sum e_n phi_n at a place with the potentials given.
  double wave(const Eigen::VectorXd& potential, double t) const {
    const double g = flow->section().gravity;
    double sum = -response.tank_acceleration(t) / g * potential[flow->line()];
    response.for_each_state(t, [&](std::size_t n, const ModeState& state) {
      sum -= state.acceleration / (g * flow->wave_numbers[n]) * potential[n];
    });
    return sum;
  }
};

SectionSurge::SectionSurge(const SectionModes& modes, Start start, const SineSurge& motion)
    : waves_(std::make_unique<Waves>(modes, start, motion)) {}
SectionSurge::SectionSurge(const SectionModes& modes, Start start, const AnySurge& motion)
    : waves_(std::make_unique<Waves>(modes, start, motion)) {}
SectionSurge::~SectionSurge() = default;
SectionSurge::SectionSurge(SectionSurge&&) noexcept = default;

double SectionSurge::elevation(double x, double t) const {
  return elevation(x, std::span(&t, 1)).front();
}

std::vector<double> SectionSurge::elevation(double x, std::span<const double> times) const {
  const auto place = waves_->flow->on_surface(in_section_surge, x);
  std::vector<double> series;
  series.reserve(times.size());
  for (const double t : times) {
    series.push_back(waves_->wave(place.potential, waves_->response.checked_time(t)));
  }
  return series;
}

SectionSurge::Velocity SectionSurge::velocity(double x, double z, double t) const {
  const auto place = waves_->flow->values(in_section_surge, x, z);
  const double time = waves_->response.checked_time(t);
  Velocity velocity{0, 0};
  waves_->response.for_each_state(time, [&](std::size_t n, const ModeState& state) {
    const double potential = state.rate / waves_->flow->wave_numbers[n];
    velocity.x += potential * place.x_slope[n];
    velocity.z += potential * place.z_slope[n];
  });
  return velocity;
}

double SectionSurge::pressure(double x, double z, double t) const {
  return pressure(x, z, std::span(&t, 1)).front();
}

std::vector<double> SectionSurge::pressure(double x, double z,
                                           std::span<const double> times) const {
  const SectionFlow& flow = *waves_->flow;
  const double g = flow.section().gravity;
  const auto place = flow.values(in_section_surge, x, z);
  const double carried = x - flow.middle().x - place.potential[flow.line()];
  std::vector<double> series;
  series.reserve(times.size());
  for (const double t : times) {
    const double time = waves_->response.checked_time(t);
    series.push_back(-flow.section().density *
                     (g * (z - flow.middle().z - waves_->wave(place.potential, time)) +
                      waves_->response.tank_acceleration(time) * carried));
  }
  return series;
}

double SectionSurge::horizontal_force(double t) const {
  const SectionFlow& flow = *waves_->flow;
  const double time = waves_->response.checked_time(t);
  double wave_part = 0;
  waves_->response.for_each_state(time, [&](std::size_t n, const ModeState& state) {
    wave_part += waves_->response.modes()[n].coupling * state.elevation;
  });
  return -flow.section().density *
         (waves_->response.tank_acceleration(time) * (flow.area() - flow.line_flux) -
          flow.section().gravity * wave_part);
}

}  // namespace slosh::reference
