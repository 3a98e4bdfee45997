#include "reference/potential_flow/nonlinear_potential_flow.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <numbers>

#include "reference/natural_frequency.hpp"
#include "reference/potential_flow/decompositions.hpp"
#include "reference/potential_flow/free_surface_flow.hpp"
#include "reference/require.hpp"

namespace slosh::reference {
namespace {

namespace odeint = boost::numeric::odeint;
using Eigen::Index, Eigen::VectorXd;

constexpr auto in_nonlinear_potential_flow = "run_nonlinear_potential_flow";

constexpr double step_tolerance = 1e-11;
// In first natural periods. With 64 nodes the grid's highest mode needs a step of 1/150.
constexpr double first_step = 1e-3, longest_step = 0.05, shortest_step = 1e-6;

constexpr double steepest_slope = 2, driest_depth = 0.02;
constexpr double most_unresolved = 1e-3, worst_volume = 1e-8, worst_energy = 1e-4;
// A tank that has the acceleration a at 0 s excites the n-th mode by 4 a L/(g n^2 pi^2), and the
// last Legendre coefficients by a L/(g nodes_x^2) times a factor of 3 to 4, as measured on 48 to 96
// nodes with waves of 0.7 and 70 mm in a tank of 1.73 m.
constexpr double start_waves = 8;
// With this limit in all, 48 and 64 nodes were within 5e-4 of 96 nodes over 6 s of such a start.
constexpr double most_unresolved_ever = 1e-2;
// Waves at the grid's scale grow slowly from rounding errors (Longuet-Higgins & Cokelet, 1976,
// smoothed theirs). The k-th of n Legendre coefficients is therefore damped at the rate
// 10 sqrt(g/length) (k/n)^16. Without the damping such waves overwhelm a wave of 0.1 m in a tank of
// 1 m after 4 s, with 48 nodes as with 64; with it the wave keeps its energy to 3e-10 over 20 s
// with 64 nodes.
constexpr double smoothing_rate = 10;
constexpr int smoothing_power = 16;
// In lengths of the tank. Errors are compared with a wave of this height at least: the first
// moments of any motion raise a lower wave that is too sharp at the walls for any grid.
constexpr double lowest_wave = 1e-3;

void check(const NonlinearSloshing& sloshing, const Observation& observation) {
  const Tank& tank = sloshing.tank;
  natural_frequency(tank, 1);  // throws for an impossible length, depth or gravity
  require(tank.density > 0 && std::isfinite(tank.density), in_nonlinear_potential_flow,
          "liquid density", tank.density, "a density > 0 kg/m3");
  require(sloshing.roof > 0, in_nonlinear_potential_flow, "roof", sloshing.roof,
          "a height > 0 m above the surface");
  require(sloshing.nodes_x >= 8, in_nonlinear_potential_flow, "nodes_x", sloshing.nodes_x,
          "8 or more");
  require(sloshing.nodes_z >= 8, in_nonlinear_potential_flow, "nodes_z", sloshing.nodes_z,
          "8 or more");
  double last = 0;
  for (const double t : observation.times) {
    require(t >= last && std::isfinite(t), in_nonlinear_potential_flow, "time", t,
            "rising times from 0 s on");
    last = t;
  }
  for (const double x : observation.gauges) require_within(tank, in_nonlinear_potential_flow, x);
  for (const auto& [x, z] : observation.places) {
    require_within(tank, in_nonlinear_potential_flow, x);
    require(z >= -(1 + rounding) * tank.fill_depth && z <= sloshing.roof,
            in_nonlinear_potential_flow, "z", z, "a height from the bottom to the roof, m");
  }
}

class Run {
 public:
  Run(const NonlinearSloshing& sloshing, const Observation& observation)
      : sloshing_(sloshing),
        observation_(observation),
        flow_(sloshing.tank, sloshing.motion, sloshing.nodes_x, sloshing.nodes_z),
        from_coefficients_(inverse(flow_.x().coefficients)),
        period_(2 * std::numbers::pi / natural_frequency(sloshing.tank, 1)) {
    record_.elevation.resize(observation.gauges.size());
    for (auto* series : {&record_.pressure, &record_.velocity_x, &record_.velocity_z})
      series->resize(observation.places.size());
  }

  NonlinearRecord run() {
    try {
      start();
      for (const double time : observation_.times) {
        while (t_ < time && record_.left_range_because.empty()) advance(time);
        if (!record_.left_range_because.empty()) break;
        observe();
      }
    } catch (const NoLaplaceSolution& error) {
      record_.left_range_because = error.what();
    }
    return std::move(record_);
  }

 private:
  // eta, phi and the integral of dH/dt, made dimensionless by the tank's scales of length, velocity
  // and energy, so that one tolerance applies to all.
  using Packed = std::vector<double>;

