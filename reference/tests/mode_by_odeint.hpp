// Integrates the equation of one mode numerically (Dormand-Prince), independently of all closed
// forms.
#pragma once

#include <array>
#include <boost/numeric/odeint.hpp>
#include <functional>
#include <vector>

#include "reference/tank_mode.hpp"

namespace slosh::reference {

// Returns eta_n and eta_n' at each of the ascending times; the integration starts at t = 0.
inline std::vector<std::array<double, 2>> mode_by_odeint(
    const TankMode& mode, const std::function<double(double)>& tank_acceleration,
    const std::vector<double>& times) {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 2>;
  State state{0, mode.initial_rate};
  std::vector<double> instants{0};
  instants.insert(instants.end(), times.begin(), times.end());
  std::vector<State> record;
  odeint::integrate_times(
      odeint::make_dense_output(1e-13, 1e-13, odeint::runge_kutta_dopri5<State>()),
      [&](const State& y, State& rate, double t) {
        rate = {y[1], -mode.natural_frequency * mode.natural_frequency * y[0] -
                          mode.coupling * tank_acceleration(t)};
      },
      state, instants.begin(), instants.end(), 1e-4,
      [&](const State& y, double) { record.push_back(y); });
  record.erase(record.begin());
  return record;
}

}  // namespace slosh::reference
