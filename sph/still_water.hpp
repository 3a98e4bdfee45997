// How far a liquid that should be at rest is from it.
#pragma once

#include <functional>
#include <vector>

#include "sph/neighbours/particles.hpp"
#include "sph/simulation.hpp"

namespace slosh::sph {

class StillWater {
 public:
  // `pressure_at`: the equation of state, pressure [Pa] at a density [kg/m3]. `start`: the liquid
  // whose volume is kept.
  StillWater(const Scene& scene, const Particles& start, std::function<double(double)> pressure_at);

  // Enters, at `time`, into series all without unit:
  //   hydrostatic_pressure_error     rms over the particles of p - rho_0 g (fill_depth - z), over
  //                                  rho_0 g fill_depth
  //   kinetic_over_potential_energy  kinetic energy over rho_0 g fill_depth^2 / 2 per tank length
  //   wall_gap                       the widest gap between the bottom or a side wall and the
  //                                  particles next to it beyond the lattice's half spacing, in
  //                                  spacings; from windows two spacings wide along the wall where
  //                                  no obstacle stands, on the sides up to 0.8 of the depth
  //   volume_drift                   the particles' volume over that at the start, less 1
  void record(const Particles& particles, double time, std::vector<RecordedSeries>& series) const;

  // What is kept from sample to sample: visit(name, value).
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
