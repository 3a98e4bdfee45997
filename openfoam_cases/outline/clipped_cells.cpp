#include "openfoam_cases/outline/clipped_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace slosh::openfoam {
namespace {

constexpr double snap_distance = 1e-9;  // in cells; far above round-off, far below any effect

double snapped(double value, double size, int cells) {
  const double at = value / size * cells, nearest = std::round(at);
  return std::abs(at - nearest) <= snap_distance ? size * (nearest / cells) : value;
}

Corner snapped(const UniformGrid& grid, Corner place) {
  return {snapped(place.x, grid.length, grid.columns), snapped(place.z, grid.height, grid.rows)};
}

class Points {
 public:
  int number(Corner place) {
    const auto [at, is_new] =
        numbers_.try_emplace({place.x, place.z}, static_cast<int>(places_.size()));
    if (is_new) places_.push_back(place);
    return at->second;
  }
  const std::vector<Corner>& places() const { return places_; }

 private:
  std::map<std::pair<double, double>, int> numbers_;
  std::vector<Corner> places_;
};

// Returns the places after `from` where the edge to `to` crosses lines between cells, in order.
std::vector<Corner> crossings(const UniformGrid& grid, Corner from, Corner to) {
  std::vector<std::pair<double, Corner>> found;
  const auto cross = [&](double line, double begin, double end, bool is_x) {
    if (!(line > std::min(begin, end) && line < std::max(begin, end))) return;
    const double share = (line - begin) / (end - begin);
    Corner place =
        snapped(grid, {from.x + share * (to.x - from.x), from.z + share * (to.z - from.z)});
    (is_x ? place.x : place.z) = line;
    found.push_back({share, place});
  };
  for (int i = 0; i <= grid.columns; ++i) cross(grid.face_x(i), from.x, to.x, true);
  for (int k = 0; k <= grid.rows; ++k) cross(grid.face_z(k), from.z, to.z, false);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Corner> places;
  for (const auto& [share, place] : found) places.push_back(place);
  return places;
}

struct DividedOutline {
  Polygon places;
  std::vector<OutlineStep> steps;
};

DividedOutline divided(const Polygon& outline, const UniformGrid& grid, Points& points) {
  DividedOutline result;
  double along = 0;
  for (std::size_t edge = 0; edge < outline.size(); ++edge) {
    const Corner begin = snapped(grid, outline[edge]),
                 end = snapped(grid, outline[(edge + 1) % outline.size()]);
    std::vector<Corner> places = crossings(grid, begin, end);
    places.push_back(end);
    Corner last = begin;
    for (const Corner& place : places) {
      if (place.x == last.x && place.z == last.z) continue;
      const double length = std::hypot(place.x - last.x, place.z - last.z);
      result.steps.push_back(
          {points.number(last), points.number(place), static_cast<int>(edge), along, length});
      result.places.push_back(last);
      along += length;
      last = place;
    }
  }
  return result;
}

// Returns the part on one side of the line where the coordinate is `line`. Only edges parallel to
// the axes cross the line.
template <double Corner::*coordinate>
Polygon beside(const Polygon& polygon, double line, double sign) {
  const auto is_in = [&](const Corner& place) { return sign * (place.*coordinate - line) >= 0; };
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (is_in(a)) part.push_back(a);
    if (is_in(a) == is_in(b) || (is_in(a) ? a : b).*coordinate == line) continue;
    assert(a.x == b.x || a.z == b.z);
    Corner crossing = a;
    crossing.*coordinate = line;
    part.push_back(crossing);
  }
  return part;
}

template <double Corner::*coordinate>
Polygon between(const Polygon& polygon, double from, double to) {
  return beside<coordinate>(beside<coordinate>(polygon, from, 1), to, -1);
}

// The places on each line between cells, in order.
struct LinePlaces {
  std::map<double, std::set<double>> upright, level;  // by x and by z

