// Whether the liquid stays weakly compressible and keeps together, in dimensionless series:
//   mach_number    the largest speed of a particle relative to the tank, over the speed of sound
//   density_error  the largest |rho / rho_0 - 1| of a particle, hydrostatic compression included
//   tension_share  the share of the particles whose pressure is below 0
//   packing_drift  the median over the particles of the kernel sum sum_b V_b W_ab over liquid,
//                  images and solids, V = m / rho, over that at the start of the run, minus 1
// The packing drift measures the liquid's volume by the places of the particles. A liquid whose
// particles draw closer than their volumes allow has a kernel sum that grows. The surface gauges
// and the volume drift do not see this, because they add up the volumes m / rho.
#pragma once

#include "sph/liquid.hpp"
#include "sph/run_output.hpp"

namespace slosh::sph {

class Soundness {
 public:
  // Appends the values at the liquid's time to the output's series. The packing costs a pair sum,
  // of which a step has two, and is measured at every tenth sample, the first and the last
  // included.
  void record(Liquid& liquid, bool is_last, RunOutput& output);

  // Calls visit(name, value) for every number that is kept from sample to sample.
  template <class Visit>
  void for_each_number(const Visit& visit) {
    visit("start_packing", start_packing_);
  }

 private:
  void record_packing(Liquid& liquid, History& drift);

  double start_packing_ = 0;
};

}  // namespace slosh::sph
