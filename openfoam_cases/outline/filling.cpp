#include "openfoam_cases/outline/filling.hpp"

#include <algorithm>
#include <cmath>

namespace slosh::openfoam {
namespace {

// Corners closer together than this part of the room's height count as one, which changes no level
// by more than this.
constexpr double height_tolerance = 1e-10;

}  // namespace

// With the areas m at half the height and a at the whole height h of a part, its width is
// w0 = (4 m - a) / h at its lower end.
Filling::Filling(const std::vector<Polygon>& room) {
  std::vector<double> heights;
  for (const Polygon& polygon : room)
    for (const Corner& corner : polygon) heights.push_back(corner.z);
  if (heights.empty()) return;
  std::sort(heights.begin(), heights.end());
  const double tolerance = height_tolerance * (heights.back() - heights.front());
  for (const double height : heights)
    if (heights_.empty() || height > heights_.back() + tolerance) heights_.push_back(height);
  const auto below = [&](double z) {
    double sum = 0;
    for (const Polygon& polygon : room) sum += area_below(polygon, z);
    return sum;
  };
  for (const double height : heights_) areas_.push_back(below(height));
  for (std::size_t i = 0; i + 1 < heights_.size(); ++i) {
    const double half = below((heights_[i] + heights_[i + 1]) / 2) - areas_[i];
    const double whole = areas_[i + 1] - areas_[i];
    widths_.push_back(std::max(0.0, (4 * half - whole) / (heights_[i + 1] - heights_[i])));
  }
}

// The smaller root of area = w0 s + (w1 - w0) / (2 h) s^2, in the form without cancellation.
double Filling::level(double area) const {
  if (!(area > 0)) return heights_.front();
  if (area >= areas_.back()) return heights_.back();
  const auto above = std::upper_bound(areas_.begin(), areas_.end(), area);
  const std::size_t i = above - areas_.begin() - 1;
  const double rest = area - areas_[i], height = heights_[i + 1] - heights_[i];
  const double upper_width = 2 * (areas_[i + 1] - areas_[i]) / height - widths_[i];
  const double slope = (upper_width - widths_[i]) / height;
  const double root = std::sqrt(std::max(0.0, widths_[i] * widths_[i] + 2 * slope * rest));
  return heights_[i] + std::min(height, 2 * rest / (widths_[i] + root));
}

}  // namespace slosh::openfoam
