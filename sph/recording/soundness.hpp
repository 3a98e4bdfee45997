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

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "sph/liquid.hpp"
#include "sph/neighbours/neighbour_sources.hpp"
#include "sph/run_output.hpp"
#include "sph/setting.hpp"

namespace slosh::sph {

class Soundness {
 public:
  // Appends the values at the liquid's time to the output's series. The packing costs a pair sum,
  // of which a step has two, and is measured at every tenth sample, the first and the last
  // included.
  template <class Scheme>
  void record(Liquid<Scheme>& liquid, bool is_last, RunOutput& output) {
    const Particles& p = liquid.particles;
    const Setting& setting = liquid.scheme().setting;
    double density_error = 0, in_tension = 0;
    for (const double density : p.density) {
      density_error = std::max(density_error, std::abs(density / setting.rest_density - 1));
      if (liquid.scheme().state.pressure(density) < 0) ++in_tension;
    }
    const double speed = NeighbourSources::fastest(p, liquid.tank_at(liquid.time));
    const std::pair<const char*, double> values[]{
        {"mach_number", speed / setting.speed_of_sound},
        {"density_error", density_error},
        {"tension_share", in_tension / static_cast<double>(p.size())}};
    std::vector<RecordedSeries>& series = output.soundness;
    if (series.empty())
      for (const auto& [name, value] : values) series.push_back({name, "1", {}});
    const std::size_t samples = series[0].history.time.size();
    // A run that goes on from the end of a shorter one leaves that one's last packing out.
    keep_every_tenth(output.packing_drift, samples);
    const bool measures_packing = is_last || samples % packing_stride == 0;
    for (std::size_t i = 0; i < series.size(); ++i) {
      series[i].history.time.push_back(liquid.time);
      series[i].history.value.push_back(values[i].second);
    }
    if (measures_packing) record_packing(liquid, output.packing_drift);
  }

  // Calls visit(name, value) for every number that is kept from sample to sample.
  template <class Visit>
  void for_each_number(const Visit& visit) {
    visit("start_packing", start_packing_);
  }

 private:
  static constexpr std::size_t packing_stride = 10;  // in samples

  template <class Scheme>
  void record_packing(Liquid<Scheme>& liquid, History& drift) {
    const double packing = liquid.median_kernel_sum();
    if (drift.time.empty()) start_packing_ = packing;
    drift.time.push_back(liquid.time);
    drift.value.push_back(packing / start_packing_ - 1);
  }

  static void keep_every_tenth(History& drift, std::size_t samples) {
    const std::size_t kept = (samples + packing_stride - 1) / packing_stride;
    drift.time.resize(kept);
    drift.value.resize(kept);
  }

  double start_packing_ = 0;
};

}  // namespace slosh::sph
