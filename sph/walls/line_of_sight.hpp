// What obstacles hide that are thinner than the kernel's support. The liquid on the two sides of
// such an obstacle, and the ghost particles behind its faces, stand within each other's support.
// Hence a place `to` does not count for a particle at `from`
//   before a long face (within its span)   where it is beyond that face, within the same span
//   beyond an end of the obstacle          where it is in the obstacle or, for a particle within
//                                          the end's span, beyond the opposite end
// Instead a ghost particle at the same place counts, that of the face through which it is hidden.
// Each place in the particle's support thus counts once. Between particles of liquid the rule is
// symmetric, so that momentum is conserved.
//
// The rule depends on the particles' places by the bands between the lines of the faces alone. The
// straight segment between two particles would be a sharper rule (the visibility criterion of
// Belytschko, Lu & Gu 1994, Int. J. Numer. Methods Eng. 37:229, section 4). But around an edge many
// pairs of a lattice lie just on its border, each crossing changes the ghosts' work on the liquid,
// and still water was measured to gain a thousandth of its potential energy in 5 s.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "sph/scene.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

// The sides of a rectangle. Face 4 n + side is that of rectangle n of a line of sight.
enum Side { left_side, right_side, bottom_side, top_side };
inline constexpr int no_face = -1;

class LineOfSight {
 public:
  LineOfSight() = default;  // nothing is hidden
  // The rectangles hide what is behind them [m, in the tank].
  explicit LineOfSight(std::vector<Rectangle> rectangles) : rectangles_(std::move(rectangles)) {}

  bool exists() const { return !rectangles_.empty(); }
  const std::vector<Rectangle>& rectangles() const { return rectangles_; }

  // Returns the face through which the segment first enters a rectangle, or no_face. A segment that
  // only grazes a corner, to a thousandth of the rectangle's thickness, enters none: on a lattice
  // many do, and round-off must not decide of them.
  int entered(Vector2 from, Vector2 to) const;
  bool sees(Vector2 from, Vector2 to) const { return !exists() || entered(from, to) == no_face; }

  // Returns the face that hides the place `to` from a particle at `from`, by the rule above, or
  // no_face. Of several rectangles it is that nearest to `from`.
  int hiding_face(Vector2 from, Vector2 to) const;

  // Returns the face through which something that moved along the segment would be inside a
  // rectangle or beyond its opposite face, or no_face. What has passed a corner is neither.
  int pierced(Vector2 from, Vector2 to) const;

  // Returns a number that two places share only if the same places within `reach` [m] are hidden
  // from both: no_group if there is no rectangle within reach. A place in its_own_group shares with
  // none.
  static constexpr int no_group = -1, its_own_group = -2;
  int group(Vector2 place, double reach) const;

 private:
  std::vector<Rectangle> rectangles_;
};

// Whether an obstacle, as obstacles_on_lattice has it, has liquid on two sides nearer to each other
// than `depth` [m].
bool is_thin(const Rectangle& obstacle, double depth, double tank_length, double tank_height);
// Returns those of the obstacles that are thin.
std::vector<Rectangle> thin_obstacles(const std::vector<Rectangle>& obstacles, double depth,
                                      double tank_length, double tank_height);

// Returns the place's mirror image in the line of a side.
Vector2 mirrored(Vector2 place, const Rectangle& rectangle, int side);

}  // namespace slosh::sph
