#include "reference/mode_response.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/require.hpp"

namespace slosh::reference {
namespace {

// Advances one mode's state over an interval of a given length.
struct Propagator {
  double natural_frequency;
  double cosine, sine;   // of w s
  double step_response;  // (1 - cos(w s))/w^2 [s2]
  double ramp_response;  // (s - sin(w s)/w)/w^2 [s3]

  Propagator(double w, double s)
      : natural_frequency(w), cosine(std::cos(w * s)), sine(std::sin(w * s)) {
    const double half = std::sin(w * s / 2);  // 1 - cos without cancellation
    step_response = 2 * half * half / (w * w);
    ramp_response = (s - sine / w) / (w * w);
  }

  double elevation(double value, double rate, double f0, double f1) const {
    return value * cosine + rate / natural_frequency * sine + f0 * step_response +
           f1 * ramp_response;
  }
  double rate(double value, double rate, double f0, double f1) const {
    return -natural_frequency * value * sine + rate * cosine + f0 * sine / natural_frequency +
           f1 * step_response;
  }
};

// Of an interval: lengths that differ by the rounding of their ends are one.
constexpr double same_length = 1e-9;

std::vector<double> checked_times(const SampledMotion& motion) {
  const std::string_view where = motion.solution;
  const auto& [name, acceleration, duration, step, knots] = motion;
  require(duration > 0 && std::isfinite(duration), where, "duration", duration, "a time > 0 s");
  require(step > 0 && step <= duration, where, "step", step,
          "a time step > 0 s and up to the duration");
  for (std::size_t i = 0; i < knots.size(); ++i)
    require(i == 0 ? knots[i] == 0 : knots[i] > knots[i - 1], where, "knot", knots[i],
            "times that rise from 0 s to the duration");
  if (!knots.empty()) {
    require(knots.back() == duration, where, "last knot", knots.back(), "the duration");
    return knots;
  }
  // Where the duration is a whole number of steps but for rounding, no tiny last interval is added.
  const auto intervals = static_cast<std::size_t>(std::ceil(duration / step - 1e-9));
  std::vector<double> times;
  for (std::size_t i = 0; i < intervals; ++i) times.push_back(static_cast<double>(i) * step);
  times.push_back(duration);
  return times;
}

}  // namespace

SineInstant::SineInstant(const SineSurge& motion, double t)
    : time(t),
      amplitude(motion.amplitude),
      angular_frequency(motion.angular_frequency),
      phase_cosine(std::cos(motion.phase)),
      phase_sine(std::sin(motion.phase)),
      cosine(std::cos(angular_frequency * t / 2)),
      sine(std::sin(angular_frequency * t / 2)),
      phased_sine(std::sin(angular_frequency * t + motion.phase)) {}

ModeState forced_mode(const TankMode& mode, const SineSurge& motion, double t) {
  return forced_mode(mode, SineInstant(motion, t));
}

// By the half angles of the mode and of the motion, so that a mode costs one sine and one cosine.
// The beat's own angle is taken where it is small: there the difference would cancel.
ModeState forced_mode(const TankMode& mode, const SineInstant& now) {
  const double t = now.time, omega = now.angular_frequency;
  const double omega_n = mode.natural_frequency;
  const double force = mode.coupling * now.amplitude * omega * omega;
  const double sigma = omega_n + omega;
  const double of_sine = force / sigma * now.phase_cosine,
               of_cosine = force / sigma * now.phase_sine;
  const double sine = now.sine, cosine = now.cosine, mode_sine = std::sin(omega_n * t / 2),
               mode_cosine = std::cos(omega_n * t / 2);
  const double fast_sine = mode_sine * cosine + mode_cosine * sine,
               fast_cosine = mode_cosine * cosine - mode_sine * sine;
  const double slow = (omega_n - omega) * t / 2,
               slow_sine =
                   std::abs(slow) < 0.1 ? std::sin(slow) : mode_sine * cosine - mode_cosine * sine,
               slow_cosine = mode_cosine * cosine + mode_sine * sine;
  const double beat = slow == 0 ? t : t * slow_sine / slow;

  const double elevation = mode.initial_rate / omega_n * 2 * mode_sine * mode_cosine +
                           of_sine / omega_n * (2 * sine * cosine - omega * beat * fast_cosine) +
                           of_cosine * beat * fast_sine;
  const double rate = mode.initial_rate * (1 - 2 * mode_sine * mode_sine) +
                      of_sine * omega * beat * fast_sine +
                      of_cosine * (sigma / 2 * beat * fast_cosine + fast_sine * slow_cosine);
  return {elevation, rate, force * now.phased_sine - omega_n * omega_n * elevation};
}

DuhamelModes::DuhamelModes(std::vector<TankMode> modes, const SampledMotion& motion)
    : modes_(std::move(modes)), times_(checked_times(motion)) {
  for (const double time : times_) {
    acceleration_.push_back(motion.acceleration(time));
    require(std::isfinite(acceleration_.back()), motion.solution,
            fmt::format("acceleration at {} s", time), acceleration_.back(),
            "a finite acceleration");
  }

  nodes_.resize(times_.size() * modes_.size());
  for (std::size_t n = 0; n < modes_.size(); ++n) {
    const TankMode& mode = modes_[n];
    Propagator carry(mode.natural_frequency, times_[1]);
    double carried = times_[1];
    Node node{0, mode.initial_rate};
    nodes_[n] = node;
    for (std::size_t i = 0; i + 1 < times_.size(); ++i) {
      const double length = times_[i + 1] - times_[i];
      if (std::abs(length - carried) > same_length * length)
        carry = Propagator(mode.natural_frequency, carried = length);
      const double f0 = -mode.coupling * acceleration_[i], f1 = -mode.coupling * slope(i);
      node = {carry.elevation(node.elevation, node.rate, f0, f1),
              carry.rate(node.elevation, node.rate, f0, f1)};
      nodes_[(i + 1) * modes_.size() + n] = node;
    }
  }
}

std::size_t DuhamelModes::interval(double t) const {
  const auto after = std::upper_bound(times_.begin() + 1, times_.end() - 1, t);
  return static_cast<std::size_t>(after - times_.begin()) - 1;
}

double DuhamelModes::slope(std::size_t i) const {
  return (acceleration_[i + 1] - acceleration_[i]) / (times_[i + 1] - times_[i]);
}

double DuhamelModes::acceleration(double t) const {
  const std::size_t i = interval(t);
  return acceleration_[i] + slope(i) * (t - times_[i]);
}

ModeState DuhamelModes::state(std::size_t n, double t) const {
  const TankMode& mode = modes_[n];
  const std::size_t i = interval(t);
  const double s = t - times_[i];
  const double f0 = -mode.coupling * acceleration_[i], f1 = -mode.coupling * slope(i);
  const double w = mode.natural_frequency;
  const Propagator carry(w, s);
  const Node& start = nodes_[i * modes_.size() + n];
  const double elevation = carry.elevation(start.elevation, start.rate, f0, f1);
  return {elevation, carry.rate(start.elevation, start.rate, f0, f1),
          f0 + f1 * s - w * w * elevation};
}

}  // namespace slosh::reference
