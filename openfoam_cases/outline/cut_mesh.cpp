#include "openfoam_cases/outline/cut_mesh.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "openfoam_cases/outline/cell_order.hpp"
#include "openfoam_cases/outline/merge_pieces.hpp"
#include "openfoam_cases/outline/straight_points.hpp"

namespace slosh::openfoam {
namespace {

// In whole cells. A cell of this size with whole faces still has three times the Courant number of
// a whole cell.
constexpr double least_area = 1.0 / 3;

using Edge = std::pair<int, int>;

std::vector<Edge> edges_of(const std::vector<int>& corners) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < corners.size(); ++i)
    edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return edges;
}

// The cells while they are made: their corners, and the place and the section of the largest piece.
struct Loops {
  std::vector<std::vector<int>> corners;
  std::vector<Cell> places;
  std::vector<Polygon> largest;
};

Loops merged_loops(const ClippedCells& clipped, double least) {
  Loops cells;
  for (const std::vector<int>& group : merge_pieces(clipped, least)) {
    std::vector<Edge> edges;
    for (const int member : group)
      for (const Edge& edge : edges_of(clipped.pieces[member].corners)) edges.push_back(edge);
    const Piece& largest = clipped.pieces[group.front()];
    std::vector<std::vector<int>> loops = loops_of(edges, largest.place);
    if (loops.size() != 1) refuse_cell(largest.place);
    cells.corners.push_back(std::move(loops.front()));
    cells.places.push_back(largest.place);
    cells.largest.push_back(places_of(largest.corners, clipped.points));
  }
  return cells;
}

CutCell cell_of(const Loops& loops, std::size_t i, const std::vector<Corner>& points,
                double whole_area) {
  CutCell cell{.place = loops.places[i],
               .corners = loops.corners[i],
               .polygon = places_of(loops.corners[i], points),
               .area = 0,
               .centroid = {},
               .inside = {},
               .is_whole = false,
               .process = 0};
  cell.area = area_of(cell.polygon);
  cell.centroid = cell.inside = centroid_of(cell.polygon);
  if (!is_inside(cell.polygon, cell.inside)) cell.inside = centroid_of(loops.largest[i]);
  cell.is_whole =
      area_of(loops.largest[i]) > (1 - 1e-9) * whole_area && cell.area < (1 + 1e-9) * whole_area;
  return cell;
}

bool is_oblique(const Polygon& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (a.x != b.x && a.z != b.z) return true;
  }
  return false;
}

}  // namespace

CutMesh::CutMesh(const Polygon& outline, const UniformGrid& grid, int processes)
    : outline_(outline),
      grid_(grid),
      index_(static_cast<std::size_t>(grid.columns) * grid.rows, -1) {
  ClippedCells clipped = clip_cells(outline, grid);
  const double whole_area = grid.length / grid.columns * grid.height / grid.rows;
  Loops loops = merged_loops(clipped, least_area * whole_area);
  drop_straight_points(loops.corners, clipped.outline, clipped.points);
  points_ = clipped.points;
  std::vector<CellToOrder> to_order;
  for (std::size_t i = 0; i < loops.places.size(); ++i)
    to_order.push_back({loops.places[i], is_oblique(places_of(loops.corners[i], points_))});
  for (const int i : order_cells(to_order, processes)) {
    cells_.push_back(cell_of(loops, i, points_, whole_area));
    cells_.back().process = to_order[i].process;
  }
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Cell place = cells_[i].place;
    int& index = index_[static_cast<std::size_t>(place.row) * grid.columns + place.column];
    if (index >= 0) refuse_cell(place);  // parts of one cell that are both too large to be merged
    index = static_cast<int>(i);
  }
  find_faces(clipped.outline);
  check_rooms();
  for (int i = 0; i < grid.columns; ++i) {
    std::vector<Polygon> room;
    for (const int cell : column(i)) room.push_back(cells_[cell].polygon);
    fillings_.push_back(Filling(room));
  }
}

void CutMesh::find_faces(const std::vector<OutlineStep>& outline) {
  std::map<Edge, int> cell_beside;
  for (std::size_t i = 0; i < cells_.size(); ++i)
    for (const Edge& edge : edges_of(cells_[i].corners)) cell_beside[edge] = static_cast<int>(i);
  for (const auto& [edge, owner] : cell_beside) {
    const auto beyond = cell_beside.find({edge.second, edge.first});
    if (beyond != cell_beside.end() && owner < beyond->second)
      faces_.push_back({edge.first, edge.second, owner, beyond->second});
  }
  std::stable_sort(faces_.begin(), faces_.end(), [](const InnerFace& a, const InnerFace& b) {
    return std::pair(a.owner, a.neighbour) < std::pair(b.owner, b.neighbour);
  });
  for (const OutlineStep& step : outline) {
    const auto owner = cell_beside.find({step.begin, step.end});
    if (owner == cell_beside.end())
      throw std::invalid_argument("OpenFOAM tank: outline: a part of it has no cell beside it");
    walls_.push_back({step.begin, step.end, owner->second, step.edge, step.along, step.length});
  }
  // Every edge belongs to two cells, or to one and the outline.
  if (2 * faces_.size() + walls_.size() != cell_beside.size())
    throw std::invalid_argument("OpenFOAM tank: outline: the cells beside it leave a gap");
}

// Each room would need a reference pressure and a liquid of its own.
void CutMesh::check_rooms() const {
  std::vector<std::vector<int>> neighbours(cells_.size());
  for (const InnerFace& face : faces_) {
    neighbours[face.owner].push_back(face.neighbour);
    neighbours[face.neighbour].push_back(face.owner);
  }
  std::vector<bool> reached(cells_.size(), false);
  std::vector<int> open{0};
  reached.at(0) = true;
  while (!open.empty()) {
    const int cell = open.back();
    open.pop_back();
    for (const int next : neighbours[cell]) {
      if (reached[next]) continue;
      reached[next] = true;
      open.push_back(next);
    }
  }
  if (std::find(reached.begin(), reached.end(), false) != reached.end())
    throw std::invalid_argument(
        "OpenFOAM tank: outline: it divides the cells into rooms without a connection, expected "
        "one");
}

double CutMesh::perimeter() const { return walls_.back().along + walls_.back().length; }

int CutMesh::index_at(Cell place) const {
  if (place.column < 0 || place.column >= grid_.columns || place.row < 0 || place.row >= grid_.rows)
    return -1;
  return index_[static_cast<std::size_t>(place.row) * grid_.columns + place.column];
}

std::vector<int> CutMesh::column(int column) const {
  std::vector<int> cells;
  for (int row = 0; row < grid_.rows; ++row)
    if (const int index = index_at({column, row}); index >= 0) cells.push_back(index);
  return cells;
}

}  // namespace slosh::openfoam