  FreeSurfaceFlow::State unpack(const Packed& y) const {
    const Index n = sloshing_.nodes_x;
    return {Eigen::Map<const VectorXd>(y.data(), n) * length(),
            Eigen::Map<const VectorXd>(y.data() + n, n) * (length() * velocity())};
  }
  double length() const { return sloshing_.tank.length; }
  double velocity() const { return std::sqrt(sloshing_.tank.gravity * length()); }
  // A thousandth of g length^3, as a wave's energy is of second order.
  double energy_unit() const { return 1e-3 * sloshing_.tank.gravity * std::pow(length(), 3); }

  void rates(const Packed& y, Packed& dydt, double t) {
    rates_ = flow_.rates(unpack(y), t);
    const Index n = sloshing_.nodes_x;
    Eigen::Map<VectorXd>(dydt.data(), n) = rates_.elevation / length();
    Eigen::Map<VectorXd>(dydt.data() + n, n) = rates_.potential / (length() * velocity());
    dydt[2 * n] = rates_.energy_rate / energy_unit();
  }

  void start() {
    const LegendreGrid& grid = flow_.x();
    const Index n = grid.nodes.size();
    const double tilt = place(sloshing_.motion, 0).angle;
    require(std::abs(tilt) < std::numbers::pi / 2, in_nonlinear_potential_flow, "angle at 0 s",
            tilt, "an angle within a quarter turn, rad");
    VectorXd elevation = -std::tan(tilt) * grid.nodes;
    if (sloshing_.initial_elevation) elevation = grid.nodes.unaryExpr(sloshing_.initial_elevation);
    require(elevation.allFinite(), in_nonlinear_potential_flow, "initial elevation",
            elevation.sum(), "finite heights, m");
    VectorXd potential = flow_.potential_at_rest_in_tank(elevation, 0);
    if (sloshing_.start == Start::earth) {
      const VectorXd at_rest = potential;
      for (Index mode = 1; 2 * mode <= n; ++mode) {
        const VectorXd shape =
            (mode * std::numbers::pi * (grid.nodes.array() / length() + 0.5)).cos();
        const double share = 2 / length() * grid.weights.dot(shape.cwiseProduct(at_rest));
        const double set_off = std::exp(-36 * std::pow(2.5 * mode / n, 8));
        potential -= set_off * share * shape;
      }
    }
    y_.assign(2 * n + 1, 0.0);
    Eigen::Map<VectorXd>(y_.data(), n) = elevation / length();
    Eigen::Map<VectorXd>(y_.data() + n, n) = potential / (length() * velocity());
    dydt_.resize(y_.size());
    rates(y_, dydt_, 0);
    const RigidField push = place(sloshing_.motion, 0).acceleration;
    start_waves_ = start_waves * std::abs(push.along_x(0)) / sloshing_.tank.gravity * length() /
                   (static_cast<double>(n) * n);
    first_energy_ = rates_.energy;
    first_volume_ = grid.weights.dot(elevation);
    watch();
  }

  // Tries one step, at most up to `until`.
  void advance(double until) {
    Packed y = y_;
    double t = t_, step = std::min(step_, until - t_);
    const bool to_the_end = step < step_;
    odeint::controlled_step_result result = odeint::fail;
    std::string why = "the time step falls below a millionth of the first natural period";
    try {
      result =
          stepper_.try_step([this](const Packed& y, Packed& dydt, double t) { rates(y, dydt, t); },
                            y, dydt_, t, step);
    } catch (const NoLaplaceSolution& error) {
      why = error.what();
      step /= 4;
    }
    if (result == odeint::fail) {
      step_ = step;
      if (step_ < shortest_step * period_) record_.left_range_because = why;
      return;
    }
    if (!to_the_end) step_ = std::min(step, longest_step * period_);
    const double before = t_;
    y_.swap(y);
    t_ = to_the_end ? until : t;
    smooth(t_ - before);
    rates(y_, dydt_, t_);
    watch();
    if (!record_.left_range_because.empty()) t_ = before;
  }

  void smooth(double step) {
    const Index n = sloshing_.nodes_x;
    const double rate = smoothing_rate * velocity() / length();
    const Eigen::ArrayXd order = Eigen::ArrayXd::LinSpaced(n, 0, 1);
    const Eigen::ArrayXd kept = (-rate * step * order.pow(smoothing_power)).exp();
    Eigen::Map<Eigen::MatrixXd> fields(y_.data(), n, 2);
    fields = from_coefficients_ * kept.matrix().asDiagonal() * (flow_.x().coefficients * fields);
  }

