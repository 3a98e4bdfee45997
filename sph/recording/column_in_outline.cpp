#include "sph/recording/column_in_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sph/recording/free_surface.hpp"

namespace slosh::sph {
namespace {

constexpr double steps_per_spacing = 8;

}  // namespace

ColumnInOutline::ColumnInOutline(const TankOutline& outline, double fill_depth, double x,
                                 double spacing)
    : x_(x),
      fill_depth_(fill_depth),
      scale_(1 / (window_width * spacing)),
      still_(outline.at(fill_depth)) {
  const double steps = std::ceil(steps_per_spacing * outline.top() / spacing);
  step_ = outline.top() / steps;
  depths_.push_back(0);
  for (int k = 0; k < steps; ++k) {
    const auto [left, right] = outline.mean_between(k * step_, (k + 1) * step_);
    double share = 0;
    for (const auto& [from, to] :
         {std::array{left, right}, std::array{2 * still_.left - right, 2 * still_.left - left},
          std::array{2 * still_.right - right, 2 * still_.right - left}})
      share += window_integral((to - x) * scale_) - window_integral((from - x) * scale_);
    depths_.push_back(depths_.back() + share * step_);
  }
}

double ColumnInOutline::weight(double x) const {
  return scale_ * (window((x_ - x) * scale_) + window((x_ + x - 2 * still_.left) * scale_) +
                   window((x_ + x - 2 * still_.right) * scale_));
}

double ColumnInOutline::elevation(const Particles& p) const {
  double depth = 0;
  for (std::size_t i = 0; i < p.size(); ++i) depth += p.mass[i] / p.density[i] * weight(p.x[i]);
  const auto last = static_cast<std::ptrdiff_t>(depths_.size()) - 2;
  auto k = std::min(last, static_cast<std::ptrdiff_t>(fill_depth_ / step_));
  while (k < last && depths_[k + 1] < depth) ++k;
  while (k > 0 && depths_[k] > depth) --k;
  const double rise = depths_[k + 1] - depths_[k];
  const double share = rise > 0 ? std::clamp((depth - depths_[k]) / rise, 0.0, 1.0) : 0.0;
  return (static_cast<double>(k) + share) * step_ - fill_depth_;
}

}  // namespace slosh::sph
