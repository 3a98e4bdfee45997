// With the area A and the centroid (xc, zc) of the liquid at rest and the width w of its surface,
//   F_x = -rho [g theta A + (A (z0-zc) - turn_flux - (z0-h) line_flux) theta''
//               - g sum kappa_n <x, phi_n> zeta_n]
//   F_z = -rho A [g + (xc-x0) theta'']
//   M   = -rho [g A (xc-x0) - g theta (A (zc-z0) + w^3/12) + J theta'' - g sum c_n zeta_n],
//   J   = turn_energy - 2 A ((z0-h)(zc-h) + (x0-xm)(xc-xm)) + A ((z0-h)^2 + (x0-xm)^2)
//         - 2 (z0-h) turn_flux - (z0-h)^2 line_flux.
#include "reference/section/section_roll.hpp"

#include <cmath>

#include "reference/mode_response.hpp"
#include "reference/require.hpp"
#include "reference/section/section_flow.hpp"

namespace slosh::reference {
namespace {

constexpr auto in_section_roll = "SectionRoll";

const SectionRollMotion& checked(const SectionRollMotion& motion) {
  for (const auto* function : {&motion.angle, &motion.rate, &motion.acceleration}) {
    require(static_cast<bool>(*function), in_section_roll, "motion", "an empty function",
            "angle, rate and acceleration of the time, all three");
  }
  require(std::isfinite(motion.axis.x) && std::isfinite(motion.axis.z), in_section_roll, "axis",
          fmt::format("({}, {})", motion.axis.x, motion.axis.z), "a finite position, m");
  require(std::isfinite(motion.rate(0)), in_section_roll, "initial rate", motion.rate(0),
          "a finite rate, rad/s");
  return motion;
}

std::vector<TankMode> modes_of_roll(const SectionFlow& flow, Start start,
                                    const SectionRollMotion& motion) {
  std::vector<TankMode> modes;
  const double rate = checked(motion).rate(0), above = motion.axis.z - flow.middle().z;
  for (Eigen::Index n = 0; n < flow.modes(); ++n) {
    const double kappa = flow.wave_numbers[n], line = flow.lines[n];
    const double coupling = kappa * (flow.turns[n] + above * line) - line;
    modes.push_back({.wave_number = kappa,
                     .depth_factor = 1,
                     .line = line,
                     .coupling = coupling,
                     .natural_frequency = std::sqrt(flow.section().gravity * kappa),
                     .initial_rate = (start == Start::earth ? -coupling : line) * rate});
  }
  return modes;
}

}  // namespace

struct SectionRoll::Waves {
  std::shared_ptr<const SectionFlow> flow;
  std::function<double(double)> angle, rate;
  std::vector<TankMode> modes;
  double right, above;  // the axis from the surface's middle
  DuhamelModes response;

  Waves(const SectionModes& section, Start start, const SectionRollMotion& motion)
      : flow(section.flow()),
        angle(motion.angle),
        rate(motion.rate),
        modes(modes_of_roll(*flow, start, motion)),
        right(motion.axis.x - flow->middle().x),
        above(motion.axis.z - flow->middle().z),
        response(modes, {in_section_roll, motion.acceleration, motion.duration, motion.step,
                         motion.knots}) {}

  double checked_time(double t) const {
    return time_within(in_section_roll, t, response.duration());
  }

  double checked_angle(double t) const {
    const double theta = angle(t);
    require(std::isfinite(theta), in_section_roll, fmt::format("angle at {} s", t), theta,
            "a finite angle, rad");
    return theta;
  }

