#include "openfoam_cases/geometry/block_mesh.hpp"

#include <fmt/format.h>

#include <array>
#include <map>

namespace slosh::openfoam {
namespace {

void append(std::string& list, const std::string& separator, const std::string& item) {
  if (!list.empty()) list += separator;
  list += item;
}

// Numbers the blocks' corners in the order in which they are first used. Adjacent blocks share
// corners, and no corner lies inside an obstacle.
class Vertices {
 public:
  explicit Vertices(const TankMesh& mesh) : mesh_(mesh) {}

  int number(int column, int y, int row) {
    const auto [at, is_new] =
        numbers_.try_emplace({column, y, row}, static_cast<int>(numbers_.size()));
    if (is_new) {
      append(text_, at->second % 4 == 0 ? "\n    " : " ",
             fmt::format("({} {} {})", mesh_.face_x(column) - mesh_.origin_x(),
                         y * mesh_.layers().depth(), mesh_.face_z(row) - mesh_.origin_z()));
    }
    return at->second;
  }

  const std::string& text() const { return text_; }

 private:
  const TankMesh& mesh_;
  std::map<std::array<int, 3>, int> numbers_;
  std::string text_;
};

// Returns the corners of a hexahedron in OpenFOAM's order: around the lower face, then the upper
// one.
std::array<int, 8> corners(const Block& block, Vertices& vertices) {
  std::array<int, 8> numbers;
  std::size_t next = 0;
  for (const int row : {block.row_begin, block.row_end}) {
    numbers[next++] = vertices.number(block.column_begin, 0, row);
    numbers[next++] = vertices.number(block.column_end, 0, row);
    numbers[next++] = vertices.number(block.column_end, 1, row);
    numbers[next++] = vertices.number(block.column_begin, 1, row);
  }
  return numbers;
}

using Face = std::array<std::size_t, 4>;  // indices of a hexahedron's corners, normal outward

std::string face(const std::array<int, 8>& corners, const Face& which) {
  return fmt::format("({} {} {} {})", corners[which[0]], corners[which[1]], corners[which[2]],
                     corners[which[3]]);
}

// Returns blockMesh's expansion ratios: a part of growing cells, one of uniform cells, and a part
// of shrinking cells, each with its length and its number of cells.
std::string grading(const CellFaces& faces) {
  const CellFaces::Part end = faces.graded_part();
  if (end.cells == 0) return "1";
  return fmt::format("(({0} {1} {2}) ({3} {4} 1) ({0} {1} {5}))", end.length, end.cells, end.ratio,
                     faces.length() - 2 * end.length, faces.cells() - 2 * end.cells, 1 / end.ratio);
}

struct Side {
  Face face;
  Cell beyond;  // one of the cells on the other side
};

// Returns what a cell that is not free belongs to.
const char* owner(const TankMesh& mesh, Cell cell) {
  if (cell.column < 0) return "left";
  if (cell.column >= mesh.columns()) return "right";
  if (cell.row < 0) return "bottom";
  return cell.row >= mesh.rows() ? "roof" : "obstacles";
}

}  // namespace

BlockMesh block_mesh(const TankMesh& mesh) {
  BlockMesh result;
  Vertices vertices(mesh);
  for (const Block& block : mesh.blocks()) {
    const std::array<int, 8> c = corners(block, vertices);
    result.hexahedra.push_back(
        {fmt::format("{} {} {} {} {} {} {} {}", c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]),
         block.column_end - block.column_begin, block.row_end - block.row_begin,
         grading(mesh.across()), grading(mesh.up())});
    const std::array<Side, 4> sides{{{{0, 4, 7, 3}, {block.column_begin - 1, block.row_begin}},
                                     {{1, 2, 6, 5}, {block.column_end, block.row_begin}},
                                     {{0, 3, 2, 1}, {block.column_begin, block.row_begin - 1}},
                                     {{4, 5, 6, 7}, {block.column_begin, block.row_end}}}};
    for (const Side& side : sides) {
      if (mesh.is_free(side.beyond)) continue;
      append(result.wall_faces, " ", face(c, side.face));
      append(result.faces_of[owner(mesh, side.beyond)], " ", face(c, side.face));
    }
    const std::string front = face(c, {0, 1, 5, 4}), back = face(c, {3, 7, 6, 2});
    if (mesh.layers().is_half_gap()) {
      append(result.wall_faces, " ", front);
      append(result.faces_of["front"], " ", front);
    } else {
      append(result.side_faces, " ", front);
    }
    append(result.side_faces, " ", back);
  }
  result.vertices = vertices.text();
  return result;
}

}  // namespace slosh::openfoam
