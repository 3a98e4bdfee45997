// The deviation from rest of a liquid that should be at rest.
#pragma once

#include <functional>
#include <vector>

#include "sph/neighbours/particles.hpp"
#include "sph/run_output.hpp"
#include "sph/scene.hpp"

namespace slosh::sph {

class StillWater {
 public:
  // `pressure_at` is the equation of state, pressure [Pa] at a density [kg/m3]; `start` is the
  // liquid whose volume is the reference of volume_drift.
  StillWater(const Scene& scene, const Particles& start, std::function<double(double)> pressure_at);

  // Appends the values at `time` to these dimensionless series:
  //   hydrostatic_pressure_error     rms over the particles of p - rho_0 g (fill_depth - z), over
  //                                  rho_0 g fill_depth
  //   kinetic_over_potential_energy  kinetic energy over rho_0 g fill_depth^2 / 2 per tank length
  //   wall_gap                       the widest gap between the bottom or a side wall and the
  //                                  particles next to it, less the lattice's half spacing, in
  //                                  spacings; taken in windows two spacings wide along the wall
  //                                  where there is no obstacle, on the sides up to 0.8 of the
  //                                  depth
  //   volume_drift                   the particles' volume over that at the start, minus 1
  void record(const Particles& particles, double time, std::vector<RecordedSeries>& series) const;

  // Calls visit(name, value) for every number that is kept from sample to sample.
  template <class Visit>
  void for_each_number(const Visit& visit) {
    visit("start_volume", start_volume_);
  }

 private:
  double pressure_error(const Particles& particles) const;
  double wall_gap(const Particles& particles) const;

  const Scene& scene_;
  std::function<double(double)> pressure_at_;
  double start_volume_;
};

}  // namespace slosh::sph
