#include "sph/recording/soundness.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace slosh::sph {
namespace {

constexpr std::size_t packing_stride = 10;  // in samples

void keep_every_tenth(History& drift, std::size_t samples) {
  const std::size_t kept = (samples + packing_stride - 1) / packing_stride;
  drift.time.resize(kept);
  drift.value.resize(kept);
}

}  // namespace

void Soundness::record(Liquid& liquid, bool is_last, RunOutput& output) {
  const Particles& p = liquid.particles;
  const Setting& setting = liquid.setting();
  double density_error = 0, in_tension = 0;
  for (const double density : p.density) {
    density_error = std::max(density_error, std::abs(density / setting.rest_density - 1));
    if (liquid.terms().pressure(density) < 0) ++in_tension;
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

void Soundness::record_packing(Liquid& liquid, History& drift) {
  const double packing = liquid.median_kernel_sum();
  if (drift.time.empty()) start_packing_ = packing;
  drift.time.push_back(liquid.time);
  drift.value.push_back(packing / start_packing_ - 1);
}

}  // namespace slosh::sph
