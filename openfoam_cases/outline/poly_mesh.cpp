#include "openfoam_cases/outline/poly_mesh.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "openfoam_cases/outline/facing.hpp"

namespace slosh::openfoam {
namespace {

namespace fs = std::filesystem;

// Face by face, in OpenFOAM's order: those inside, then those of each patch.
struct Faces {
  std::vector<std::string> corners;
  std::vector<int> owner, neighbour;  // those inside have a neighbour

  void add(const std::vector<int>& around, int owner_cell) {
    corners.push_back(fmt::format("{}({})", around.size(), fmt::join(around, " ")));
    owner.push_back(owner_cell);
  }
};

// Returns the corners of the face above an edge of the section, whose normal points to the right of
// the edge. Every point of the section is at y = 0, and at y = 1 with the next number.
std::vector<int> upright(int begin, int end) {
  return {2 * begin, 2 * begin + 1, 2 * end + 1, 2 * end};
}

// The faces of the walls by patch.
using Patches = std::map<std::string, std::vector<WallFace>>;

Patches wall_patches(const CutMesh& mesh, bool by_wall) {
  Patches patches;
  for (const WallFace& face : mesh.walls())
    patches[by_wall ? patch_of(mesh, face) : "walls"].push_back(face);
  return patches;
}

// With x to the right and z up, y points away from the viewer, so that the normal of a
// counter-clockwise polygon points to the front.
Faces faces_of(const CutMesh& mesh, const Patches& patches) {
  Faces faces;
  for (const InnerFace& face : mesh.faces()) {
    faces.add(upright(face.begin, face.end), face.owner);
    faces.neighbour.push_back(face.neighbour);
  }
  for (const auto& [name, walls] : patches)
    for (const WallFace& face : walls) faces.add(upright(face.begin, face.end), face.owner);
  for (std::size_t i = 0; i < mesh.cells().size(); ++i) {
    std::vector<int> front, back;
    for (const int corner : mesh.cells()[i].corners) {
      front.push_back(2 * corner);
      back.insert(back.begin(), 2 * corner + 1);
    }
    faces.add(front, static_cast<int>(i));
    faces.add(back, static_cast<int>(i));
  }
  return faces;
}

void write_list(const fs::path& directory, const char* name, const char* type,
                const std::string& note, std::size_t count, const std::string& entries) {
  std::ofstream out(directory / name);
  out << fmt::format(
      "FoamFile {{ version 2.0; format ascii; class {}; {}object {}; }}\n\n{}\n(\n{}\n)\n", type,
      note, name, count, entries);
  if (!out.flush()) throw std::runtime_error("cannot write " + (directory / name).string());
}

std::string patch(const std::string& name, const std::string& type, std::size_t count,
                  std::size_t start) {
  return fmt::format(
      "    {}\n    {{\n        type {};\n        nFaces {};\n        startFace {};\n"
      "    }}",
      name, type, count, start);
}

}  // namespace

void write_decomposition(const CutMesh& mesh, const fs::path& case_directory) {
  std::vector<int> processes;
  for (const CutCell& cell : mesh.cells()) processes.push_back(cell.process);
  write_list(case_directory / "constant", "decomposition", "labelList", "", processes.size(),
             fmt::format("{}", fmt::join(processes, "\n")));
}

void write_poly_mesh(const CutMesh& mesh, Corner origin, bool by_wall,
                     const fs::path& case_directory) {
  const fs::path directory = case_directory / "constant" / "polyMesh";
  fs::create_directories(directory);
  std::vector<std::string> points;
  for (const Corner& point : mesh.points())
    for (const int y : {0, 1})
      points.push_back(fmt::format("({} {} {})", point.x - origin.x, y, point.z - origin.z));
  const Patches walls = wall_patches(mesh, by_wall);
  const Faces faces = faces_of(mesh, walls);
  const std::size_t inside = mesh.faces().size(), cells = mesh.cells().size();
  const std::string note =
      fmt::format("note \"nPoints:{} nCells:{} nFaces:{} nInternalFaces:{}\"; ", points.size(),
                  cells, faces.corners.size(), inside);
  write_list(directory, "points", "vectorField", "", points.size(),
             fmt::format("{}", fmt::join(points, "\n")));
  write_list(directory, "faces", "faceList", "", faces.corners.size(),
             fmt::format("{}", fmt::join(faces.corners, "\n")));
  write_list(directory, "owner", "labelList", note, faces.owner.size(),
             fmt::format("{}", fmt::join(faces.owner, "\n")));
  write_list(directory, "neighbour", "labelList", note, faces.neighbour.size(),
             fmt::format("{}", fmt::join(faces.neighbour, "\n")));
  std::string boundary;
  std::size_t start = inside;
  for (const auto& [name, of_wall] : walls) {
    boundary +=
        patch(name, by_wall ? "wall; inGroups (walls)" : "wall", of_wall.size(), start) + "\n";
    start += of_wall.size();
  }
  write_list(directory, "boundary", "polyBoundaryMesh", "", walls.size() + 1,
             boundary + patch("frontAndBack", "empty", 2 * cells, start));
}

}  // namespace slosh::openfoam