  // Sets left_range_because where the flow has left its valid range at t_.
  void watch() {
    const LegendreGrid& grid = flow_.x();
    const VectorXd elevation = unpack(y_).elevation;
    const double depth = sloshing_.tank.fill_depth, g = sloshing_.tank.gravity;
    Index top, steepest;
    const double crest = elevation.maxCoeff(&top), lowest = elevation.minCoeff() + depth;
    const double slope = (grid.derivative * elevation).cwiseAbs().maxCoeff(&steepest);

    // The height of a first-mode wave with the surface's largest velocity counts too.
    wave_ = std::max({wave_, elevation.cwiseAbs().maxCoeff(),
                      rates_.elevation.cwiseAbs().maxCoeff() * period_ / (2 * std::numbers::pi)});
    const VectorXd tail = (grid.coefficients * elevation).tail(elevation.size() / 4).cwiseAbs();
    unresolved_ = tail.maxCoeff() / wave_;
    volume_error_ = (grid.weights.dot(elevation) - first_volume_) / length();
    energy_error_ = (rates_.energy - first_energy_ - y_.back() * energy_unit()) /
                    (g * length() * wave_ * wave_ / 2);

    record_.left_range_because = [&]() -> std::string {
      const auto at = [&](Index i) { return grid.nodes[i]; };
      if (!(crest < sloshing_.roof)) {
        return fmt::format("the liquid reaches the roof at x = {:.3g} m", at(top));
      }
      if (!(lowest > driest_depth * depth)) {
        return fmt::format("the bottom falls dry: {:.3g} m of liquid are left", lowest);
      }
      if (!(slope < steepest_slope)) {
        return fmt::format("the surface is about to break: its slope is {:.3g} at x = {:.3g} m",
                           slope, at(steepest));
      }
      if (!(unresolved_ < std::min(most_unresolved + start_waves_ / wave_, most_unresolved_ever))) {
        return fmt::format(
            "{} nodes along x do not resolve the surface: its last coefficients are {:.1e} of it",
            sloshing_.nodes_x, unresolved_);
      }
      if (!(std::abs(volume_error_) < worst_volume * depth)) {
        return fmt::format("the volume is not conserved: the mean level moved by {:.1e} m",
                           volume_error_);
      }
      if (!(std::abs(energy_error_) < worst_energy)) {
        return fmt::format(
            "the energy does not balance the walls' work: the relative error is {:.1e}",
            energy_error_);
      }
      return "";
    }();
    if (record_.left_range_because.empty()) record_.valid_until = t_;
  }

  void observe() {
    const auto state = unpack(y_);
    const auto pressure = flow_.pressure(state, t_);
    record_.times.push_back(t_);
    for (std::size_t i = 0; i < observation_.gauges.size(); ++i) {
      record_.elevation[i].push_back(
          flow_.x().interpolation(observation_.gauges[i]).dot(state.elevation));
    }
    record_.load.push_back(pressure.load);
    for (std::size_t i = 0; i < observation_.places.size(); ++i) {
      const auto [x, z] = observation_.places[i];
      const Eigen::RowVectorXd along = flow_.x().interpolation(x);
      const double s = (z + sloshing_.tank.fill_depth) / along.dot(pressure.column);
      const auto at_place = [&](const Eigen::MatrixXd& field) {
        return s < 1 ? (along * field).dot(flow_.s().interpolation(std::max(s, 0.0))) : 0;
      };
      record_.pressure[i].push_back(at_place(pressure.field));
      record_.velocity_x[i].push_back(at_place(pressure.velocity.x));
      record_.velocity_z[i].push_back(at_place(pressure.velocity.z));
    }
    record_.volume_error.push_back(volume_error_);
    record_.energy_error.push_back(energy_error_);
    record_.unresolved.push_back(unresolved_);
  }

  const NonlinearSloshing& sloshing_;
  const Observation& observation_;
  FreeSurfaceFlow flow_;
  Eigen::MatrixXd from_coefficients_;
  double period_;
  odeint::result_of::make_controlled<odeint::runge_kutta_fehlberg78<Packed>>::type stepper_ =
      odeint::make_controlled<odeint::runge_kutta_fehlberg78<Packed>>(step_tolerance, 0.0);

  double t_ = 0, step_ = first_step * period_;
  Packed y_, dydt_;
  FreeSurfaceFlow::Rates rates_;
  double first_energy_ = 0, first_volume_ = 0, start_waves_ = 0;
  double wave_ = lowest_wave * length(), unresolved_ = 0, volume_error_ = 0, energy_error_ = 0;
  NonlinearRecord record_;
};

}  // namespace

NonlinearRecord run_nonlinear_potential_flow(const NonlinearSloshing& sloshing,
                                             const Observation& observation) {
  check(sloshing, observation);
  return Run(sloshing, observation).run();
}

}  // namespace slosh::reference
