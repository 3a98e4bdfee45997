// How the modes of a tank respond to its surge, a sine in closed form or any motion by Duhamel's
// integral (mode_response.hpp).
#pragma once

#include <functional>
#include <string_view>
#include <variant>
#include <vector>

#include "reference/mode_response.hpp"
#include "reference/tank.hpp"

namespace slosh::reference {

// Any motion X(t), given by X'(0) and X''(t). Duhamel's integral is exact for an X'' that is linear
// between the sample times, which are the knots, or 0, step, 2 step, ...
struct AnySurge {
  double initial_velocity;                     // [m/s]
  std::function<double(double)> acceleration;  // [m/s2] at a time [s]
  double duration;                             // [s]
  double step;                                 // [s]
  std::vector<double> knots = {};              // [s] rising from 0 to the duration
};

// The states of given modes under a surge. The constructors throw std::invalid_argument, which
// names `where`, for an impossible motion.
class SurgeResponse {
 public:
  SurgeResponse(std::string_view where, std::vector<TankMode> modes, const SineSurge& motion);
  SurgeResponse(std::string_view where, std::vector<TankMode> modes, const AnySurge& motion);

  // X'(0) [m/s].
  static double initial_velocity(const SineSurge& motion);
  static double initial_velocity(const AnySurge& motion);

  const std::vector<TankMode>& modes() const { return modes_; }
  // Returns t, or throws std::invalid_argument where the motion is not defined and for NaN.
  double checked_time(double t) const;
  double tank_acceleration(double t) const;  // X'' [m/s2]

  // Calls visit(n, the n-th mode's state at t) for every mode.
  template <class Visit>
  void for_each_state(double t, Visit visit) const {
    if (const auto* sine = std::get_if<SineSurge>(&motion_)) {
      const SineInstant now(*sine, t);
      for (std::size_t n = 0; n < modes_.size(); ++n) visit(n, forced_mode(modes_[n], now));
    } else {
      for (std::size_t n = 0; n < modes_.size(); ++n)
        visit(n, std::get<DuhamelModes>(motion_).state(n, t));
    }
  }

 private:
  std::string_view where_;
  std::vector<TankMode> modes_;
  std::variant<SineSurge, DuhamelModes> motion_;
};

}  // namespace slosh::reference
