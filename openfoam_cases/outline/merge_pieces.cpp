#include "openfoam_cases/outline/merge_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace slosh::openfoam {
namespace {

// Groups that are joined one by one.
class Groups {
 public:
  explicit Groups(const ClippedCells& clipped) : clipped_(clipped) {
    for (std::size_t i = 0; i < clipped.pieces.size(); ++i) {
      const std::vector<int>& corners = clipped.pieces[i].corners;
      piece_areas_.push_back(area_of(places_of(corners, clipped.points)));
      members_.push_back({static_cast<int>(i)});
      group_of_.push_back(static_cast<int>(i));
      for (std::size_t k = 0; k < corners.size(); ++k)
        piece_beside_[{corners[k], corners[(k + 1) % corners.size()]}] = static_cast<int>(i);
    }
    areas_ = piece_areas_;
  }

  double area(int group) const { return areas_[group]; }

  // Returns the group that shares the longest face; -1 where none shares one.
  int widest_neighbour(int group) const {
    std::map<int, double> shared;
    for (const int member : members_[group]) {
      const std::vector<int>& corners = clipped_.pieces[member].corners;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const int begin = corners[k], end = corners[(k + 1) % corners.size()];
        const auto beside = piece_beside_.find({end, begin});
        if (beside == piece_beside_.end() || group_of_[beside->second] == group) continue;
        const Corner a = clipped_.points[begin], b = clipped_.points[end];
        shared[group_of_[beside->second]] += std::hypot(b.x - a.x, b.z - a.z);
      }
    }
    const auto widest =
        std::max_element(shared.begin(), shared.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return widest == shared.end() ? -1 : widest->first;
  }

  void join(int group, int other) {
    for (const int member : members_[group]) {
      group_of_[member] = other;
      members_[other].push_back(member);
    }
    members_[group].clear();
    areas_[other] += areas_[group];
  }

  std::vector<std::vector<int>> all() const {
    std::vector<std::vector<int>> groups;
    for (std::vector<int> group : members_) {
      if (group.empty()) continue;
      std::stable_sort(group.begin(), group.end(),
                       [&](int a, int b) { return piece_areas_[a] > piece_areas_[b]; });
      groups.push_back(std::move(group));
    }
    return groups;
  }

 private:
  const ClippedCells& clipped_;
  std::map<std::pair<int, int>, int> piece_beside_;  // by its edge
  std::vector<double> piece_areas_, areas_;
  std::vector<std::vector<int>> members_;
  std::vector<int> group_of_;  // by piece
};

}  // namespace

std::vector<std::vector<int>> merge_pieces(const ClippedCells& clipped, double least_area) {
  Groups groups(clipped);
  std::set<std::pair<double, int>> small;
  for (int i = 0; i < static_cast<int>(clipped.pieces.size()); ++i)
    if (groups.area(i) < least_area) small.insert({groups.area(i), i});
  while (!small.empty()) {
    const int group = small.begin()->second;
    small.erase(small.begin());
    const int other = groups.widest_neighbour(group);
    if (other < 0) continue;
    small.erase({groups.area(other), other});
    groups.join(group, other);
    if (groups.area(other) < least_area) small.insert({groups.area(other), other});
  }
  return groups.all();
}

Polygon places_of(const std::vector<int>& corners, const std::vector<Corner>& points) {
  Polygon places;
  places.reserve(corners.size());
  for (const int corner : corners) places.push_back(points[corner]);
  return places;
}

}  // namespace slosh::openfoam
