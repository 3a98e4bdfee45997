#include "openfoam_cases/outline/straight_points.hpp"

#include <algorithm>
#include <utility>

namespace slosh::openfoam {
namespace {

using Loop = std::vector<int>;

// Returns the corners before and after this one.
std::pair<int, int> neighbours(const Loop& loop, int corner) {
  const std::size_t at = std::find(loop.begin(), loop.end(), corner) - loop.begin();
  return {loop[(at + loop.size() - 1) % loop.size()], loop[(at + 1) % loop.size()]};
}

// Lines between cells are parallel to the axes, with coordinates that agree bit for bit.
bool are_in_line(const Corner& a, const Corner& b, const Corner& c) {
  return (a.x == b.x && b.x == c.x) || (a.z == b.z && b.z == c.z);
}

// Returns by point whether it is inside an edge of the outline.
std::vector<bool> inside_edges(const std::vector<OutlineStep>& outline, std::size_t points) {
  std::vector<bool> inside(points, false);
  for (std::size_t i = 1; i < outline.size(); ++i)
    if (outline[i].edge == outline[i - 1].edge) inside[outline[i].begin] = true;
  return inside;
}

void join_steps(const std::vector<bool>& dropped, std::vector<OutlineStep>& outline) {
  std::vector<OutlineStep> joined;
  for (const OutlineStep& step : outline) {
    if (!dropped[step.begin]) {
      joined.push_back(step);
      continue;
    }
    joined.back().end = step.end;
    joined.back().length += step.length;
  }
  outline = std::move(joined);
}

void number_anew(std::vector<Loop>& cells, std::vector<OutlineStep>& outline,
                 std::vector<Corner>& points) {
  std::vector<int> numbers(points.size(), -1);
  std::vector<Corner> used;
  const auto renumber = [&](int& point) {
    if (numbers[point] < 0) {
      numbers[point] = static_cast<int>(used.size());
      used.push_back(points[point]);
    }
    point = numbers[point];
  };
  for (Loop& loop : cells) std::for_each(loop.begin(), loop.end(), renumber);
  for (OutlineStep& step : outline) {
    renumber(step.begin);
    renumber(step.end);
  }
  points = std::move(used);
}

}  // namespace

void drop_straight_points(std::vector<Loop>& cells, std::vector<OutlineStep>& outline,
                          std::vector<Corner>& points) {
  std::vector<std::vector<Loop*>> loops_at(points.size());
  for (Loop& loop : cells)
    for (const int corner : loop) loops_at[corner].push_back(&loop);
  const std::vector<bool> on_edge = inside_edges(outline, points.size());
  std::vector<bool> on_outline(points.size(), false), dropped(points.size(), false);
  for (const OutlineStep& step : outline) on_outline[step.begin] = true;
  for (int point = 0; point < static_cast<int>(points.size()); ++point) {
    const std::vector<Loop*>& loops = loops_at[point];
    if (loops.empty()) continue;
    const auto [before, after] = neighbours(*loops[0], point);
    const bool is_on_wall = loops.size() == 1 && on_edge[point];
    const bool is_between_two = loops.size() == 2 && !on_outline[point] &&
                                neighbours(*loops[1], point) == std::pair(after, before) &&
                                are_in_line(points[before], points[point], points[after]);
    if (!is_on_wall && !is_between_two) continue;
    dropped[point] = true;
    for (Loop* loop : loops) loop->erase(std::find(loop->begin(), loop->end(), point));
  }
  join_steps(dropped, outline);
  number_anew(cells, outline, points);
}

}  // namespace slosh::openfoam
