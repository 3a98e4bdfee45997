#include "sph/walls/tank_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace slosh::sph {
namespace {

constexpr std::size_t band_count = 256;

// Returns x of a chain at a height within it.
double x_at(const std::vector<Corner>& chain, double z) {
  const auto above = std::upper_bound(chain.begin() + 1, chain.end() - 1, z,
                                      [](double height, const Corner& c) { return height < c.z; });
  const Corner &low = *(above - 1), &high = *above;
  if (high.z == low.z) return high.x;
  return low.x + (high.x - low.x) * (z - low.z) / (high.z - low.z);
}

double mean_of(const std::vector<Corner>& chain, double from, double to) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
    const double low = std::max(from, chain[k].z), high = std::min(to, chain[k + 1].z);
    if (!(high > low)) continue;
    const double slope = (chain[k + 1].x - chain[k].x) / (chain[k + 1].z - chain[k].z);
    sum += (high - low) * (chain[k].x + slope * (0.5 * (low + high) - chain[k].z));
  }
  return sum / (to - from);
}

void require(bool holds, const char* expected) {
  if (!holds) throw std::invalid_argument(fmt::format("outline: expected {}", expected));
}

bool rises(const std::vector<Corner>& chain) {
  return std::is_sorted(chain.begin(), chain.end(),
                        [](const Corner& a, const Corner& b) { return a.z < b.z; });
}

std::vector<OutlineSide> sides_between(const std::vector<Corner>& corners) {
  std::vector<OutlineSide> sides;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Corner &a = corners[k], &b = corners[(k + 1) % corners.size()];
    const double length = std::hypot(b.x - a.x, b.z - a.z);
    require(length > 0, "corners that differ from their neighbours");
    const Vector2 along{(b.x - a.x) / length, (b.z - a.z) / length};
    sides.push_back({{a.x, a.z}, {b.x, b.z}, length, along, {-along.z, along.x}});
  }
  return sides;
}

}  // namespace

double OutlineSide::position_of(Vector2 place) const {
  return (place.x - from.x) * along.x + (place.z - from.z) * along.z;
}
double OutlineSide::distance_of(Vector2 place) const {
  return (place.x - from.x) * normal.x + (place.z - from.z) * normal.z;
}

TankOutline::TankOutline(const std::vector<Corner>& corners) {
  require(corners.size() >= 3, "at least three corners");
  for (const Corner& c : corners)
    require(std::isfinite(c.x) && std::isfinite(c.z), "finite corners");
  sides_ = sides_between(corners);
  const std::size_t n = corners.size();
  // The right chain leaves the lowest corner that is farthest right, the left one arrives at the
  // lowest that is farthest left; they meet likewise at the top.
  const auto least = [&](double height, double side) {
    return static_cast<std::size_t>(
        std::min_element(corners.begin(), corners.end(),
                         [=](const Corner& a, const Corner& b) {
                           const double za = height * a.z, zb = height * b.z;
                           return za < zb || (za == zb && side * a.x < side * b.x);
                         }) -
        corners.begin());
  };
  const std::size_t bottom_left = least(1, 1), bottom_right = least(1, -1), top_left = least(-1, 1),
                    top_right = least(-1, -1);
  for (std::size_t k = bottom_right;; k = (k + 1) % n) {
    right_.push_back(corners[k]);
    if (k == top_right || right_.size() > n) break;
  }
  for (std::size_t k = top_left;; k = (k + 1) % n) {
    left_.insert(left_.begin(), corners[k]);
    if (k == bottom_left || left_.size() > n) break;
  }
  require(rises(left_) && rises(right_) && left_.size() > 1 && right_.size() > 1,
          "corners that run counter-clockwise, and one stretch of the tank at every height");
  // Between the chains the outline may only run along its bottom and its top.
  for (std::size_t k = bottom_left; k != bottom_right; k = (k + 1) % n)
    require(corners[k].z == corners[bottom_left].z, "one stretch of the tank at every height");
  for (std::size_t k = top_right; k != top_left; k = (k + 1) % n)
    require(corners[k].z == corners[top_right].z, "one stretch of the tank at every height");
  const double height = top() - bottom();
  const auto widest_at = [&](double z) { require(at(z).width() > 0, "walls that do not cross"); };
  for (const Chain* chain : {&left_, &right_})
    for (const Corner& c : *chain)
      if (c.z > bottom() && c.z < top()) widest_at(c.z);
  widest_at(bottom() + 0.5 * height);
  for (std::size_t k = 0; k < band_count; ++k) {
    const double from = bottom() + height * static_cast<double>(k) / band_count,
                 to = bottom() + height * static_cast<double>(k + 1) / band_count;
    Band band{std::max(x_at(left_, from), x_at(left_, to)),
              std::min(x_at(right_, from), x_at(right_, to))};
    for (const Corner& c : left_)
      if (c.z >= from && c.z <= to) band.left = std::max(band.left, c.x);
    for (const Corner& c : right_)
      if (c.z >= from && c.z <= to) band.right = std::min(band.right, c.x);
    bands_.push_back(band);
  }
}

TankOutline::Extent TankOutline::at(double z) const {
  const double height = std::clamp(z, bottom(), top());
  return {x_at(left_, height), x_at(right_, height)};
}

TankOutline::Extent TankOutline::mean_between(double from, double to) const {
  return {mean_of(left_, from, to), mean_of(right_, from, to)};
}

bool TankOutline::contains(double x, double z) const {
  if (!(z > bottom() && z < top())) return false;
  const double share = (z - bottom()) / (top() - bottom());
  const Band& band = bands_[std::min(band_count - 1, static_cast<std::size_t>(share * band_count))];
  if (x > band.left && x < band.right) return true;
  const Extent here = at(z);
  return x > here.left && x < here.right;
}

OutlinePoint TankOutline::nearest(double x, double z) const {
  OutlinePoint found{};
  double least2 = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const OutlineSide& side = sides_[k];
    const double along = std::clamp(side.position_of({x, z}), 0.0, side.length);
    const Vector2 at{side.from.x + along * side.along.x, side.from.z + along * side.along.z};
    const double dx = x - at.x, dz = z - at.z, distance2 = dx * dx + dz * dz;
    if (!(distance2 < least2)) continue;
    least2 = distance2;
    found = {at, side.normal, k};
    const bool at_corner = along == 0 || along == side.length;
    if (const double distance = std::sqrt(distance2); at_corner && distance > 0) {
      const double inward = contains(x, z) ? 1 : -1;
      found.inward = {inward * dx / distance, inward * dz / distance};
    }
  }
  return found;
}

std::optional<TankOutline> outline_of(const Scene& scene) {
  if (scene.outline.empty()) return {};
  TankOutline outline(scene.outline);
  double left = scene.tank_length, right = 0;
  for (const Corner& c : scene.outline) {
    left = std::min(left, c.x);
    right = std::max(right, c.x);
  }
  const double rounding = 1e-9 * (scene.tank_length + scene.tank_height);
  for (const double off :
       {left, right - scene.tank_length, outline.bottom(), outline.top() - scene.tank_height})
    require(std::abs(off) <= rounding,
            "corners from 0 to the tank's length and from 0 to its height");
  require(scene.obstacles.empty() && !scene.column_width && !scene.initial_wave,
          "no obstacle, dam or initial wave together with it");
  return outline;
}

}  // namespace slosh::sph
