// The outline of a tank that is not rectangular: a closed polygon, fixed in the tank, that each
// horizontal line cuts in one stretch. Its corners run counter-clockwise, in x from the left wall
// and z from the bottom of the rectangle around it.
#pragma once

#include <optional>
#include <vector>

#include "sph/scene.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

// The side from `from` to `to`, with the liquid to its left.
struct OutlineSide {
  Vector2 from, to;
  double length;   // [m]
  Vector2 along;   // unit vector from `from` to `to`
  Vector2 normal;  // unit vector into the tank

  // Returns how far a place lies along the side from its beginning [m].
  double position_of(Vector2 place) const;
  // Returns how far a place lies on the tank's side of the side's line [m].
  double distance_of(Vector2 place) const;
};

// A point of the outline and the unit vector from there into the tank. At a corner the vector
// points to the place that was asked about, or away from it where that is outside.
struct OutlinePoint {
  Vector2 at, inward;
  std::size_t side;
};

class TankOutline {
 public:
  // Throws std::invalid_argument for fewer than three corners, for corners that do not run
  // counter-clockwise and for an outline that a horizontal line cuts in two stretches.
  explicit TankOutline(const std::vector<Corner>& corners);

  // The stretch that the outline cuts from a horizontal line [m].
  struct Extent {
    double left, right;
    double width() const { return right - left; }
  };
  Extent at(double z) const;
  // Returns the mean of the extents between two heights, whose width times their distance is the
  // area between them.
  Extent mean_between(double from, double to) const;

  bool contains(double x, double z) const;
  OutlinePoint nearest(double x, double z) const;
  const std::vector<OutlineSide>& sides() const { return sides_; }
  double bottom() const { return left_.front().z; }  // [m]
  double top() const { return left_.back().z; }      // [m]

 private:
  using Chain = std::vector<Corner>;  // with rising z

  // Extents in a band of heights that are certainly within the tank, for a quick answer.
  struct Band {
    double left, right;
  };

  std::vector<OutlineSide> sides_;
  Chain left_, right_;
  std::vector<Band> bands_;
};

// Returns the scene's outline; none for a rectangle. Throws std::invalid_argument for an outline
// that does not touch the tank's length and height on all four sides, and for what an outline
// excludes: obstacles, a dam and an initial wave.
std::optional<TankOutline> outline_of(const Scene& scene);

}  // namespace slosh::sph
