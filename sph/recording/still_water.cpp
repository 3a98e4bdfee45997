#include "sph/recording/still_water.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sph/walls/solid_particles.hpp"

namespace slosh::sph {
namespace {

double volume(const Particles& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += p.mass[i] / p.density[i];
  return sum;
}

// The distance of the nearest particle from a wall, in each window along the wall.
class NearestAlong {
 public:
  NearestAlong(double length, double window)
      : per_length_(1 / window),
        nearest_(static_cast<std::size_t>(std::max(1.0, std::floor(length / window))),
                 std::numeric_limits<double>::infinity()) {}
  void offer(double along, double distance) {
    if (!(along >= 0)) return;
    const auto window = static_cast<std::size_t>(along * per_length_);
    if (window < nearest_.size()) nearest_[window] = std::min(nearest_[window], distance);
  }
  // Gives no gap to the windows that overlap [from, to].
  void leave_out(double from, double to) {
    for (std::size_t window = 0; window < nearest_.size(); ++window) {
      const double begin = static_cast<double>(window) / per_length_;
      if (from < begin + 1 / per_length_ && to > begin) nearest_[window] = 0;
    }
  }
  double widest() const { return *std::max_element(nearest_.begin(), nearest_.end()); }

 private:
  double per_length_;
  std::vector<double> nearest_;
};

}  // namespace

StillWater::StillWater(const Scene& scene, const Particles& start,
                       std::function<double(double)> pressure_at)
    : scene_(scene), pressure_at_(std::move(pressure_at)), start_volume_(volume(start)) {}

double StillWater::pressure_error(const Particles& p) const {
  const double scale = scene_.rest_density * scene_.gravity;
  double sum2 = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double difference = pressure_at_(p.density[i]) - scale * (scene_.fill_depth - p.z[i]);
    sum2 += difference * difference;
  }
  return std::sqrt(sum2 / static_cast<double>(p.size())) / (scale * scene_.fill_depth);
}

double StillWater::wall_gap(const Particles& p) const {
  const double dp = scene_.particle_spacing, length = scene_.tank_length;
  NearestAlong bottom(length, 2 * dp), left(0.8 * scene_.fill_depth, 2 * dp), right = left;
  for (const Rectangle& r : obstacles_on_lattice(scene_, 0)) {
    if (r.bottom <= 0) bottom.leave_out(r.left, r.right);
    if (r.left <= 0) left.leave_out(r.bottom, r.top);
    if (r.right >= length) right.leave_out(r.bottom, r.top);
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.x[i];
    bottom.offer(x, p.z[i]);
    left.offer(p.z[i], x);
    right.offer(p.z[i], length - x);
  }
  return std::max({bottom.widest(), left.widest(), right.widest()}) / dp - 0.5;
}

void StillWater::record(const Particles& p, double time,
                        std::vector<RecordedSeries>& series) const {
  const double depth = scene_.fill_depth;
  const double potential =
      0.5 * scene_.rest_density * scene_.gravity * depth * depth * scene_.tank_length;
  const std::pair<const char*, double> values[]{
      {"hydrostatic_pressure_error", pressure_error(p)},
      {"kinetic_over_potential_energy", kinetic_energy(p) / potential},
      {"wall_gap", wall_gap(p)},
      {"volume_drift", volume(p) / start_volume_ - 1}};
  if (series.empty())
    for (const auto& [name, value] : values) series.push_back({name, "1", {}});
  for (std::size_t i = 0; i < series.size(); ++i) {
    series[i].history.time.push_back(time);
    series[i].history.value.push_back(values[i].second);
  }
}

}  // namespace slosh::sph