  // Returns sum zeta_n phi_n at a place with the potentials given.
  double wave(const Eigen::VectorXd& potential, double t) const {
    const double g = flow->section().gravity;
    double sum =
        -response.acceleration(t) / g *
        (potential[flow->lid()] + above * potential[flow->line()] - potential[flow->lifted_line()]);
    for (std::size_t n = 0; n < modes.size(); ++n) {
      sum -= response.state(n, t).acceleration / (g * modes[n].wave_number) * potential[n];
    }
    return sum;
  }
};

SectionRoll::SectionRoll(const SectionModes& modes, Start start, const SectionRollMotion& motion)
    : waves_(std::make_unique<Waves>(modes, start, motion)) {}
SectionRoll::~SectionRoll() = default;
SectionRoll::SectionRoll(SectionRoll&&) noexcept = default;

double SectionRoll::elevation(double x, double t) const {
  return elevation(x, std::span(&t, 1)).front();
}

std::vector<double> SectionRoll::elevation(double x, std::span<const double> times) const {
  const auto place = waves_->flow->on_surface(in_section_roll, x);
  std::vector<double> series;
  series.reserve(times.size());
  for (const double t : times) {
    const double time = waves_->checked_time(t);
    series.push_back(waves_->wave(place.potential, time) -
                     waves_->checked_angle(time) * (x - waves_->flow->middle().x));
  }
  return series;
}

SectionRoll::Velocity SectionRoll::velocity(double x, double z, double t) const {
  const SectionFlow& flow = *waves_->flow;
  const auto place = flow.values(in_section_roll, x, z);
  const double time = waves_->checked_time(t), turning = waves_->rate(time);
  const Eigen::Index turn = flow.turn(), lifted = flow.lifted_line();
  Velocity velocity{turning * (place.x_slope[turn] - place.x_slope[lifted] + z - flow.middle().z),
                    turning * (place.z_slope[turn] - place.z_slope[lifted] - x + flow.middle().x)};
  for (std::size_t n = 0; n < waves_->modes.size(); ++n) {
    const double potential = waves_->response.state(n, time).rate / waves_->modes[n].wave_number;
    velocity.x += potential * place.x_slope[n];
    velocity.z += potential * place.z_slope[n];
  }
  return velocity;
}

double SectionRoll::pressure(double x, double z, double t) const {
  return pressure(x, z, std::span(&t, 1)).front();
}

std::vector<double> SectionRoll::pressure(double x, double z, std::span<const double> times) const {
  const SectionFlow& flow = *waves_->flow;
  const double g = flow.section().gravity;
  const auto place = flow.values(in_section_roll, x, z);
  const double side = x - flow.middle().x, up = z - flow.middle().z;
  const double carried = place.potential[flow.turn()] - place.potential[flow.lid()] +
                         waves_->above * (side - place.potential[flow.line()]) - waves_->right * up;
  std::vector<double> series;
  series.reserve(times.size());
  for (const double t : times) {
    const double time = waves_->checked_time(t);
    series.push_back(-flow.section().density * (g * (up + waves_->checked_angle(time) * side -
                                                     waves_->wave(place.potential, time)) +
                                                waves_->response.acceleration(time) * carried));
  }
  return series;
}

SectionRoll::Force SectionRoll::force(double t) const {
  const SectionFlow& flow = *waves_->flow;
  const double time = waves_->checked_time(t), g = flow.section().gravity;
  const double acceleration = waves_->response.acceleration(time), area = flow.area();
  const double above_centroid = waves_->above + flow.middle().z - flow.centroid().z;
  const double to_centroid = flow.centroid().x - flow.middle().x - waves_->right;
  double wave_part = 0;
  for (std::size_t n = 0; n < waves_->modes.size(); ++n) {
    const TankMode& mode = waves_->modes[n];
    wave_part += mode.wave_number * mode.line * waves_->response.state(n, time).elevation;
  }
  const double inertia = area * above_centroid - flow.turn_flux - waves_->above * flow.line_flux;
  return {-flow.section().density *
              (g * area * waves_->checked_angle(time) + inertia * acceleration - g * wave_part),
          -flow.section().density * area * (g + to_centroid * acceleration)};
}

double SectionRoll::moment(double t) const {
  const SectionFlow& flow = *waves_->flow;
  const double time = waves_->checked_time(t), g = flow.section().gravity, area = flow.area();
  const double width = flow.right() - flow.left(), right = waves_->right, above = waves_->above;
  const double centroid_x = flow.centroid().x - flow.middle().x,
               centroid_z = flow.centroid().z - flow.middle().z;
  const double inertia = flow.turn_energy - 2 * area * (above * centroid_z + right * centroid_x) +
                         area * (above * above + right * right) - 2 * above * flow.turn_flux -
                         above * above * flow.line_flux;
  double wave_part = 0;
  for (std::size_t n = 0; n < waves_->modes.size(); ++n) {
    wave_part += waves_->modes[n].coupling * waves_->response.state(n, time).elevation;
  }
  const double stiffness = area * (centroid_z - above) + width * width * width / 12;
  return -flow.section().density *
         (g * area * (centroid_x - right) - g * waves_->checked_angle(time) * stiffness +
          inertia * waves_->response.acceleration(time) - g * wave_part);
}

}  // namespace slosh::reference