  void add(const Polygon& polygon, const UniformGrid& grid, Cell cell) {
    for (const Corner& place : polygon) {
      if (place.x == grid.face_x(cell.column) || place.x == grid.face_x(cell.column + 1))
        upright[place.x].insert(place.z);
      if (place.z == grid.face_z(cell.row) || place.z == grid.face_z(cell.row + 1))
        level[place.z].insert(place.x);
    }
  }

  // Returns the places on the edge from a to b, without b.
  Polygon on_edge(Corner a, Corner b) const {
    Polygon places{a};
    const bool is_upright = a.x == b.x;
    const auto& lines = is_upright ? upright : level;
    const auto line = lines.find(is_upright ? a.x : a.z);
    if ((!is_upright && a.z != b.z) || line == lines.end()) return places;
    const double from = is_upright ? a.z : a.x, to = is_upright ? b.z : b.x;
    const auto first = line->second.upper_bound(std::min(from, to));
    const auto last = line->second.lower_bound(std::max(from, to));
    for (auto at = first; at != last && *at < std::max(from, to); ++at)
      places.push_back(is_upright ? Corner{a.x, *at} : Corner{*at, a.z});
    if (to < from) std::reverse(places.begin() + 1, places.end());
    return places;
  }
};

}  // namespace

void refuse_cell(Cell place) {
  throw std::invalid_argument(fmt::format(
      "OpenFOAM tank: outline: it divides the cell in column {}, row {} (counted from 0): expected "
      "cells that are smaller than the outline's narrowest neck and its thinnest wall",
      place.column, place.row));
}

std::vector<std::vector<int>> loops_of(const std::vector<std::pair<int, int>>& edges, Cell place) {
  std::map<std::pair<int, int>, int> net;
  for (const auto& [from, to] : edges) net[std::minmax(from, to)] += from < to ? 1 : -1;
  std::map<int, int> next;
  for (const auto& [ends, count] : net) {
    if (count == 0) continue;
    const auto [from, to] = count > 0 ? ends : std::pair{ends.second, ends.first};
    if (std::abs(count) > 1 || !next.emplace(from, to).second) refuse_cell(place);
  }
  std::vector<std::vector<int>> loops;
  while (!next.empty()) {
    loops.emplace_back();
    for (auto at = next.begin(); at != next.end();) {
      loops.back().push_back(at->first);
      const int to = at->second;
      next.erase(at);
      at = next.find(to);
    }
  }
  return loops;
}

ClippedCells clip_cells(const Polygon& outline, const UniformGrid& grid) {
  Points points;
  ClippedCells result;
  DividedOutline line = divided(outline, grid, points);
  std::vector<std::pair<Cell, Polygon>> parts;
  LinePlaces lines;
  for (int column = 0; column < grid.columns; ++column) {
    const Polygon strip =
        between<&Corner::x>(line.places, grid.face_x(column), grid.face_x(column + 1));
    for (int row = 0; row < grid.rows; ++row) {
      Polygon part = between<&Corner::z>(strip, grid.face_z(row), grid.face_z(row + 1));
      if (part.size() < 3) continue;
      lines.add(part, grid, {column, row});
      parts.push_back({{column, row}, std::move(part)});
    }
  }
  for (const auto& [cell, part] : parts) {
    std::vector<std::pair<int, int>> edges;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Corner end = part[(i + 1) % part.size()];
      if (part[i].x == end.x && part[i].z == end.z) continue;
      Polygon places = lines.on_edge(part[i], end);
      places.push_back(end);
      for (std::size_t k = 0; k + 1 < places.size(); ++k)
        edges.push_back({points.number(places[k]), points.number(places[k + 1])});
    }
    for (std::vector<int>& loop : loops_of(edges, cell))
      result.pieces.push_back({cell, std::move(loop)});
  }
  result.outline = std::move(line.steps);
  result.points = points.places();
  return result;
}

}  // namespace slosh::openfoam
