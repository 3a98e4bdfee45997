#include "sph/guards/energy_bound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sph/guards/stability_guard.hpp"

namespace slosh::sph {

EnergyBound::EnergyBound(const Scene& scene, const Particles& liquid)
    : mass_(std::accumulate(liquid.mass.begin(), liquid.mass.end(), 0.0)),
      slack_(0.005 * scene.rest_density * scene.gravity * scene.fill_depth * scene.fill_depth *
             scene.tank_length) {}

void EnergyBound::check(double time, double gained, double wall_power, double tank_speed,
                        const Particles& p) {
  const double power = std::abs(wall_power);
  work_ += 0.5 * (time - last_time_) * (last_power_ + power);
  last_time_ = time;
  last_power_ = power;
  tank_speed_ = std::max(tank_speed_, tank_speed);
  const double most = 2 * work_ + 2 * mass_ * tank_speed_ * tank_speed_ + slack_;
  if (gained <= most) return;
  std::size_t fastest = 0;
  const auto speed = [&](std::size_t i) { return std::hypot(p.velocity_x[i], p.velocity_z[i]); };
  for (std::size_t i = 1; i < p.size(); ++i)
    if (!(speed(i) <= speed(fastest))) fastest = i;
  const std::string cause = fmt::format(
      "the fastest of a liquid that has gained {:.4g} J/m, of which the walls can have given "
      "{:.4g} J/m at most (is the time step too long?),",
      gained, most);
  throw_bad_particle(p, fastest, time, cause.c_str());
}

}  // namespace slosh::sph
