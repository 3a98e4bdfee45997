// The sources that thin obstacles leave to the points of a cluster (walls/line_of_sight.hpp), for
// ClusterLists. The points of a cluster share their list, so they are points from which the same
// places are hidden.
#pragma once

#include <cstddef>
#include <vector>

#include "sph/neighbours/particles.hpp"
#include "sph/walls/line_of_sight.hpp"

namespace slosh::sph {

// Every source within reach counts.
struct AllSources {
  static constexpr bool selects = false;
};

class SeenSources {
 public:
  static constexpr bool selects = true;

  // `solid_faces` are the faces that the solids' sources stand behind, from the source number
  // `first_solid` on. `own_faces` are those that the points themselves stand behind, where they are
  // solids whose sums are evaluated at their own place; it is empty for points in the liquid.
  SeenSources(const LineOfSight& sight, const Array<float>& x, const Array<float>& z, double reach,
              const std::vector<int>& solid_faces, std::size_t first_solid,
              const std::vector<int>& own_faces)
      : sight_(sight),
        x_(x),
        z_(z),
        reach_(reach),
        solid_faces_(solid_faces),
        first_solid_(first_solid),
        own_faces_(own_faces) {}

  int group(std::size_t point) const {
    const int group = sight_.group({x_[point], z_[point]}, reach_);
    return own_face(point) == no_face ? group : LineOfSight::its_own_group;
  }
  // Returns where a cluster of points before `end` that begins with `first` must end.
  std::size_t end_of_cluster(std::size_t first, std::size_t end) const {
    const int of_first = group(first);
    std::size_t k = first + 1;
    while (k < end && of_first != LineOfSight::its_own_group && group(k) == of_first) ++k;
    return k;
  }
  // Whether a source at `place` counts for the cluster with this first point, of this group.
  bool keeps(std::size_t point, int group, std::size_t source, Vector2 place) const {
    const int face = source < first_solid_ ? no_face : solid_faces_[source - first_solid_];
    if (group == LineOfSight::no_group) return face == no_face;
    const Vector2 at{x_[point], z_[point]};
    const int own = own_face(point);
    return own == no_face ? sight_.hiding_face(at, place) == face
                          : sight_.hiding_face(place, at) == own;
  }

 private:
  int own_face(std::size_t point) const { return own_faces_.empty() ? no_face : own_faces_[point]; }

  const LineOfSight& sight_;
  const Array<float>&x_, &z_;
  double reach_;
  const std::vector<int>& solid_faces_;
  std::size_t first_solid_;
  const std::vector<int>& own_faces_;
};

}  // namespace slosh::sph
